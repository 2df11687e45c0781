#include "supple/experiment/suspension.hpp"

#include <cmath>
#include <numbers>

#include "supple/core/error.hpp"
#include "supple/core/whole_number.hpp"
#include "supple/experiment/frame.hpp"
#include "supple/experiment/microgel.hpp"
#include "supple/experiment/particleshear_protocol.hpp"
#include "supple/experiment/relaxation.hpp"
#include "supple/model/convert.hpp"
#include "supple/model/discs.hpp"
#include "supple/model/sanity.hpp"
#include "supple/observe/body_stress.hpp"
#include "supple/observe/energy_balance.hpp"
#include "supple/observe/stress.hpp"

namespace supple {

Box<2> make_box(const Case& c, const Units& units) {
  Box<2> box;
  const double per_metre = 1 / units.length;  // a power of ten: 500 um stay 500 exactly
  box.length = {c.box.width * per_metre, c.box.height * per_metre};
  if (c.box.boundary == "fixed") box.periodic = {false, false};
  return box;
}

CrosslinkSpec crosslink_spec(const Case& c) {
  const Particles& p = c.particles;
  return {p.cut == "lines" ? CutKind::lines : CutKind::voronoi,
          p.cut_lines,
          p.edge_fuzziness,
          p.avoid_horizontal_angle_degree * std::numbers::pi / 180,
          p.avoid_height_spanning_particles,
          p.max_cut_tries,
          p.cut_top_bottom,
          p.remove_link_fraction,
          is_package(c) ? IsolatedJoin::last : IsolatedJoin::before_height_check};
}

namespace {

/// Shear stress to expect at a strain of 20 %, E/100: between free discs (E/200) and a bulk scaffold (E/25).
/// It is no function of the protocol, so that one seed is one sample.
double typical_stress(const Case& c) { return c.material.young_modulus / 100; }

/// From a state file: contacts remember; boundary and plates are those of the case, which has adopted the
/// state's.
void take_state(Suspension& s, const Case& c, const InitialState& initial) {
  s.system = initial.system;
  convert(s.system, initial.units, s.units);
  set_history_width(s.system.pairs, is_package(c) ? 2 : 1);
  if (c.is_given("box.boundary")) s.system.box.periodic = make_box(c, s.units).periodic;
  const Plates kind = plates_of(c);
  s.stepper->set_plates(kind);
  if (kind == Plates::capture) return capture_at_boundaries(s.system, kind);
  for (Mobility& m : s.system.state.mobility)
    if (m == Mobility::lower_plate || m == Mobility::upper_plate) m = Mobility::free;
}

void prepare_documented(Suspension& s, DiscDynamics& dynamics, const Case& c, const MicrogelConstants& k,
                        Recorder& recorder) {
  recorder.declare("preparation",
                   {{"steps", "", "steps of this relaxation"}, {"spread", "Pa", "variation of the stress"}});
  RelaxationSpec spec;
  spec.time_step = k.relaxation_step;
  spec.tolerance = c.preparation.stress_tolerance * typical_stress(c);
  const double steps = std::min(c.preparation.max_time * k.tau / spec.time_step, most_counted);
  spec.most_steps = std::max<std::int64_t>(
      1000, whole_number(steps, "steps of the preparation", "lower preparation.max_time"));
  const auto relax_until_still = [&](const char* phase, bool rough) {
    relax(s.system, dynamics, s.units, spec, rough, phase, recorder);
  };

  // Discs are pushed off the walls of a cell that has them, and fixed to those only when they are at rest.
  const bool walls = !s.system.box.periodic[flow];
  dynamics.set_plates(walls ? Plates::repulsive : Plates::none);
  const double friction = dynamics.friction();
  dynamics.set_friction(0);
  relax_until_still("relax without friction", true);
  dynamics.set_friction(friction);
  relax_until_still("relax with friction", false);
  if (c.particles.permanent_links) {
    dynamics.evaluate(s.system, {});
    const CrosslinkReport report =
        crosslink(s.system, crosslink_spec(c), static_cast<std::uint64_t>(c.general.seed));
    if (c.particles.remove_link_fraction > 0)
      recorder.value("constants", {"removed_link_fraction", "", "links removed at random"},
                     report.removed_fraction);
    dynamics.invalidate();
    relax_until_still("relax crosslinked particles", false);
  }
  if (!walls) remove_drift(s.system);
  dynamics.set_plates(plates_of(c));
  capture_at_boundaries(s.system, plates_of(c));
  relax_until_still("relax between plates", false);
}

Suspension make_documented(const Case& c, const InitialState* initial, Recorder& recorder) {
  const MicrogelConstants k = derive_constants(c, initial);
  Suspension s;
  s.time_step = k.time_step;
  s.damping = std::pow(c.shear.cool_factor, k.time_step * k.frequency);
  s.material = k.material;
  auto dynamics = make_dynamics(c, k);
  DiscDynamics& stepper = *dynamics;
  s.stepper = std::move(dynamics);
  if (initial) {
    take_state(s, c, *initial);
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

MaterialConstants material_of(const ParticleShearConstants& p) {
  return {p.k,
          p.nu,
          p.k_t,
          p.nu_t,
          p.mu,
          p.central_repulsion_coefficient,
          p.permanent_ratio_central,
          p.permanent_ratio_tangential,
          p.keep_viscosity_coefficients_constant};
}

Suspension make_package(const Case& c, const InitialState* initial, Recorder& recorder) {
  const ParticleShearRun run = derive_particleshear(c, initial);
  const bool reset = !initial || initial->reset_force_each_step;
  auto stepper = std::make_unique<ParticleShearStepper>(run.constants,
                                                        reset ? PlateForce::reset : PlateForce::accumulate);
  ParticleShearStepper& package = *stepper;
  Suspension s{particleshear_units(),     {}, std::move(stepper), run.dt, run.damping,
               material_of(run.constants)};
  if (initial) {
    take_state(s, c, *initial);
    return s;
  }
  s.system = prepare_particleshear(c, run, package, [&](std::int64_t done, std::int64_t total) {
    if (done % 256 == 0) recorder.progress("prepare as the package does", done, total);
    if (recorder.stop_requested()) throw Error(ErrorKind::interrupted, "interrupted while preparing");
  });
  return s;
}

}  // namespace

namespace {

/// Of free discs and of all spins, with the velocities that the frame gives: the flow has the rate of this
/// instant.
double kinetic_energy_of(const Frame& frame, const State<2>& s) {
  double sum = 0;
  for (std::size_t i = 0; i < frame.velocity.size(); ++i) {
    if (frame.mobility[i] == Mobility::free)
      sum += 0.5 * s.mass[i] * dot(frame.velocity[i], frame.velocity[i]);
    sum += 0.5 * s.inertia[i] * frame.spin[i] * frame.spin[i];
  }
  return sum;
}

/// Energies by term, and the stress of all contacts: (1/A) sum F l^T.
void add_numbers(Frame& frame, const Suspension& s, const Evaluation<2>& evaluation) {
  const Mat2 contact = stress_tensors(s.system, evaluation).virial;
  frame.numbers["pressure"] = pressure(contact);
  add_tensor(frame.numbers, "contact_stress", contact);
  if (!s.stepper->has_energies()) return;
  const EnergyState e = energy_state(s.system, evaluation);
  frame.numbers["kinetic_energy"] = kinetic_energy_of(frame, s.system.state);
  frame.numbers["contact_energy"] = e.elastic;
  frame.numbers["tangential_energy"] = e.tangential;
  frame.numbers["wall_energy"] = e.wall;
}

}  // namespace

Frame frame_of(const Suspension& s, const Evaluation<2>& evaluation, ShearRates rates) {
  Frame frame = make_frame(s.system, evaluation);
  s.stepper->bring_to_instant(s.system, rates.now, frame.velocity, frame.spin);
  frame.strain_rate = rates.now;
  add_numbers(frame, s, evaluation);
  return frame;
}

void start_clock(System<2>& system, const Case& c) {
  if (c.initial.keep_time) return;
  system.time = 0;
  system.step = 0;
}

void record_constants(const Suspension& s, const InitialState* initial, const std::vector<Derived>& derived,
                      Recorder& recorder) {
  for (const Derived& d : derived) recorder.value("constants", d.name, d.value);
  for_each_constant(s.material, [&](const char* name, const auto& constant) {
    if (constant)
      recorder.value(material_group, {name, "", "constant of the contact law, in the units of the run"},
                     *constant);
  });
  const auto take_over = [&](const char* name, const char* meaning, double value) {
    recorder.value(protocol_group, {name, "", meaning}, value);
  };
  take_over("dt", "time step, in the units of the run", s.time_step);
  take_over("cool_factor", "factor per step on velocity relative to the flow", s.damping);
  take_over("reset_force_each_step", "0: forces on discs of the plates pile up, as in the package",
            !initial || initial->reset_force_each_step);
}

Suspension make_suspension(const Case& c, const InitialState* initial, Recorder& recorder) {
  Suspension s = is_package(c) ? make_package(c, initial, recorder) : make_documented(c, initial, recorder);
  require_sane(s.system, "this suspension");
  return s;
}

}  // namespace supple
