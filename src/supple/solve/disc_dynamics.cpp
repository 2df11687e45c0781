#include "supple/solve/disc_dynamics.hpp"

#include <cmath>
#include <string>

#include "supple/core/error.hpp"
#include "supple/model/body_flow.hpp"
#include "supple/model/rigid.hpp"

namespace supple {

namespace {

/// What is held has the velocity of what holds it: sites that are not free, and rigid bodies with such a
/// site. Discs may turn.
void hold(System<2>& system) {
  State<2>& s = system.state;
  const double plate_speed = 0.5 * system.box.strain_rate * system.box.length[gradient];
  for_sites_apart(system, [&](int i) {
    switch (s.mobility[i]) {
      case Mobility::free: break;
      case Mobility::lower_plate: s.velocity[i] = {-plate_speed, 0}; break;
      case Mobility::upper_plate: s.velocity[i] = {plate_speed, 0}; break;
      case Mobility::fixed: s.velocity[i] = {}; break;
    }
  });
  for (int r = 0; r < system.rigid.size(); ++r) {
    if (held(system, r)) {
      system.rigid.velocity[r] = {};
      system.rigid.spin[r] = 0;
    }
    place_sites(system, r);
  }
}

void kick(System<2>& system, const Evaluation<2>& evaluation, double time) {
  State<2>& s = system.state;
  for_sites_apart(system, [&](int i) {
    s.spin[i] += time / s.inertia[i] * evaluation.torque[i];
    s.velocity[i] += time / s.mass[i] * evaluation.force[i];
  });
  RigidBodies& rigid = system.rigid;
  for (int r = 0; r < rigid.size(); ++r) {
    const RigidForce on_body = force_on_rigid(system, evaluation.force, r);
    rigid.velocity[r] += time / rigid.mass[r] * on_body.force;
    rigid.spin[r] += time / rigid.inertia[r] * on_body.torque;
  }
  hold(system);
}

/// Returns whether a body of many sites crossed the boundary.
bool drift(System<2>& system, double dt) {
  State<2>& s = system.state;
  system.box.strain += system.box.strain_rate * dt;
  system.lag = dt;
  for_sites_apart(system, [&](int i) {
    s.angle[i] += dt * s.spin[i];
    s.position[i] += dt * s.velocity[i];
  });
  RigidBodies& rigid = system.rigid;
  for (int r = 0; r < rigid.size(); ++r) {
    rigid.angle[r] += dt * rigid.spin[r];
    rigid.centre[r] += dt * rigid.velocity[r];
  }
  place_sites(system);
  double finite = 0;  // becomes NaN with the first value that is not finite
  for (int i = 0; i < s.size(); ++i) finite += 0 * (s.position[i][0] + s.position[i][1] + s.spin[i]);
  const bool crossed = wrap_bodies(system);
  for (int i = 0; finite != 0 && i < s.size(); ++i)
    if (!std::isfinite(s.position[i][0] + s.position[i][1] + s.spin[i]))
      throw numerics_error(
          "site " + std::to_string(i) + " is not finite at step " + std::to_string(system.step + 1),
          "the time step may be too large or the law too stiff", "reduce [time] step");
  return crossed;
}

}  // namespace

void capture_at_boundaries(System<2>& system, Plates plates) {
  if (plates != Plates::capture) return;
  State<2>& s = system.state;
  const Box<2>& box = system.box;
  const auto touches = [&](int i, int d) {
    return !(s.radius[i] < s.position[i][d] && s.position[i][d] < box.length[d] - s.radius[i]);
  };
  for (int i = 0; i < s.size(); ++i) {
    if (s.mobility[i] != Mobility::free) continue;
    if (box.periodic[gradient] && touches(i, gradient))
      s.mobility[i] = s.position[i][gradient] > 0.5 * box.length[gradient] ? Mobility::upper_plate
                                                                           : Mobility::lower_plate;
    for (int d = 0; d < 2; ++d)
      if (!box.periodic[d] && touches(i, d)) s.mobility[i] = Mobility::fixed;
  }
}

const Evaluation<2>& DiscDynamics::evaluate(System<2>& system, ShearRates) {
  forces_.evaluate(system, account_ ? Detail::energies : Detail::forces, evaluation_);
  if (account_) account_->see(forces_.loss_power(system, evaluation_));
  return evaluation_;
}

const Evaluation<2>& DiscDynamics::evaluate_energies(System<2>& system, ShearRates) {
  forces_.evaluate(system, Detail::energies, evaluation_);
  if (account_) account_->see(forces_.loss_power(system, evaluation_));
  return evaluation_;
}

void DiscDynamics::bring_to_instant(const System<2>& system, double rate_now, std::vector<Vec2>& velocity,
                                    std::vector<double>& spin) const {
  System<2> now = system;
  now.lag = 0;
  kick(now, evaluation_, 0.5 * system.lag);
  set_strain_rate(now, rate_now);
  hold(now);
  velocity = std::move(now.state.velocity);
  spin = std::move(now.state.spin);
}

void DiscDynamics::set_plates(Plates plates) {
  plates_ = plates;
  forces_.set_repulsive_plates(plates == Plates::repulsive);
}

void DiscDynamics::advance(System<2>& system, ShearRates rates, double dt, double damping) {
  const double half_before = 0.5 * system.lag, half_after = 0.5 * dt;
  if (account_) {
    account_->book_boundaries(system, evaluation_, half_before);
    account_->book_losses(evaluation_, system.lag);
    account_->meet(system, evaluation_);
  }
  forces_.commit(system, evaluation_);
  set_strain_rate(system, rates.mid);
  if (account_) account_->book_at_instant(&EnergyFlows::shear_rate, 1, system, evaluation_, half_before);
  kick(system, evaluation_, half_before + half_after);
  if (account_) account_->book_contacts(system, evaluation_);
  if (damping != 1) damp_bodies(system, damping);
  if (account_) {
    account_->book_at_instant(&EnergyFlows::background, -1, system, evaluation_, -half_after);
    account_->book_boundaries(system, evaluation_, half_after);
    account_->book_losses_after(forces_.loss_power(system, evaluation_), half_after);
  }
  if (drift(system, dt)) forces_.invalidate();  // its contacts are with other images now
  if (account_) account_->book(&EnergyFlows::images, 1, system);
  capture_at_boundaries(system, plates_);
  if (account_) account_->book(&EnergyFlows::plates, 1, system);
  system.time += dt;
  ++system.step;
}

}  // namespace supple
