/// Suspensions of crosslinked, frictional, viscoelastic discs as documented (physics sections 1 to 7).
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "supple/core/whole_number.hpp"
#include "supple/experiment/microgel.hpp"
#include "supple/experiment/moduli.hpp"
#include "supple/experiment/relaxation.hpp"
#include "supple/experiment/suspension.hpp"
#include "supple/model/discs.hpp"
#include "supple/model/sanity.hpp"

namespace supple {

namespace {

std::vector<Derived> constants(const Case& c, const InitialState* initial) {
  return derived_constants(derive_constants(c, initial));
}

double time_step(const Case& c, const InitialState* initial) {
  return derive_constants(c, initial).time_step;
}

ShearProtocol protocol_of(const Case& c, const InitialState* initial) {
  const MicrogelConstants k = derive_constants(c, initial);
  const OscillatoryProtocol p = oscillatory_protocol(c, initial, k.frequency, k.time_step);
  return {windows_of(p),
          fit_harmonics,
          p.steps(),
          p.steps() + 1,
          p.time_step(),
          std::pow(c.shear.cool_factor, p.periods(1)),
          [p](std::int64_t step, double) { return p.rates(step); }};
}

/// Of the suspension that is to be made, or of the state.
Gap expected_gap(const Case& c, const InitialState* initial, const MicrogelConstants& k) {
  if (initial) return gap_of(system_of<2>(*initial), initial->units);
  return {c.box.height, c.particles.discs * k.mean_mass / (c.box.width * c.box.height)};
}

/// Shear modulus of a triangular lattice of links with springs k and k_t, sqrt(3)/4 (k + k_t): scaffolds,
/// whose discs are in disorder, are softer (0.76 k for 0.87 k with the default laws).
double scaffold_modulus(const MicrogelConstants& k) {
  return 0.25 * std::numbers::sqrt3 * (k.law.link.k + k.law.link.k_t);
}

std::vector<Derived> consequences(const Case& c, const InitialState* initial, const ShearProtocol& p) {
  const MicrogelConstants k = derive_constants(c, initial);
  return {{{"wavelength_over_gap_of_scaffold", "",
            "shear wave of a crosslinked scaffold over the gap; softer samples have shorter waves"},
           expected_gap(c, initial, k).wavelengths(scaffold_modulus(k), p.windows.frequency)}};
}

/// Shear stress to expect at a strain of 20 %, E/100: between free discs (E/200) and a bulk scaffold (E/25).
/// It is no function of the protocol, so that one seed is one sample.
double typical_stress(const Case& c) { return c.material.young_modulus / 100; }

/// A part of the preparation: what is done first, then a relaxation.
struct Stage {
  const char* phase;
  Plates plates;
  double friction;
  std::function<void()> enter;
};

void prepare_documented(Suspension& s, Mover<2>& dynamics, const Case& c, const MicrogelConstants& k,
                        Recorder& recorder) {
  recorder.declare("preparation",
                   {{"steps", "", "steps of this relaxation"}, {"spread", "Pa", "variation of the stress"}});
  RelaxationSpec spec;
  spec.time_step = k.relaxation_step;
  spec.tolerance = c.preparation.stress_tolerance * typical_stress(c);
  const double steps = std::min(c.preparation.max_time * k.tau / spec.time_step, most_counted);
  spec.most_steps = std::max<std::int64_t>(
      1000, whole_number(steps, "steps of the preparation", "lower preparation.max_time"));
  const auto link = [&] {
    dynamics.evaluate(s.system, {});
    const CrosslinkReport report =
        crosslink(s.system, crosslink_spec(c), static_cast<std::uint64_t>(c.general.seed));
    if (c.particles.remove_link_fraction > 0)
      recorder.value("constants", {"removed_link_fraction", "", "links removed at random"},
                     report.removed_fraction);
    dynamics.invalidate();
  };
  const bool walls = !s.system.box.periodic[flow];
  const auto capture = [&] {
    if (!walls) remove_drift(s.system);
    capture_at_boundaries(s.system, plates_of(c));
  };
  // Discs are pushed off the walls of a cell that has them, and fixed to those only when they are at rest.
  const Plates pushed = walls ? Plates::repulsive : Plates::none;
  const double friction = dynamics.friction();
  std::vector<Stage> stages{{"relax without friction", pushed, 0, [] {}},
                            {"relax with friction", pushed, friction, [] {}}};
  if (c.particles.permanent_links) stages.push_back({"relax crosslinked particles", pushed, friction, link});
  stages.push_back({"relax between plates", plates_of(c), friction, capture});

  int stage = 0;
  bool entered = false;
  RelaxationState relaxation;
  const Keep keep = in_part(preparation_part, [&](Keeper& kept) {
    kept("stage", stage);
    kept("entered", entered);
    kept("relaxation", relaxation);
    kept("system", s.system);
  });
  restore(recorder, keep, preparation_part);
  for (; stage < static_cast<int>(stages.size()); ++stage, entered = false, relaxation = {}) {
    const Stage& now = stages[static_cast<std::size_t>(stage)];
    dynamics.set_plates(now.plates);
    dynamics.set_friction(now.friction);
    if (!std::exchange(entered, true)) now.enter();
    relax(s.system, dynamics, s.units, spec, stage == 0, now.phase, relaxation, keep, recorder);
  }
}

Suspension make(const Case& c, const InitialState* initial, Recorder& recorder) {
  const MicrogelConstants k = derive_constants(c, initial);
  Suspension s;
  s.time_step = k.time_step;
  s.damping = std::pow(c.shear.cool_factor, k.time_step * k.frequency);
  s.material = k.material;
  auto dynamics = make_dynamics(c, k);
  Mover<2>& stepper = *dynamics;
  s.stepper = std::move(dynamics);
  if (initial) {
    take_state(s, c, *initial, 1);
    return s;
  }
  if (resumed_part(recorder) == sheared_part) {
    stepper.set_plates(plates_of(c));
    return s;
  }
  const DiscSpec spec{c.particles.discs, c.particles.packing_fraction, c.particles.bimodal_factor,
                      c.material.density};
  s.system = random_discs(make_box(c, s.units), spec, static_cast<std::uint64_t>(c.general.seed));
  require_sane(s.system, "this suspension");
  prepare_documented(s, stepper, c, k, recorder);
  s.system.time = 0;
  s.system.step = 0;
  return s;
}

}  // namespace

const SuspensionModel& documented_model() {
  static const SuspensionModel model{constants, time_step, protocol_of, consequences, make};
  return model;
}

}  // namespace supple
