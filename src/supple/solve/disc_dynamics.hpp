/// The documented microgel model in time, and bodies in shear: leapfrog, plates, damping relative to the
/// flow.
#pragma once
#include "supple/force/force_field.hpp"
#include "supple/model/body_flow.hpp"
#include "supple/observe/energy_balance.hpp"
#include "supple/solve/stepper.hpp"

namespace supple {

/// Leapfrog with a step that may change: positions and forces are of the time t, velocities of t - lag/2, lag
/// being the last step (System::lag; 0: the same instant).
///     v(t + dt/2) = v(t - lag/2) + (lag + dt)/2 F(t)/m,    x(t + dt) = x(t) + dt v(t + dt/2)
/// It is of second order and takes one evaluation a step. The state alone decides the next step, bit for bit.
/// Discs and bodies cross boundaries by wrap_bodies().
class DiscDynamics : public Stepper {
 public:
  explicit DiscDynamics(ForceField forces) : forces_(std::move(forces)) {}

  const Evaluation<2>& evaluate(System<2>& system, ShearRates rates) override;
  /// v(t) = v(t - lag/2) + (lag/2) F(t)/m, and spins likewise, with the flow of the rate `rate_now`.
  void bring_to_instant(const System<2>& system, double rate_now, std::vector<Vec2>& velocity,
                        std::vector<double>& spin) const override;
  void advance(System<2>& system, ShearRates rates, double dt, double damping) override;
  /// The same as evaluate() with energies, dissipated power and virial.
  const Evaluation<2>& evaluate_energies(System<2>& system, ShearRates = {}) override;
  bool has_energies() const override { return true; }

  void set_friction(double coefficient) override { forces_.contacts().set_friction(coefficient); }
  double friction() const override { return forces_.contacts().law().friction; }
  void set_plates(Plates plates) override;
  void set_account(EnergyBalance* account) override { account_ = account; }
  /// Call after sites, radii or links were changed by hand.
  void invalidate() { forces_.invalidate(); }
  const ForceField& forces() const { return forces_; }

 private:
  ForceField forces_;
  Evaluation<2> evaluation_;
  Plates plates_ = Plates::none;
  EnergyBalance* account_ = nullptr;
};

/// With Plates::capture, free discs that touch a plate (y = 0 or y = Ly of a periodic cell) join it, and free
/// discs that touch the end of a direction that is not periodic are fixed there.
void capture_at_boundaries(System<2>& system, Plates plates);

}  // namespace supple
