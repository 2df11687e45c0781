/// The documented microgel model in time: leapfrog, plates, damping relative to the flow.
#pragma once
#include "supple/force/force_field.hpp"
#include "supple/model/body_flow.hpp"
#include "supple/observe/energy_balance.hpp"
#include "supple/solve/stepper.hpp"

namespace supple {

/// Leapfrog of any step: positions and forces at t, velocities half a step earlier (System::lag; 0: the same
/// instant).
///     v(t + dt/2) = v(t - lag/2) + (lag + dt)/2 F(t)/m,    x(t + dt) = x(t) + dt v(t + dt/2)
/// Second order, one evaluation a step, and the state alone gives the next step bit for bit.
class DiscDynamics : public Stepper {
 public:
  explicit DiscDynamics(ForceField forces) : forces_(std::move(forces)) {}

  const Evaluation<2>& evaluate(System<2>& system, ShearRates rates) override;
  /// v(t) = v(t - dt/2) + F(t)/m dt/2, and spins alike; relative to the flow of that instant.
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

/// With capturing plates: free discs that touch a plate join it; where the cell is not periodic they are
/// fixed instead.
void capture_at_boundaries(System<2>& system, Plates plates);

}  // namespace supple
