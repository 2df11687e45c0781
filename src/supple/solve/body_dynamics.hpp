/// Molecular dynamics of bodies: polygons, rigid bodies and discs under conservative forces, damped or not.
#pragma once
#include "supple/force/force_field.hpp"
#include "supple/model/system.hpp"
#include "supple/solve/plasticity.hpp"

namespace supple {

/// Solves m dv/dt = F - m b v of every free site, and M dV/dt = F - M b V, I dw/dt = T - I b w of every rigid
/// body, in a cell that is not being sheared, by velocity Verlet [Swope et al. 1982] with the damping split
/// off: velocities decay by exp(-b dt/2) before and after each step, exactly. Second order in the step;
/// without damping symplectic and reversible, so that the energy oscillates about a constant. Positions and
/// velocities are of one instant, so that a run goes on from a System alone, bit for bit. Nothing is wrapped.
/// Sites that are not free stay where they are; discs do not turn.
class BodyDynamics {
 public:
  /// Input error on a damping rate b [1/time] that is negative or no number.
  explicit BodyDynamics(ForceField forces, double damping = 0);

  /// Forces at the present instant; those of the last step where nothing has changed since.
  const Evaluation<2>& evaluate(System<2>& system, Detail detail = Detail::forces);
  /// To dt later [time]. Contacts remember what they find there. Input error where the cell is being sheared;
  /// a numerics error names step and site if a position is not finite, and leaves the system as it is then.
  void advance(System<2>& system, double dt);

  double damping() const { return damping_; }
  void set_damping(double rate);
  /// Preferred shapes flow by this law in every step, once positions have moved: its forces are those of the
  /// new shape. Nothing: they stay. Input error on a law that means nothing.
  void set_plasticity(const std::optional<PlasticLaw>& law);
  /// After anything but this class has changed the system: the forces of the last step are no longer the
  /// present ones.
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

/// Sum of m v^2/2 over all sites [energy]; rigid bodies included, as their sites move with them.
double kinetic_energy(const System<2>& system);
/// Sum of I w^2/2 over rigid bodies [energy], a part of it: it makes no pressure, as what keeps them together
/// takes that away.
double spin_energy(const System<2>& system);
/// Sum of m v.
Vec2 momentum(const System<2>& system);

/// An upper bound of the largest angular frequency [1/time] of small motions about where the system is, also
/// when six further neighbours come to press on a site and walls do: 6 k/m is the largest squared frequency
/// of a triangular crystal of sites, the densest. For present contacts and terms: the largest row sum of
/// |mass-weighted Hessian|, sharpened by some iterations of Collatz (1942); for shells within 12 % of the
/// frequency itself.
double frequency_bound(System<2>& system, ForceField& forces);

/// Fractions of the stability limit: for energy that is to be conserved, and for motion toward a minimum.
constexpr double conserving_step = 0.02, damped_step = 0.3;

/// A time step [time]: this fraction of the stability limit 2/omega of Verlet's method, omega by
/// frequency_bound. Where contacts open and close their stiffness jumps, and the energy makes a small random
/// walk that grows with about the fourth power of the step. At the default it stays within 5e-6 of itself
/// over 1e5 steps (16 polygons of any family, rigid ones too, packing fraction 0.6 and 0.8, kinetic energies
/// 1e-6 to 1e-3 per vertex); smooth discs, whose contacts are their only forces, reach 3e-4. Input error
/// where nothing acts.
double default_step(System<2>& system, ForceField& forces, double fraction = conserving_step);

}  // namespace supple
