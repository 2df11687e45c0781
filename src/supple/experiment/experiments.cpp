#include "supple/experiment/experiments.hpp"

#include <fmt/format.h>

#include <cmath>

#include "supple/core/error.hpp"
#include "supple/experiment/adopt_state.hpp"

namespace supple {

const std::vector<Experiment>& experiments() {
  static const std::vector<Experiment> all{
      {"oscillatory_shear", "G' and G'' of a suspension of crosslinked particles under oscillatory shear",
       derive_oscillatory_shear, run_oscillatory_shear},
      {"preparation", "such a suspension brought to rest, for runs that start from it", derive_preparation,
       run_preparation},
      {"dynamics", "discs moving under a prescribed shear rate, every step recorded; or deformable particles",
       derive_dynamics, run_dynamics},
      {"jamming", "isotropic compression of deformable particles to a jammed packing (9.4)", derive_jamming,
       run_jamming},
      {"compression", "a jammed packing to a list of pressures, and back: P against phi (9.13)", derive_compression,
       run_compression},
      {"uniaxial_compression", "deformable particles squeezed in a box of walls (9.4)", derive_uniaxial_compression,
       run_uniaxial_compression},
      {"slump", "a heap under gravity spreads when a wall is taken away (9.3)", derive_slump, run_slump},
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
  const Case adopted = adopt_state(c, initial);
  check(adopted);
  std::vector<Derived> all = named(adopted.general.experiment).derive(adopted, initial);
  for (const Derived& d : all)
    if (!std::isfinite(d.value))
      throw input_error(fmt::format("{} of this case would be {}", d.name.name, d.value), d.name.meaning,
                        "look for a wrong unit or number");
  return all;
}

void run(const Case& c, const InitialState* initial, Recorder& recorder) {
  const Case adopted = adopt_state(c, initial);
  check(adopted);
  named(adopted.general.experiment).run(adopted, initial, recorder);
}

}  // namespace supple
