#include "supple/solve/mover.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "supple/core/error.hpp"
#include "supple/model/present_motion.hpp"
#include "supple/model/rigid.hpp"
#include "supple/solve/kicks.hpp"

namespace supple {

namespace {

/// 1 where all bits of the exponent are set.
std::uint64_t is_not_finite(double x) {
  constexpr std::uint64_t exponent = 0x7ff0000000000000;
  return (std::bit_cast<std::uint64_t>(x) & exponent) == exponent;
}

/// Finite where position and spin of site i are.
double motion_sum(const State<2>& s, int i) { return s.position[i][0] + s.position[i][1] + s.spin[i]; }
double motion_sum(const State<3>& s, int i) {
  const Vec3 &x = s.position[i], &w = s.spin[i];
  return x[0] + x[1] + x[2] + w[0] + w[1] + w[2];
}

template <int Dim>
void drift(System<Dim>& system, double dt) {
  State<Dim>& s = system.state;
  // Values that are not finite, of sites at least.
  auto odd = sum_chunks<std::uint64_t>(s.size(), [&](std::int64_t begin, std::int64_t end) {
    std::uint64_t odd_here = 0;
    for_sites_apart(system, static_cast<int>(begin), static_cast<int>(end), [&](int i) {
      if constexpr (Dim == 2) s.angle[i] += dt * s.spin[i];
      s.position[i] += dt * s.velocity[i];
      odd_here |= is_not_finite(motion_sum(s, i));
    });
    return odd_here;
  });
  if constexpr (Dim == 2) {
    RigidBodies& rigid = system.rigid;
    for (int r = 0; r < rigid.size(); ++r) {
      rigid.angle[r] += dt * rigid.spin[r];
      rigid.centre[r] += dt * rigid.velocity[r];
      odd |= is_not_finite(rigid.centre[r][0] + rigid.centre[r][1] + rigid.angle[r]);
    }
  }
  system.box.strain += system.box.strain_rate * dt;
  system.lag = dt;
  if constexpr (Dim == 2) place_sites(system);
  for (int i = 0; odd != 0 && i < s.size(); ++i)
    if (!std::isfinite(motion_sum(s, i)))
      throw numerics_error(fmt::format("site {} is not finite at step {}", i, system.step + 1),
                           "the time step may be too large, a law too stiff, or bodies may overlap too much",
                           "reduce [time] step");
  system.time += dt;
  ++system.step;
}

}  // namespace

template <int Dim>
void capture_at_boundaries(System<Dim>& system, Plates plates) {
  if (plates != Plates::capture) return;
  State<Dim>& s = system.state;
  const Box<Dim>& box = system.box;
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
    for (int d = 0; d < Dim; ++d)
      if (!box.periodic[d] && !is_within(i, d, s.radius[i])) s.mobility[i] = Mobility::fixed;
  }
  for (const std::int32_t b : system.rigid.body)
    std::fill(s.mobility.begin() + system.topology.body_begin(b),
              s.mobility.begin() + system.topology.body_end(b), mobility_of_body(system, b));
}

template <int Dim>
void Mover<Dim>::set_drag(double rate) {
  if (!(rate >= 0))
    throw input_error(fmt::format("a damping rate of {}", rate), "it would add energy", "give 0 or more");
  drag_ = rate;
}

template <int Dim>
void Mover<Dim>::set_plasticity(const std::optional<PlasticLaw>& law) {
  if (law) check(*law);
  plasticity_ = law;
}

template <int Dim>
void Mover<Dim>::set_plates(Plates plates) {
  plates_ = plates;
  forces_.set_repulsive_plates(plates == Plates::repulsive);
}

template <int Dim>
void Mover<Dim>::compute(System<Dim>& system, ShearRates rates, Detail detail) {
  if (is_current_ && detail <= detail_) return;
  refuse_rigid(system);
  // Where the rate jumps, half of the impulse of these forces belongs to either side.
  const double rate = system.lag > 0 ? 0.5 * (system.box.strain_rate + rates.mid) : rates.mid;
  if (forces_.has_dashpots()) present_motion(system, rate, evaluation_.now);
  forces_.evaluate(system, detail, evaluation_);
  detail_ = detail;
  if (account_) account_->see(forces_.loss_power(system, evaluation_));
}

