#include "supple/compat/particleshear/step.hpp"

#include <fmt/core.h>

#include <cmath>

#include "supple/core/error.hpp"
#include "supple/model/row_separation.hpp"
#include "supple/solve/mover.hpp"

namespace supple {
namespace {

/// The plates hold every disc that touches y = 0 or y = Ly now. It cannot leave: they let it move along only.
void hold_by_plates(System<2>& system, Plates plates) {
  State<2>& s = system.state;
  const double height = system.box.length[gradient];
  for (int i = 0; i < s.size(); ++i) {
    const double y = s.position[i][gradient], r = s.radius[i];
    const bool moves = plates == Plates::none || (r < y && y < height - r);
    s.mobility[i] = moves ? Mobility::free : y > 0.5 * height ? Mobility::upper_plate : Mobility::lower_plate;
  }
}

/// Velocity relative to the flow, and spin (relative to nothing), times `factor`; plate discs too.
void cool(System<2>& system, double factor) {
  State<2>& s = system.state;
  for (int i = 0; i < s.size(); ++i) {
    const Vec2 u = system.box.flow_velocity(s.position[i]);
    s.velocity[i] = u + factor * (s.velocity[i] - u);
    s.spin[i] *= factor;
  }
}

void move(System<2>& system, double dt) {
  State<2>& s = system.state;
  system.box.strain += system.box.strain_rate * dt;
  double finite = 0;  // becomes NaN with the first value that is not finite
  for (int i = 0; i < s.size(); ++i) {
    s.angle[i] += s.spin[i] * dt;
    s.position[i] += dt * s.velocity[i];
    wrap_site(system, i);
    finite += 0 * (s.position[i][0] + s.position[i][1] + s.angle[i]);
  }
  if (finite == 0) return;
  for (int i = 0; i < s.size(); ++i)
    if (!std::isfinite(s.position[i][0] + s.position[i][1] + s.angle[i]))
      throw numerics_error(fmt::format("disc {} is not finite at step {}", i, system.step + 1),
                           "the time step may be too large or the law too stiff", "reduce [time] time_step");
}

}  // namespace

void ParticleShearStepper::set_plates(Plates plates) {
  if (plates == Plates::repulsive)
    throw input_error("plates = \"repulsive\" with physics = \"particleshear-1.0.2\"",
                      "the package's plates capture discs",
                      "use \"capture\" or \"none\", or physics = \"documented\"");
  plates_ = plates;
}

void ParticleShearStepper::update_neighbors(System<2>& system) {
  if (system.pairs.width != 2) set_history_width(system.pairs, 2);
  neighbors_.update(system);
}

const Evaluation<2>& ParticleShearStepper::evaluate(System<2>& system, ShearRates rates) {
  if (!system.box.periodic[flow] || !system.box.periodic[gradient])
    throw input_error("a cell that is not periodic with physics = \"particleshear-1.0.2\"",
                      "the package has none", "use boundary = \"lees_edwards\", or physics = \"documented\"");
  set_strain_rate(system, rates.now);
  hold_by_plates(system, plates_);
  update_neighbors(system);
  const auto discs = system.state.position.size();
  carried_force_.resize(discs);
  evaluation_.force = carried_force_;
  evaluation_.torque.assign(discs, 0.0);
  contacts_.evaluate(system, constants_, evaluation_);
  return evaluation_;
}

void ParticleShearStepper::accelerate(System<2>& system, double dt) {
  State<2>& s = system.state;
  const double plate_speed = 0.5 * system.box.strain_rate * system.box.length[gradient];
  for (int i = 0; i < s.size(); ++i) {
    const Vec2 force = evaluation_.force[i];
    const bool moves = s.mobility[i] == Mobility::free;
    if (moves) s.velocity[i] += (dt / s.mass[i]) * force;
    else s.velocity[i] = {s.mobility[i] == Mobility::upper_plate ? plate_speed : -plate_speed, 0};
    s.spin[i] += dt / s.inertia[i] * evaluation_.torque[i];
    carried_force_[i] = moves || plate_force_ == PlateForce::reset ? Vec2{} : force;
  }
}

void ParticleShearStepper::advance(System<2>& system, ShearRates, double dt, double damping) {
  accelerate(system, dt);
  cool(system, damping);
  contacts_.elongate(system, evaluation_, dt);
  move(system, dt);
  system.time += dt;
  ++system.step;
}

}  // namespace supple
