/// G' and G'' of stiff smooth polygons of 60 vertices, and of discs of their outline and the law that follows
/// from it. outline POLYGONS DISCS OUT [SEEDS] writes OUT/outline.png and prints the table of the README.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "supple/draw/chart/chart.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/io/text/case_file.hpp"

namespace {

using namespace supple;

struct Modulus {
  std::vector<double> of_seeds;
  double mean() const {
    double sum = 0;
    for (const double x : of_seeds) sum += x;
    return sum / static_cast<double>(of_seeds.size());
  }
  /// Of one seed.
  double scatter() const {
    double sum = 0;
    for (const double x : of_seeds) sum += (x - mean()) * (x - mean());
    return std::sqrt(sum / static_cast<double>(of_seeds.size() - 1));
  }
};

struct Moduli {
  Modulus storage, loss;
  double worst_residual = 0;
};

/// All seeds, in units of `spring`.
Moduli measure(const std::string& path, double spring, int seeds) {
  Case c = read_case(path);
  resolve_family(c);
  Moduli m;
  for (int seed = 1; seed <= seeds; ++seed) {
    c.general.seed = seed;
    MemoryRecorder r;
    supple::run(c, nullptr, r);
    for (const std::string& warning : r.warnings) fmt::print(stderr, "seed {}: {}\n", seed, warning);
    const double unit = r.get("constants", "pressure_unit") / spring;
    m.storage.of_seeds.push_back(unit * r.get("results", "storage_modulus_total"));
    m.loss.of_seeds.push_back(unit * r.get("results", "loss_modulus_total"));
    m.worst_residual = std::max(m.worst_residual, r.get("results", "energy_residual"));
  }
  return m;
}

ChartSeries series_of(const char* label, Color color, const Modulus& modulus) {
  ChartSeries s;
  s.label = label;
  s.color = color;
  for (std::size_t k = 0; k < modulus.of_seeds.size(); ++k) {
    s.x.push_back(static_cast<double>(k + 1));
    s.y.push_back(modulus.of_seeds[k]);
  }
  return s;
}

int run(const std::string& polygons, const std::string& discs, const std::string& out, int seeds) {
  const double spring = read_case(discs).contact.k_c;
  fmt::print("| particles | G' [k] | G'' [k] | worst energy residual |\n|---|---|---|---|\n");
  ChartPanel storage{{"Seed", ""}, {"G\u2032", "k"}, {}}, loss{{"Seed", ""}, {"G\u2033", "k"}, {}};
  storage.y.range = {0, 0.6};
  loss.y.range = {0, 0.3};
  const auto add = [&](const char* name, const std::string& path, Color color) {
    const Moduli m = measure(path, spring, seeds);
    fmt::print("| {} | {:.3f} ± {:.3f} | {:.3f} ± {:.3f} | {:.1e} |\n", name, m.storage.mean(),
               m.storage.scatter(), m.loss.mean(), m.loss.scatter(), m.worst_residual);
    std::fflush(stdout);
    storage.series.push_back(series_of(name, color, m.storage));
    loss.series.push_back(series_of(name, color, m.loss));
  };
  add("polygons", polygons, hex(0x1B4F82));
  add("discs", discs, hex(0xE59A77));
  draw_chart(out + "/outline.png", {{{{storage}, 1}, {{loss}, 1}}});
  return 0;
}

}  // namespace

int main(int count, char** words) {
  try {
    if (count == 4 || count == 5)
      return run(words[1], words[2], words[3], count == 5 ? std::atoi(words[4]) : 10);
    fmt::print(stderr, "usage: outline POLYGONS DISCS OUT [SEEDS]\n");
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "outline: {}\n", error.what());
    return 1;
  }
}
