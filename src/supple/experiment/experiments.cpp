#include "supple/experiment/experiments.hpp"

#include "supple/core/error.hpp"

namespace supple {

const std::vector<Experiment>& experiments() {
  static const std::vector<Experiment> all{
      {"oscillatory_shear", "G' and G'' of a suspension of crosslinked particles under oscillatory shear",
       derive_oscillatory_shear, run_oscillatory_shear},
      {"dynamics", "discs moving under a prescribed shear rate, every step recorded", derive_dynamics, run_dynamics},
  };
  return all;
}

namespace {

const Experiment& named(const std::string& name) {
  for (const Experiment& e : experiments())
    if (e.name == name) return e;
  throw input_error("no experiment '" + name + "'");
}

}  // namespace

std::vector<Derived> derive(const Case& c, const InitialState* initial) {
  check(c);
  return named(c.general.experiment).derive(c, initial);
}

void run(const Case& c, const InitialState* initial, Recorder& recorder) {
  check(c);
  named(c.general.experiment).run(c, initial, recorder);
}

}  // namespace supple
