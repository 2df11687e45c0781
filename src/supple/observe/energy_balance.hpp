/// Where the energy of a run comes from and where it goes.
#pragma once
#include "supple/model/evaluation.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// Energy of the discs [energy]: kinetic, of free discs and of all spins, and what contacts and plates store.
struct EnergyState {
  double kinetic = 0, elastic = 0, tangential = 0, wall = 0, terms = 0;
  double total() const { return kinetic + elastic + tangential + wall + terms; }
};
/// At the instant of `evaluation`, which must hold energies (Detail::energies).
EnergyState energy_state(const System<2>& system, const Evaluation<2>& evaluation);

/// Work done on the discs, and energy lost, since the account was opened [energy].
struct EnergyFlows {
  double plates = 0;  ///< work: discs that plates move, less what discs lose when a plate takes them
  double images =
      0;  ///< work: -A sigma_xy rate of contacts across the sheared boundary, and discs that cross it
  double shear_rate = 0;  ///< work: velocities that jump with the shear rate
  double viscous = 0, tangential_viscous = 0,
         sliding = 0;     ///< lost in contacts: central, tangential, by friction
  double background = 0;  ///< lost by damping relative to the flow, less the work of that flow

  double work() const { return plates + images + shear_rate; }
  double lost() const { return viscous + tangential_viscous + sliding + background; }
};

/// The account of a run: an integrator books each thing that it does to the velocities
/// (DiscDynamics::set_account), and the forces of each instant for the half step before it and the half step
/// after it. Work and losses are independent of the energies, so what is left over measures the error of the
/// time step:
///     residual = change of energy - work + lost.
class EnergyBalance {
 public:
  /// Opens the account at this instant (with energies).
  void open(const System<2>& system, const Evaluation<2>& evaluation);

  /// Goes on with an account of which these were kept, at the instant to which it was booked.
  void resume(const System<2>& system, double energy_at_opening, const EnergyFlows& booked);
  double energy_at_opening() const { return energy_at_opening_; }
  /// What resume() needs: flows without those of the half step before the present instant.
  const EnergyFlows& booked() const { return flows_; }

  /// Books the change of kinetic energy since the last booking as work (sign +1) or as loss (-1).
  void book(double EnergyFlows::*flow, double sign, const System<2>& system);
  /// The same for a change at the instant of the forces that stand in meet(), made while these have yet to
  /// act for `left` until then (negative: have acted beyond it): of the velocities of that instant.
  void book_at_instant(double EnergyFlows::*flow, double sign, const System<2>& system,
                       const Evaluation<2>& evaluation, double left);
  /// The forces of another instant, before anything changes the velocities.
  void meet(const System<2>& system, const Evaluation<2>& evaluation);
  /// The kinetic energy that changed since the last booking came from the contacts.
  void book_contacts(const System<2>& system, const Evaluation<2>& evaluation);
  /// Work of plates and images while these forces act for `time` at the present velocities.
  void book_boundaries(const System<2>& system, const Evaluation<2>& evaluation, double time);
  /// What the contacts lost over the step that led to this evaluation, `time` long.
  void book_losses(const Evaluation<2>& evaluation, double time);

  /// Flows up to the instant of `evaluation`, before the step that starts there.
  EnergyFlows flows(const System<2>& system, const Evaluation<2>& evaluation) const;
  double residual(const System<2>& system, const Evaluation<2>& evaluation) const;

 private:
  EnergyFlows flows_;
  double energy_at_opening_ = 0, kinetic_ = 0;
  double power_ = 0;  ///< of the forces, at the last booking
};

}  // namespace supple
