#include "supple/experiment/experiments.hpp"

#include <fmt/format.h>

#include <cmath>

#include "supple/core/error.hpp"
#include "supple/experiment/adopt_state.hpp"

namespace supple {

namespace {

/// `common`, then `more`.
UsedKeys with(UsedKeys common, const UsedKeys& more) {
  common.insert(common.end(), more.begin(), more.end());
  return common;
}

}  // namespace

const std::vector<Experiment>& experiments() {
  // Every experiment draws random numbers, and leaves a run and pictures of its cell.
  static const UsedKeys every{
      "experiment",          "physics",        "seed", "threads", "output.file", "output.images",
      "output.image_format", "output.snapshot"};
  static const UsedKeys discs = with(every, {"material.*", "particles.*", "box.*", "preparation.*"});
  static const UsedKeys bodies =
      with(every, {"bodies.*", "-bodies.yield_strain", "-bodies.flow_time", "contact.kind", "contact.k_c",
                   "contact.unsound", "initial.state", "initial.packing", "output.plot"});
  static const UsedKeys minimised = with(bodies, {"minimise.*"});
  static const UsedKeys moving = with(
      bodies, {"bodies.*", "contact.*", "time.step", "time.step_factor", "motion.damping", "output.frames"});
  // Particles that rub and are linked, by the keys of crosslinked discs.
  static const UsedKeys rubbing{"particles.*",
                                "-particles.N",
                                "-particles.packing_fraction",
                                "-particles.bimodal_factor",
                                "-particles.cut_top_bottom",
                                "material.friction",
                                "material.relative_viscosity",
                                "material.relative_transversal_link_strength",
                                "material.interface_reenforcement_central",
                                "material.interface_reenforcement_tangential",
                                "material.keep_viscosity_coefficients_constant",
                                "material.slip"};
  static const UsedKeys sheared =
      with(with(minimised, rubbing),
           {"jamming.*", "shear.*", "-shear.rate", "time.step", "time.step_factor", "output.*",
            "-output.energies", "-output.relative_y_scale_force", "-output.text"});
  static const std::vector<Experiment> all{
      {"oscillatory_shear",
       "G' and G'' of a suspension of crosslinked particles under oscillatory shear; discs, or deformable "
       "particles",
       with(discs, {"shear.*", "-shear.rate", "time.step", "time.step_factor", "initial.state", "output.*"}),
       sheared, derive_oscillatory_shear, run_oscillatory_shear},
      {"preparation",
       "such a suspension brought to rest, for runs that start from it",
       with(discs, {"shear.amplitude", "shear.relative_frequency", "shear.cool_factor", "time.step",
                    "time.step_factor"}),
       {},
       derive_preparation,
       run_preparation,
       "oscillatory_shear"},
      {"dynamics", "discs moving under a prescribed shear rate, every step recorded; or deformable particles",
       with(discs, {"shear.amplitude", "shear.relative_frequency", "shear.cool_factor", "shear.rate",
                    "time.*", "initial.state", "initial.keep_time", "output.tensors", "output.energies",
                    "output.frames", "output.plot"}),
       with(with(moving, rubbing),
            {"jamming.packing_fraction", "motion.kinetic_energy", "time.steps", "initial.keep_time",
             "shear.rate", "shear.cool_factor", "shear.relative_frequency", "output.tensors"}),
       derive_dynamics, run_dynamics},
      {"jamming",
       "isotropic compression of deformable particles to a jammed packing (9.4)",
       {},
       with(minimised, {"jamming.*"}),
       derive_jamming,
       run_jamming},
      {"compression",
       "a jammed packing to a list of pressures, and back: P against phi (9.13)",
       {},
       with(minimised, {"jamming.*", "compression.*"}),
       derive_compression,
       run_compression},
      {"uniaxial_compression",
       "deformable particles squeezed in a box of walls (9.4)",
       {},
       with(minimised, {"contact.k_p", "uniaxial.*", "output.frames"}),
       derive_uniaxial_compression,
       run_uniaxial_compression},
      {"slump",
       "a heap under gravity spreads when a wall is taken away (9.3)",
       {},
       with(moving, {"slump.*"}),
       derive_slump,
       run_slump},
  };
  return all;
}

const Experiment& experiment_of(const Case& c) {
  for (const Experiment& e : experiments())
    if (e.name == c.general.experiment) return e;
  throw input_error("no experiment '" + c.general.experiment + "'");
}

std::vector<Derived> derive(const Case& c, const InitialState* initial) {
  const Case adopted = adopt_state(c, initial);
  check(adopted, initial);
  std::vector<Derived> all = experiment_of(adopted).derive(adopted, initial);
  for (const Derived& d : all)
    if (!std::isfinite(d.value))
      throw input_error(fmt::format("{} of this case would be {}", d.name.name, d.value), d.name.meaning,
                        "look for a wrong unit or number");
  return all;
}

void run(const Case& c, const InitialState* initial, Recorder& recorder) {
  const Case adopted = adopt_state(c, initial);
  check(adopted, initial);
  experiment_of(adopted).run(adopted, initial, recorder);
}

}  // namespace supple
