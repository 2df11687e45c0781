#include "supple/observe/energy_balance.hpp"

#include "supple/model/rigid.hpp"
#include "supple/observe/summary.hpp"

namespace supple {
namespace {

/// Power of what moves the plates: it works against all forces on what it moves.
double plate_power(const System<2>& system, const Evaluation<2>& evaluation) {
  const State<2>& s = system.state;
  double power = 0;
  for_sites_apart(system, [&](int i) {
    if (s.mobility[i] != Mobility::free) power -= dot(evaluation.force[i], s.velocity[i]);
  });
  for (int r = 0; r < system.rigid.size(); ++r)
    if (held(system, r))
      power -= dot(force_on_rigid(system, evaluation.force, r).force, system.rigid.velocity[r]);
  return power;
}

/// Power of the sheared images: the image n_y cells up moves at n_y Ly rate beyond its original.
double image_power(const System<2>& system, const Evaluation<2>& evaluation) {
  const double rate = system.box.strain_rate;
  return rate == 0 ? 0 : rate * image_moment(system, evaluation);
}

}  // namespace

double image_moment(const System<2>& system, const Evaluation<2>& evaluation) {
  double sum = (rigid_virial(system, evaluation.force) + -1.0 * evaluation.virial)[flow][gradient];
  for (int i = 0; i < system.state.size(); ++i)
    sum += evaluation.force[i][flow] * system.state.position[i][gradient];
  for (const SiteForce<2>& wall : evaluation.wall)
    sum -= wall.force[flow] * system.state.position[wall.site][gradient];
  return sum;
}

double plate_moment(const System<2>& system, const Evaluation<2>& evaluation) {
  double sum = 0;
  for (int i = 0; i < system.state.size(); ++i)
    if (const Mobility m = system.state.mobility[i]; is_plate(m))
      sum -= (m == Mobility::upper_plate ? 0.5 : -0.5) * evaluation.force[i][flow];
  return sum * system.box.length[gradient];
}

EnergyState energy_state(const System<2>& system, const Evaluation<2>& evaluation) {
  const EnergyParts& e = evaluation.energy;
  return {kinetic_energy(system, evaluation).total(), e.elastic, e.tangential, e.wall, e.terms};
}

void EnergyBalance::open(const System<2>& system, const Evaluation<2>& evaluation) {
  flows_ = {};
  energy_at_opening_ = energy_state(system, evaluation).total();
  kinetic_ = kinetic_energy(system).total();
  // Forces of the half step and losses of the step before this instant belong to the time before.
  book_boundaries(system, evaluation, -0.5 * system.lag);
  book_losses(evaluation, -system.lag);
}

void EnergyBalance::resume(const System<2>& system, double energy_at_opening, const EnergyFlows& booked) {
  flows_ = booked;
  energy_at_opening_ = energy_at_opening;
  kinetic_ = kinetic_energy(system).total();
}

void EnergyBalance::book(double EnergyFlows::*part, double sign, const System<2>& system) {
  const double now = kinetic_energy(system).total();
  flows_.*part += sign * (now - kinetic_);
  kinetic_ = now;
}

void EnergyBalance::book_contacts(const System<2>& system) { kinetic_ = kinetic_energy(system).total(); }

void EnergyBalance::book_boundaries(const System<2>& system, const Evaluation<2>& evaluation, double time) {
  flows_.plates += time * plate_power(system, evaluation);
  flows_.images += time * image_power(system, evaluation);
}

void EnergyBalance::book_losses(const Evaluation<2>& evaluation, double time) {
  flows_.viscous += time * evaluation.energy.viscous_power;
  flows_.tangential_viscous += time * evaluation.energy.tangential_viscous_power;
  flows_.sliding += time * evaluation.energy.sliding_power;
  book_losses_after(loss_power_, -0.5 * time);
}

// The books of a step take the forces of its end for its whole length. They act for half of it, and those of
// its begin for the other half, as the energies change by them.
void EnergyBalance::book_losses_after(const LossPower& after, double time) {
  flows_.viscous -= time * after.viscous;
  flows_.tangential_viscous -= time * after.tangential_viscous;
  flows_.sliding -= time * after.sliding;
}

EnergyFlows EnergyBalance::flows(const System<2>& system, const Evaluation<2>& evaluation) const {
  EnergyBalance pending = *this;
  pending.book_boundaries(system, evaluation, 0.5 * system.lag);
  pending.book_losses(evaluation, system.lag);
  return pending.flows_;
}

double EnergyBalance::residual(const System<2>& system, const Evaluation<2>& evaluation) const {
  const EnergyFlows f = flows(system, evaluation);
  return energy_state(system, evaluation).total() - energy_at_opening_ - f.work() + f.lost();
}

}  // namespace supple
