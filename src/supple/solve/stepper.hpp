/// How a system moves in time: one interface, so that an experiment reads the same in both fidelities.
#pragma once
#include <vector>

#include "supple/model/evaluation.hpp"
#include "supple/model/kept.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// Shear rate [1/time] at the present instant and at the middle of the step that starts there.
struct ShearRates {
  double now = 0, mid = 0;
};

/// What the plates do. none: there are none (plain Lees-Edwards); capture: every disc, vertex or rigid body
/// that reaches a plate moves with it; repulsive: they repel discs.
enum class Plates { none, capture, repulsive };

template <int Dim>
class EnergyBalance;

/// Moves a system in a cell that may be sheared, step by step.
template <int Dim>
class Stepper {
 public:
  virtual ~Stepper() = default;
  /// Forces and contacts at the present instant, from which stresses are computed. Contacts do not remember
  /// yet.
  virtual const Evaluation<Dim>& evaluate(System<Dim>& system, ShearRates rates) = 0;
  /// The same with energies and virial, if has_energies().
  virtual const Evaluation<Dim>& evaluate_energies(System<Dim>& system, ShearRates rates) {
    return evaluate(system, rates);
  }
  virtual bool has_energies() const { return false; }
  /// Books every step on this account (nullptr: on none), which the caller opens. Evaluations then hold
  /// energies. Only if has_energies().
  virtual void set_account(EnergyBalance<Dim>*) {}
  /// Moves the system on by dt [time]; evaluate() must have been called at the present instant. `damping`
  /// multiplies velocities relative to the flow, and spins, once. Throws a numerics error that names step and
  /// site if a value is not finite.
  virtual void advance(System<Dim>& system, ShearRates rates, double dt, double damping) = 0;

  /// Brings copies of velocities and spins to the instant of the positions, after evaluate(), with the flow
  /// of the rate `rate_now`. A stepper whose velocities are of that instant changes nothing.
  virtual void bring_to_instant(const System<Dim>&, double rate_now, std::vector<Vec<Dim>>& velocity,
                                std::vector<Angular<Dim>>& spin) const {
    (void)rate_now, (void)velocity, (void)spin;
  }

  /// What it carries from step to step besides the system.
  virtual void keep(Keeper&) {}

  virtual void set_friction(double coefficient) = 0;
  virtual double friction() const = 0;
  virtual void set_plates(Plates plates) = 0;
};

}  // namespace supple
