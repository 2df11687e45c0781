/// Motion of bodies in time: polygons, rigid bodies and discs under conservative forces, damped or not.
#pragma once
#include "supple/force/force_field.hpp"
#include "supple/model/system.hpp"
#include "supple/solve/plasticity.hpp"

namespace supple {

/// Solves m dv/dt = F - m b v for every free site, and M dV/dt = F - M b V, I dw/dt = T - I b w for every
/// rigid body, in a cell that is not being sheared. The method is velocity Verlet [Swope et al. 1982] with
/// the damping split off: velocities decay by exp(-b dt/2) before and after each step. It is of second order
/// in the step; without damping it is symplectic and reversible, so that the energy oscillates about a
/// constant. Positions and velocities are of one instant, so that a run goes on from a System alone, bit for
/// bit. Nothing is wrapped. Sites that are not free stay where they are; discs do not turn.
class BodyDynamics {
 public:
  /// Input error on a damping rate b [1/time] that is negative or no number.
  explicit BodyDynamics(ForceField forces, double damping = 0);

  /// Forces at the present instant; they are not computed again where the last step left them.
  const Evaluation<2>& evaluate(System<2>& system, Detail detail = Detail::forces);
  /// Moves the system on by dt [time]; contacts remember what they find there. Throws an input error where
  /// the cell is being sheared, and a numerics error that names step and site where a position is not finite;
  /// the system is then left as it is.
  void advance(System<2>& system, double dt);

  double damping() const { return damping_; }
  void set_damping(double rate);
  /// Lets preferred shapes flow by this law in every step, after positions have moved and before forces are
  /// evaluated. nullopt: they stay. Throws as check() does.
  void set_plasticity(const std::optional<PlasticLaw>& law);
  /// To be called after anything but this class has changed the system: the forces of the last step no longer
  /// hold.
  void invalidate() { current_ = false; }
  ForceField& forces() {
    current_ = false;
    return forces_;
  }

 private:
  ForceField forces_;
  Evaluation<2> evaluation_;
  double damping_ = 0;
  std::optional<PlasticLaw> plasticity_;
  bool current_ = false;
  Detail detail_ = Detail::forces;
};

/// Sum of m v^2/2 over all sites [energy], those of rigid bodies included.
double kinetic_energy(const System<2>& system);
/// Sum of I w^2/2 over rigid bodies [energy], a part of kinetic_energy(). It makes no pressure: the forces
/// that keep a turning body together cancel it.
double spin_energy(const System<2>& system);
/// Sum of m v over all sites.
Vec2 momentum(const System<2>& system);

/// An upper bound of the largest angular frequency [1/time] of small motions about the present state, valid
/// also if six more neighbours and a wall come to press on a site: 6 k/m is the largest squared frequency of
/// a triangular crystal of sites, the densest packing. The part of present contacts and terms is the largest
/// row sum of |mass-weighted Hessian|, sharpened by iterations of Collatz (1942); for shells it is within 12
/// % of their largest frequency.
double frequency_bound(System<2>& system, ForceField& forces);

/// Time steps as shares of the stability limit: where energy is to be conserved, and for damped motion.
constexpr double conserving_step = 0.02, damped_step = 0.3;

/// A time step [time]: `fraction` of the stability limit 2/omega of the Verlet method, omega by
/// frequency_bound(). Where contacts open and close, stiffness jumps, and the energy makes a small random
/// walk that grows with about the fourth power of the step. With the default fraction the energy stays within
/// 5e-6 of its value over 1e5 steps (16 polygons of any family, rigid ones too, packing fractions 0.6 and
/// 0.8, kinetic energies 1e-6 to 1e-3 per vertex), within 3e-4 for smooth discs, whose contacts are their
/// only forces. Input error where nothing acts.
double default_step(System<2>& system, ForceField& forces, double fraction = conserving_step);

}  // namespace supple
