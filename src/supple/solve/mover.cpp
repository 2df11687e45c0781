#include "supple/solve/mover.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "supple/core/error.hpp"
#include "supple/model/rigid.hpp"

namespace supple {

namespace {

Vec2 plate_velocity(const Box<2>& box, Mobility m) {
  Vec2 v{};
  const double speed = 0.5 * box.strain_rate * box.length[gradient];
  if (is_plate(m)) v[flow] = m == Mobility::upper_plate ? speed : -speed;
  return v;
}

Mobility mobility_of_body(const System<2>& system, int b) {
  for (int i = system.topology.body_begin(b); i < system.topology.body_end(b); ++i)
    if (system.state.mobility[i] != Mobility::free) return system.state.mobility[i];
  return Mobility::free;
}

/// The one place of constraints: sites that are not free, and rigid bodies with such a site, have the
/// velocity of what holds them. Discs may turn in any case.
void hold(System<2>& system) {
  State<2>& s = system.state;
  std::uint8_t held = 0;
  for (const Mobility m : s.mobility) held |= static_cast<std::uint8_t>(m);
  if (held == static_cast<std::uint8_t>(Mobility::free)) return;
  for_sites_apart(system, [&](int i) {
    if (s.mobility[i] != Mobility::free) s.velocity[i] = plate_velocity(system.box, s.mobility[i]);
  });
  for (int r = 0; r < system.rigid.size(); ++r) {
    const Mobility m = mobility_of_body(system, system.rigid.body[r]);
    if (m == Mobility::free) continue;
    system.rigid.velocity[r] = plate_velocity(system.box, m);
    system.rigid.spin[r] = 0;
    place_sites(system, r);
  }
}

void kick(System<2>& system, const Evaluation<2>& evaluation, double time) {
  State<2>& s = system.state;
  for_sites_apart(system, [&](int i) {
    if (evaluation.torque[i] != 0) s.spin[i] += time / s.inertia[i] * evaluation.torque[i];  // no vertex
    s.velocity[i] += time / s.mass[i] * evaluation.force[i];
  });
  RigidBodies& rigid = system.rigid;
  for (int r = 0; r < rigid.size(); ++r) {
    const RigidForce on_body = force_on_rigid(system, evaluation.force, r);
    rigid.velocity[r] += time / rigid.mass[r] * on_body.force;
    rigid.spin[r] += time / rigid.inertia[r] * on_body.torque;
  }
  place_sites(system);
  hold(system);
}

/// 1 where all bits of the exponent are set.
std::uint64_t is_not_finite(double x) {
  constexpr std::uint64_t exponent = 0x7ff0000000000000;
  return (std::bit_cast<std::uint64_t>(x) & exponent) == exponent;
}

void drift(System<2>& system, double dt) {
  State<2>& s = system.state;
  std::uint64_t odd = 0;  // 1 from the first value on that is not finite
  for_sites_apart(system, [&](int i) {
    s.angle[i] += dt * s.spin[i];
    s.position[i] += dt * s.velocity[i];
    odd |= is_not_finite(s.position[i][0] + s.position[i][1] + s.spin[i]);
  });
  RigidBodies& rigid = system.rigid;
  for (int r = 0; r < rigid.size(); ++r) {
    rigid.angle[r] += dt * rigid.spin[r];
    rigid.centre[r] += dt * rigid.velocity[r];
    odd |= is_not_finite(rigid.centre[r][0] + rigid.centre[r][1] + rigid.angle[r]);
  }
  system.box.strain += system.box.strain_rate * dt;
  system.lag = dt;
  place_sites(system);
  for (int i = 0; odd != 0 && i < s.size(); ++i)
    if (!std::isfinite(s.position[i][0] + s.position[i][1] + s.spin[i]))
      throw numerics_error(fmt::format("site {} is not finite at step {}", i, system.step + 1),
                           "the time step may be too large, a law too stiff, or bodies may overlap too much",
                           "reduce [time] step");
  system.time += dt;
  ++system.step;
}

}  // namespace

void capture_at_boundaries(System<2>& system, Plates plates) {
  if (plates != Plates::capture) return;
  State<2>& s = system.state;
  const Box<2>& box = system.box;
  const auto is_within = [&](int i, int d, double margin) {
    return margin < s.position[i][d] && s.position[i][d] < box.length[d] - margin;
  };
  // Parts of a body may be beyond the plate that it touches, in the next cell.
  const auto is_at_plate = [&](int i) {
    return box.periodic[gradient] && !is_within(i, gradient, s.radius[i]) &&
           is_within(i, gradient, -s.radius[i]);
  };
  for (int i = 0; i < s.size(); ++i) {
    if (s.mobility[i] != Mobility::free) continue;
    if (is_at_plate(i))
      s.mobility[i] = s.position[i][gradient] > 0.5 * box.length[gradient] ? Mobility::upper_plate
                                                                           : Mobility::lower_plate;
    for (int d = 0; d < 2; ++d)
      if (!box.periodic[d] && !is_within(i, d, s.radius[i])) s.mobility[i] = Mobility::fixed;
  }
  for (const std::int32_t b : system.rigid.body)
    std::fill(s.mobility.begin() + system.topology.body_begin(b),
              s.mobility.begin() + system.topology.body_end(b), mobility_of_body(system, b));
}

void Mover::set_drag(double rate) {
  if (!(rate >= 0))
    throw input_error(fmt::format("a damping rate of {}", rate), "it would add energy", "give 0 or more");
  drag_ = rate;
}

void Mover::set_plasticity(const std::optional<PlasticLaw>& law) {
  if (law) check(*law);
  plasticity_ = law;
}

void Mover::set_plates(Plates plates) {
  plates_ = plates;
  forces_.set_repulsive_plates(plates == Plates::repulsive);
}

void Mover::compute(System<2>& system, Detail detail) {
  if (is_current_ && detail <= detail_) return;
  forces_.evaluate(system, detail, evaluation_);
  detail_ = detail;
  if (account_) account_->see(forces_.loss_power(system, evaluation_));
}

const Evaluation<2>& Mover::evaluate(System<2>& system, ShearRates) {
  compute(system, account_ ? Detail::energies : Detail::forces);
  return evaluation_;
}

const Evaluation<2>& Mover::evaluate_energies(System<2>& system, ShearRates) {
  compute(system, Detail::energies);
  return evaluation_;
}

/// Brings velocities, and the memory of contacts, to the instant of the forces.
void Mover::complete(System<2>& system) {
  const double half = 0.5 * system.lag;
  forces_.commit(system, evaluation_);
  kick(system, evaluation_, half);
}

void Mover::bring_to_instant(const System<2>& system, double rate_now, std::vector<Vec2>& velocity,
                             std::vector<double>& spin) const {
  System<2> now = system;
  now.lag = 0;
  kick(now, evaluation_, 0.5 * system.lag);
  set_strain_rate(now, rate_now);
  hold(now);
  velocity = std::move(now.state.velocity);
  spin = std::move(now.state.spin);
}

void Mover::advance(System<2>& system, ShearRates rates, double dt, double damping) {
  const double half_before = 0.5 * system.lag, half_after = 0.5 * dt;
  if (account_) {
    account_->book_boundaries(system, evaluation_, half_before);
    account_->book_losses(evaluation_, system.lag);
    account_->meet(system, evaluation_);
  }
  is_current_ = false;
  forces_.commit(system, evaluation_);
  set_strain_rate(system, rates.mid);
  if (account_) account_->book_at_instant(&EnergyFlows::shear_rate, 1, system, evaluation_, half_before);
  kick(system, evaluation_, half_before + half_after);
  if (account_) account_->book_contacts(system, evaluation_);
  if (damping != 1) {
    damp(system, damping, Drag::bodies);
    hold(system);
  }
  if (account_) {
    account_->book_at_instant(&EnergyFlows::background, -1, system, evaluation_, -half_after);
    account_->book_boundaries(system, evaluation_, half_after);
    account_->book_losses_after(forces_.loss_power(system, evaluation_), half_after);
  }
  drift(system, dt);
  if (wrap_bodies(system)) forces_.invalidate();  // its contacts are with other images now
  if (account_) account_->book(&EnergyFlows::images, 1, system);
  capture_at_boundaries(system, plates_);
  if (account_) account_->book(&EnergyFlows::plates, 1, system);
}

void Mover::advance(System<2>& system, double dt) {
  if (system.box.strain_rate != 0)
    throw input_error("bodies cannot move by this method in a cell that is being sheared",
                      "their images have velocities", "shear in steps, or set the strain rate to 0");
  evaluate(system);
  if (system.lag > 0) complete(system);
  const double decay = std::exp(-0.5 * drag_ * dt);
  if (drag_ > 0) damp(system, decay, Drag::sites);
  kick(system, evaluation_, 0.5 * dt);
  is_current_ = false;
  drift(system, dt);
  if (plasticity_) supple::advance(system, *plasticity_, dt);
  evaluate(system);
  is_current_ = true;
  complete(system);
  if (drag_ > 0) damp(system, decay, Drag::sites);
}

}  // namespace supple
