/// G' and G'' of a suspension, without any file:  moduli [CASE.toml]
#include <cstdio>

#include "supple/core/error.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/io/text/case_file.hpp"

/// What an experiment tells. A MemoryRecorder keeps tables, frames and results; this one shows progress, too.
class Shown : public supple::MemoryRecorder {
 public:
  void progress(const std::string& phase, std::int64_t done, std::int64_t total) override {
    if (phase == phase_) return;
    phase_ = phase;
    std::fprintf(stderr, "%s: %lld of %lld\n", phase.c_str(), static_cast<long long>(done),
                 static_cast<long long>(total));
  }
  void warning(const std::string& text) override { std::fprintf(stderr, "warning: %s\n", text.c_str()); }
  // bool stop_requested() override;   // true: the experiment stops, and throws `interrupted`

 private:
  std::string phase_;
};

/// A case from scratch: what is not set has its default (docs/parameters.md).
supple::Case small_suspension() {
  supple::Case c;
  c.general.seed = 7;
  c.general.threads = 2;  // results do not depend on it
  c.particles.discs = 45;
  c.shear.amplitude = 0.2;
  c.shear.relative_frequency = 0.1;
  c.shear.pre_periods = 0.5;
  c.shear.periods = 3;
  return c;
}

int main(int argc, char** argv) {
  try {
    const supple::Case c = argc > 1 ? supple::read_case(argv[1]) : small_suspension();
    Shown recorder;
    supple::run(c, nullptr, recorder);  // nullptr: the sample is made, not read

    for (const auto& [name, value, error] : recorder.values["results"])
      if (name.name.find("_modulus_") != std::string::npos)
        std::printf("%-36s %.17g +- %.2g %s\n", name.name.c_str(), value, error, name.unit.c_str());
    const auto& stress = recorder.tables.at("stress");
    std::printf("%zu rows of %zu columns, %zu frames\n", stress.rows.size(), stress.columns.size(),
                recorder.frames.size());
  } catch (const supple::Error& e) {  // what is wrong, why, and what to do
    std::fprintf(stderr, "%s\n", e.what());
    return e.exit_code();
  }
}
