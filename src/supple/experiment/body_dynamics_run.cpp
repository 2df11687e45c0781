#include <algorithm>
#include <string>

#include "supple/core/error.hpp"
#include "supple/experiment/body_motion.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/experiment/frame_schedule.hpp"
#include "supple/experiment/key_sets.hpp"
#include "supple/experiment/problems.hpp"
#include "supple/experiment/sheared_bodies.hpp"
#include "supple/experiment/sound_states.hpp"
#include "supple/experiment/suspension.hpp"

namespace supple {

namespace {

/// Rows of the table of a motion, whatever its number of steps.
constexpr std::int64_t rows = 1000;

/// The packing with the velocities that the case asks for.
template <int Dim>
Packing<Dim> moving_packing(const Case& c, const InitialState* initial, const Making& making) {
  Packing<Dim> packing = make_packing<Dim>(c, initial, c.jamming.packing_fraction, making);
  if (c.motion.kinetic_energy > 0 && (!initial || c.is_given("motion.kinetic_energy")))
    draw_velocities(packing.system, c.motion.kinetic_energy, c.general.seed);
  return packing;
}

template <int Dim>
std::vector<Derived> derived_motion(const Case& c, const Packing<Dim>& packing, double time_step) {
  std::vector<Derived> all = derived_packing(packing);
  all.push_back({{"time_step", "", "time step"}, time_step});
  all.push_back({{"steps", "", "steps"}, static_cast<double>(c.time.steps)});
  return all;
}

bool is_sheared(const Case& c) { return c.shear.rate != "0"; }

void check_shear(const Case& c, Problems& problems) {
  if (c.bodies.dimensions == 3 && is_sheared(c))
    add_problem(problems, c, "shear.rate with bodies.dim = 3", "particles are sheared in two dimensions",
                "set shear.rate = \"0\"");
}

template <int Dim>
std::vector<Derived> derive_body_dynamics(const Case& c, const InitialState* initial) {
  if constexpr (Dim == 2)
    if (is_sheared(c)) return derive_sheared_dynamics(c, initial);
  Packing<Dim> packing = moving_packing<Dim>(c, initial, set_apart);
  return derived_motion(c, packing, body_time_step(c, packing, initial, conserving_step));
}

template <int Dim>
void run_body_dynamics(const Case& c, const InitialState* initial, Recorder& recorder) {
  if constexpr (Dim == 2)
    if (is_sheared(c)) return run_sheared_dynamics(c, initial, recorder);
  Packing<Dim> packing = moving_packing<Dim>(c, initial, at_random(recorder));
  System<Dim>& s = packing.system;
  start_clock(s, c, recorder);
  double dt = body_time_step(c, packing, initial, conserving_step);
  std::int64_t step = 0;
  LastGood<Dim> good(packing);
  const Keep keep = [&](Keeper& k) {
    k("packing", packing);
    k("good", good);
    k("dt", dt);
    k("step", step);
  };
  restore(recorder, keep);
  Mover dynamics(*packing.field, c.motion.damping);
  dynamics.set_plasticity(plastic_law(c));
  begin_packing(packing, derived_motion(c, packing, dt), recorder);
  recorder.value(protocol_group, {"dt", "", "time step; a continuation takes it over"}, dt);
  recorder.declare("motion", motion_columns(packing));
  const std::int64_t steps = c.time.steps, per_row = std::max<std::int64_t>(1, steps / rows);
  FrameSchedule frames(steps, c.output.frames);
  frames.skip_to(step);
  const Surroundings surroundings =
      environment_of(packing).is_closed() ? Surroundings::closed : Surroundings::open;
  try {
    for (; step < steps; ++step) {
      recorder.safe_point(keep, "at step", step);
      const bool keeps_frame = frames.due(step);
      if (keeps_frame || step % look_interval(steps) == 0) good.look();
      if (step % per_row == 0) recorder.append("motion", motion_row(packing, dynamics.evaluate_energies(s)));
      if (keeps_frame) recorder.frame(packing_frame(packing, report_packing(packing), surroundings));
      dynamics.advance(s, dt);
      if (step % 256 == 0) recorder.progress("dynamics", step, steps);
    }
    good.look();
  } catch (const Error&) {
    hand_over(packing, recorder);
    throw;
  }
  recorder.progress("dynamics", steps, steps);
  recorder.append("motion", motion_row(packing, dynamics.evaluate_energies(s)));
  record_packing(packing, JamProgress<Dim>{}, recorder, surroundings);
}

}  // namespace

Experiment body_dynamics() {
  return {
      .name = "dynamics",
      .meaning = "deformable particles in motion, in 2D sheared where shear.rate says so",
      .matter = &body_matter(),
      .keys = with(with(moving_keys(), rubbing_keys()),
                   {"jamming.packing_fraction", "motion.kinetic_energy", "time.steps", "initial.keep_time",
                    "shear.rate", "shear.cool_factor", "shear.relative_frequency", "output.tensors"}),
      .needs =
          {{"motion.damping motion.kinetic_energy bodies.yield_strain bodies.flow_time", Need::Of::value,
            [](const Case& c) { return !is_sheared(c); },
            "shear.rate = \"0\": sheared particles lose their motion by shear.cool_factor"},
           {"shear.cool_factor shear.relative_frequency output.tensors box.plates particles.permanent_links "
            "particles.cut particles.cut_lines particles.edge_fuzziness "
            "particles.avoid_horizontal_angle_degree particles.avoid_height_spanning_particles "
            "particles.max_cut_tries particles.remove_link_fraction material.friction contact.A.B.friction "
            "contact.A.B.relative_viscosity "
            "material.relative_viscosity material.relative_transversal_link_strength "
            "material.interface_reenforcement_central material.interface_reenforcement_tangential "
            "material.keep_viscosity_coefficients_constant material.slip",
            Need::Of::value, is_sheared,
            "shear.rate: particles rub, and may be linked, where the cell is sheared"},
           {"contact.k_p contact.floor_friction", Need::Of::start, [](const Case&) { return false; },
            "walls: dynamics has those of the file that it starts from"}},
      .derive = {derive_body_dynamics<2>, derive_body_dynamics<3>},
      .run = {run_body_dynamics<2>, run_body_dynamics<3>},
      .figure = [](const Case& c) { return c.time.steps > 0 ? Figure::motion : Figure::none; },
      .first_keys = {"experiment", "physics", "seed", "bodies.family", "bodies.N", "jamming.packing_fraction",
                     "motion.kinetic_energy", "time.steps"},
      .set_first =
          [](Case& c) {
            c.time.steps = 1000;
            c.jamming.packing_fraction = 0.6;
            c.motion.kinetic_energy = 1e-5;
          },
      .check = check_shear,
      .keeps_step = true};
}

}  // namespace supple
