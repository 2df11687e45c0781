/// Where the energy of a run comes from and where it goes.
#pragma once
#include "supple/model/evaluation.hpp"
#include "supple/model/kept.hpp"
#include "supple/model/loss_power.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// Energy of the sites [energy]: kinetic, of free sites and of all spins, and what is stored in contacts
/// (elastic, tangential), plates and walls, and the terms of bodies.
struct EnergyState {
  double kinetic = 0, elastic = 0, tangential = 0, wall = 0, terms = 0;
  double total() const { return kinetic + elastic + tangential + wall + terms; }
};
/// The energy at the instant of `evaluation`, which must hold energies (Detail::energies).
template <int Dim>
EnergyState energy_state(const System<Dim>& system, const Evaluation<Dim>& evaluation);

/// What a change of the shear strain would do by the sheared images [energy]: sum F_x n_y Ly over contacts, F
/// on the site here by the image n_y cells up. It is what sum f_x y over the sites has beyond the virial sum
/// F_x l_y, apart from walls, and from what keeps rigid bodies together. The evaluation must hold the virial.
template <int Dim>
double image_moment(const System<Dim>& system, const Evaluation<Dim>& evaluation);

/// The same by the plates: half of Ly times the difference of the forces along the flow that drive the upper
/// and the lower one. Their power is this, and that of the images, times the shear rate.
template <int Dim>
double plate_moment(const System<Dim>& system, const Evaluation<Dim>& evaluation);

/// Work done on the sites, and energy lost, since the account was opened [energy].
struct EnergyFlows {
  double plates = 0;  ///< work on discs that plates move, less what a disc loses when a plate takes it
  double images =
      0;  ///< work: rate sum F_x n_y Ly, F on a site by the image n_y cells up, and sites that cross
  double shear_rate = 0;  ///< work: velocities that change with the shear rate
  double viscous = 0, tangential_viscous = 0,
         sliding = 0;     ///< lost in contacts: in central and tangential dashpots, by friction
  double background = 0;  ///< lost by damping relative to the flow, less the work that the flow does

  double work() const { return plates + images + shear_rate; }
  double lost() const { return viscous + tangential_viscous + sliding + background; }

  void keep(Keeper& k) {
    k("plates", plates);
    k("images", images);
    k("shear_rate", shear_rate);
    k("viscous", viscous);
    k("tangential_viscous", tangential_viscous);
    k("sliding", sliding);
    k("background", background);
  }
};

/// The account of a run. The integrator books each change that it makes to the velocities
/// (Mover::set_account), and the work of the forces at each instant for the half step before it and
/// the half step after it. Work and losses are computed without the energies, so what is left over measures
/// the error of the time step:
///     residual = change of energy - work + lost.
template <int Dim>
class EnergyBalance {
 public:
  /// Opens the account at this instant (with energies).
  void open(const System<Dim>& system, const Evaluation<Dim>& evaluation);

  /// Goes on with an account of an earlier run, from its energy_at_opening() and booked(), at the instant of
  /// that run's end.
  void resume(const System<Dim>& system, double energy_at_opening, const EnergyFlows& booked);
  double energy_at_opening() const { return energy_at_opening_; }
  /// The flows that resume() needs: all but those of the half step before the present instant.
  const EnergyFlows& booked() const { return flows_; }

  /// Books the change of kinetic energy since the last booking as work (sign +1) or as loss (-1).
  void book(double EnergyFlows::*flow, double sign, const System<Dim>& system);
  /// Leaves the change of kinetic energy since the last booking to the contacts: it is neither work nor loss.
  void book_contacts(const System<Dim>& system);
  /// Books the work of plates and images while these forces act for `time` [time] at the present velocities.
  void book_boundaries(const System<Dim>& system, const Evaluation<Dim>& evaluation, double time);
  /// Takes note of what the lossy forces of an instant do at the velocities half a step before it: they act
  /// as long after it, at others (book_losses_after). Before open() and flows() of that instant.
  void see(const LossPower& before) { loss_power_ = before; }
  /// What the forces of that instant lose in the half step after it.
  void book_losses_after(const LossPower& after, double time);
  /// Books what contacts lost over the step that led to this evaluation, `time` long [time], less the half in
  /// which the forces of its end did not act.
  void book_losses(const Evaluation<Dim>& evaluation, double time);

  /// Flows up to the instant of `evaluation`, before the step that starts there.
  EnergyFlows flows(const System<Dim>& system, const Evaluation<Dim>& evaluation) const;
  double residual(const System<Dim>& system, const Evaluation<Dim>& evaluation) const;

  void keep(Keeper& k) {
    k("flows", flows_);
    k("energy_at_opening", energy_at_opening_);
    k("kinetic", kinetic_);
    k("viscous_power", loss_power_.viscous);
    k("tangential_power", loss_power_.tangential_viscous);
    k("sliding_power", loss_power_.sliding);
  }

 private:
  EnergyFlows flows_;
  double energy_at_opening_ = 0, kinetic_ = 0;
  LossPower loss_power_;
};

}  // namespace supple
