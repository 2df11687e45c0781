/// How a system moves in time: discs, deformable and rigid bodies, sheared or not.
#pragma once
#include <optional>

#include "supple/force/force_field.hpp"
#include "supple/model/body_flow.hpp"
#include "supple/observe/energy_balance.hpp"
#include "supple/solve/plasticity.hpp"
#include "supple/solve/stepper.hpp"

namespace supple {

/// Solves m dv/dt = F, I dw/dt = T for free sites and rigid bodies; what is held moves with what holds it.
/// Two ways to take a step, of second order with one evaluation each:
///
/// advance(system, rates, dt, damping): leapfrog with a step that may change, in a cell that may be sheared.
/// Positions and forces are of the time t, velocities of t - lag/2, lag being the last step (System::lag; 0:
/// the same instant).
///     v(t + dt/2) = v(t - lag/2) + (lag + dt)/2 F(t)/m,    x(t + dt) = x(t) + dt v(t + dt/2)
/// Dashpots see the velocities of t, from those of t - lag/2 by the acceleration of the step before
/// (present_motion). A change of the shear rate, and damping, are done at t, between the halves of F.
/// Discs and bodies cross boundaries by wrap_bodies().
///
/// advance(system, dt): the same step from and to velocities of one instant, which is velocity Verlet [Swope
/// et al. 1982], with the drag of -m b v on sites and rigid bodies split off: velocities decay by exp(-b
/// dt/2) before and after. Without drag it is symplectic and reversible, so that the energy oscillates about
/// a constant. The cell is at rest, and nothing is wrapped.
///
/// Either way contacts of spheres in 3D make no torques, and a rigid body of many vertices is an input error
/// there. The state alone decides the next step, bit for bit.
template <int Dim>
class Mover : public Stepper<Dim> {
 public:
  explicit Mover(ForceField<Dim> forces, double drag = 0) : forces_(std::move(forces)) { set_drag(drag); }

  const Evaluation<Dim>& evaluate(System<Dim>& system, ShearRates = {}) override;
  /// The same with energies, dissipated power and virial.
  const Evaluation<Dim>& evaluate_energies(System<Dim>& system, ShearRates = {}) override;
  bool has_energies() const override { return true; }
  void advance(System<Dim>& system, ShearRates rates, double dt, double damping) override;
  /// v(t) = v(t - lag/2) + (lag/2) F(t)/m, and spins likewise, with the flow of the rate `rate_now`.
  void bring_to_instant(const System<Dim>& system, double rate_now, std::vector<Vec<Dim>>& velocity,
                        std::vector<Angular<Dim>>& spin) const override;

  /// A step of one instant; contacts remember what they find at its end, and the forces there are kept for
  /// evaluate(). Throws an input error where the cell is being sheared; as the other one where a value is not
  /// finite.
  void advance(System<Dim>& system, double dt);

  void set_friction(double coefficient) override { forces_.contacts().set_friction(coefficient); }
  double friction() const override { return forces_.contacts().law().friction; }
  void set_plates(Plates plates) override;
  void set_account(EnergyBalance<Dim>* account) override { account_ = account; }
  /// The rate b [1/time] in steps of one instant. Input error where it is negative or no number.
  void set_drag(double rate);
  /// Lets preferred shapes flow by this law in every step of one instant, after positions have moved and
  /// before forces are evaluated. nullopt: they stay. Throws as check() does.
  void set_plasticity(const std::optional<PlasticLaw>& law);
  /// Call after anything but this class has changed the system: sites, radii, links.
  void invalidate() {
    is_current_ = false;
    forces_.invalidate();
  }
  const ForceField<Dim>& forces() const { return forces_; }
  /// To change them.
  ForceField<Dim>& forces() {
    is_current_ = false;
    return forces_;
  }

 private:
  void compute(System<Dim>& system, ShearRates rates, Detail detail);
  void complete(System<Dim>& system);
  void change_velocities(System<Dim>& system, double rate, double half_before, double half_after,
                         double damping);

  ForceField<Dim> forces_;
  Evaluation<Dim> evaluation_;
  bool is_current_ = false;  ///< whether a step has left the forces of the present instant
  Detail detail_ = Detail::forces;
  Plates plates_ = Plates::none;
  double drag_ = 0;  ///< [1/time]
  std::optional<PlasticLaw> plasticity_;
  EnergyBalance<Dim>* account_ = nullptr;
};

/// With Plates::capture, free sites that touch a plate (y = 0 or y = Ly of a periodic cell) join it, and free
/// sites that touch the end of a direction that is not periodic are fixed there; a rigid body as a whole.
template <int Dim>
void capture_at_boundaries(System<Dim>& system, Plates plates);

}  // namespace supple
