#include "supple/experiment/key_sets.hpp"

namespace supple {

namespace {

/// Every experiment draws random numbers, and leaves a run and pictures of its cell.
UsedKeys every() {
  return {"experiment",          "physics",        "seed", "threads", "output.file", "output.images",
          "output.image_format", "output.snapshot"};
}

}  // namespace

UsedKeys disc_keys() { return with(every(), {"material.*", "particles.*", "box.*", "preparation.*"}); }

UsedKeys body_keys() {
  return with(every(), {"bodies.*", "species.*", "-bodies.yield_strain", "-bodies.flow_time", "contact.kind",
                        "contact.law", "contact.attraction_range", "contact.k_c", "contact.unsound",
                        "contact.A.B.law", "contact.A.B.attraction_range", "contact.A.B.k_c", "initial.state",
                        "initial.packing", "output.plot"});
}

UsedKeys minimised_keys() { return with(body_keys(), {"minimise.*"}); }

UsedKeys moving_keys() {
  return with(body_keys(),
              {"bodies.*", "contact.*", "time.step", "time.step_factor", "motion.damping", "output.frames"});
}

UsedKeys rubbing_keys() {
  return {"particles.*",
          "-particles.N",
          "-particles.packing_fraction",
          "-particles.bimodal_factor",
          "-particles.cut_top_bottom",
          "box.plates",
          "material.friction",
          "material.relative_viscosity",
          "contact.A.B.friction",
          "contact.A.B.relative_viscosity",
          "material.relative_transversal_link_strength",
          "material.interface_reenforcement_central",
          "material.interface_reenforcement_tangential",
          "material.keep_viscosity_coefficients_constant",
          "material.slip"};
}

bool starts_from_file(const Case& c) { return !c.initial.state.empty() || !c.initial.packing.empty(); }

}  // namespace supple