template <int Dim>
const Evaluation<Dim>& Mover<Dim>::evaluate(System<Dim>& system, ShearRates rates) {
  compute(system, rates, account_ ? Detail::energies : Detail::forces);
  return evaluation_;
}

template <int Dim>
const Evaluation<Dim>& Mover<Dim>::evaluate_energies(System<Dim>& system, ShearRates rates) {
  compute(system, rates, Detail::energies);
  return evaluation_;
}

/// Brings velocities, and the memory of contacts, to the instant of the forces.
template <int Dim>
void Mover<Dim>::complete(System<Dim>& system) {
  const double half = 0.5 * system.lag;
  forces_.commit(system, evaluation_);
  kick(system, evaluation_, half);
}

template <int Dim>
void Mover<Dim>::bring_to_instant(const System<Dim>& system, double rate_now, std::vector<Vec<Dim>>& velocity,
                                  std::vector<Angular<Dim>>& spin) const {
  System<Dim> now = system;
  now.lag = 0;
  kick(now, evaluation_, 0.5 * system.lag);
  set_strain_rate(now, rate_now);
  hold(now);
  velocity = std::move(now.state.velocity);
  spin = std::move(now.state.spin);
}

// Forces act for half of the last step, then what changes velocities at this instant is done, then forces act
// for half of the next step: every part is symmetrical about the instant, hence of second order.
template <int Dim>
void Mover<Dim>::change_velocities(System<Dim>& system, double rate, double half_before, double half_after,
                                   double damping) {
  if (!account_ && system.topology.begin.empty())
    return change_velocities_of_discs(system, evaluation_, rate, half_before, half_after, damping);
  accelerate(system, evaluation_);
  push(system, half_before);
  if (account_) account_->book_contacts(system);
  set_strain_rate(system, rate);
  if (account_) account_->book(&EnergyFlows::shear_rate, 1, system);
  Acceleration<Dim> drag;
  if (damping != 1) drag = slow_down(system, damping, half_before + half_after);
  if (account_) account_->book(&EnergyFlows::background, -1, system);
  push(system, half_after);
  if (account_) account_->book_contacts(system);
  add(drag, system.acceleration);
}

template <int Dim>
void Mover<Dim>::advance(System<Dim>& system, ShearRates rates, double dt, double damping) {
  const double half_before = 0.5 * system.lag, half_after = 0.5 * dt, time = half_before + half_after;
  if (account_) {
    account_->book_boundaries(system, evaluation_, half_before);
    account_->book_losses(evaluation_, system.lag);
  }
  is_current_ = false;
  forces_.commit(system, evaluation_);
  // The first step begins with its second half, which has half of the damping.
  change_velocities(system, rates.mid, half_before, half_after,
                    time == dt ? damping : std::pow(damping, time / dt));
  if (account_) {
    account_->book_boundaries(system, evaluation_, half_after);
    account_->book_losses_after(forces_.loss_power(system, evaluation_), half_after);
  }
  drift(system, dt);
  if (wrap_bodies(system)) forces_.invalidate();  // its contacts are with other images now
  if (account_) account_->book(&EnergyFlows::images, 1, system);
  capture_at_boundaries(system, plates_);
  if (account_) account_->book(&EnergyFlows::plates, 1, system);
}

template <int Dim>
void Mover<Dim>::advance(System<Dim>& system, double dt) {
  if (system.box.strain_rate != 0)
    throw input_error("bodies cannot move by this method in a cell that is being sheared",
                      "their images have velocities", "shear in steps, or set the strain rate to 0");
  evaluate(system);
  if (system.lag > 0) complete(system);
  system.acceleration = {};
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

template class Mover<2>;
template class Mover<3>;
template void capture_at_boundaries(System<2>&, Plates);
template void capture_at_boundaries(System<3>&, Plates);

}  // namespace supple
