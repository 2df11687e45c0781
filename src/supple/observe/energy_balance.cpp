#include "supple/observe/energy_balance.hpp"

#include "supple/model/rigid.hpp"
#include "supple/observe/summary.hpp"

namespace supple {
namespace {

/// Power of what moves the plates: it works against all forces on what it moves.
template <int Dim>
double plate_power(const System<Dim>& system, const Evaluation<Dim>& evaluation) {
  const State<Dim>& s = system.state;
  double power = 0;
  for_sites_apart(system, [&](int i) {
    if (s.mobility[i] != Mobility::free) power -= dot(evaluation.force[i], s.velocity[i]);
  });
  if constexpr (Dim == 2)
    for (int r = 0; r < system.rigid.size(); ++r)
      if (held(system, r))
        power -= dot(force_on_rigid(system, evaluation.force, r).force, system.rigid.velocity[r]);
  return power;
}

/// Power of the sheared images: the image n_y cells up moves at n_y Ly rate beyond its original.
template <int Dim>
double image_power(const System<Dim>& system, const Evaluation<Dim>& evaluation) {
  const double rate = system.box.strain_rate;
  return rate == 0 ? 0 : rate * image_moment(system, evaluation);
}

}  // namespace

template <int Dim>
double image_moment(const System<Dim>& system, const Evaluation<Dim>& evaluation) {
  Mat<Dim> virial = -1.0 * evaluation.virial;
  if constexpr (Dim == 2) virial = rigid_virial(system, evaluation.force) + virial;
  double sum = virial[flow][gradient];
  for (int i = 0; i < system.state.size(); ++i)
    sum += evaluation.force[i][flow] * system.state.position[i][gradient];
  for (const SiteForce<Dim>& wall : evaluation.wall)
    sum -= wall.force[flow] * system.state.position[wall.site][gradient];
  return sum;
}

template <int Dim>
double plate_moment(const System<Dim>& system, const Evaluation<Dim>& evaluation) {
  double sum = 0;
  for (int i = 0; i < system.state.size(); ++i)
    if (const Mobility m = system.state.mobility[i]; is_plate(m))
      sum -= (m == Mobility::upper_plate ? 0.5 : -0.5) * evaluation.force[i][flow];
  return sum * system.box.length[gradient];
}

template <int Dim>
EnergyState energy_state(const System<Dim>& system, const Evaluation<Dim>& evaluation) {
  const EnergyParts& e = evaluation.energy;
  return {kinetic_energy(system, evaluation).total(), e.elastic, e.tangential, e.wall, e.terms};
}

template <int Dim>
void EnergyBalance<Dim>::open(const System<Dim>& system, const Evaluation<Dim>& evaluation) {
  flows_ = {};
  energy_at_opening_ = energy_state(system, evaluation).total();
  kinetic_ = kinetic_energy(system).total();
  // Forces of the half step and losses of the step before this instant belong to the time before.
  book_boundaries(system, evaluation, -0.5 * system.lag);
  book_losses(evaluation, -system.lag);
}

template <int Dim>
void EnergyBalance<Dim>::resume(const System<Dim>& system, double energy_at_opening,
                                const EnergyFlows& booked) {
  flows_ = booked;
  energy_at_opening_ = energy_at_opening;
  kinetic_ = kinetic_energy(system).total();
}

template <int Dim>
void EnergyBalance<Dim>::book(double EnergyFlows::*part, double sign, const System<Dim>& system) {
  const double now = kinetic_energy(system).total();
  flows_.*part += sign * (now - kinetic_);
  kinetic_ = now;
}

template <int Dim>
void EnergyBalance<Dim>::book_contacts(const System<Dim>& system) {
  kinetic_ = kinetic_energy(system).total();
}

template <int Dim>
void EnergyBalance<Dim>::book_boundaries(const System<Dim>& system, const Evaluation<Dim>& evaluation,
                                         double time) {
  flows_.plates += time * plate_power(system, evaluation);
  flows_.images += time * image_power(system, evaluation);
}

template <int Dim>
void EnergyBalance<Dim>::book_losses(const Evaluation<Dim>& evaluation, double time) {
  flows_.viscous += time * evaluation.energy.viscous_power;
  flows_.tangential_viscous += time * evaluation.energy.tangential_viscous_power;
  flows_.sliding += time * evaluation.energy.sliding_power;
  book_losses_after(loss_power_, -0.5 * time);
}

// The books of a step take the forces of its end for its whole length. They act for half of it, and those of
// its begin for the other half, as the energies change by them.
template <int Dim>
void EnergyBalance<Dim>::book_losses_after(const LossPower& after, double time) {
  flows_.viscous -= time * after.viscous;
  flows_.tangential_viscous -= time * after.tangential_viscous;
  flows_.sliding -= time * after.sliding;
}

template <int Dim>
EnergyFlows EnergyBalance<Dim>::flows(const System<Dim>& system, const Evaluation<Dim>& evaluation) const {
  EnergyBalance pending = *this;
  pending.book_boundaries(system, evaluation, 0.5 * system.lag);
  pending.book_losses(evaluation, system.lag);
  return pending.flows_;
}

template <int Dim>
double EnergyBalance<Dim>::residual(const System<Dim>& system, const Evaluation<Dim>& evaluation) const {
  const EnergyFlows f = flows(system, evaluation);
  return energy_state(system, evaluation).total() - energy_at_opening_ - f.work() + f.lost();
}

template EnergyState energy_state(const System<2>&, const Evaluation<2>&);
template EnergyState energy_state(const System<3>&, const Evaluation<3>&);
template double image_moment(const System<2>&, const Evaluation<2>&);
template double image_moment(const System<3>&, const Evaluation<3>&);
template double plate_moment(const System<2>&, const Evaluation<2>&);
template double plate_moment(const System<3>&, const Evaluation<3>&);
template class EnergyBalance<2>;
template class EnergyBalance<3>;

}  // namespace supple
