/// Forces between bodies that a force field adds to their conservative contacts.
#pragma once
#include <memory>

#include "supple/model/evaluation.hpp"
#include "supple/model/loss_power.hpp"
#include "supple/model/system.hpp"

namespace supple {

template <int Dim>
class BodyContacts;

/// Friction, links and the like: evaluated after the contacts, on the same rows of the pair table.
template <int Dim>
class Interaction {
 public:
  virtual ~Interaction() = default;
  virtual std::unique_ptr<Interaction> clone() const = 0;
  /// Adds forces and torques to `out` and, with Detail::energies, energies, dissipated power and the virial.
  /// Fills what will be remembered if the step is accepted, as if the present velocities had acted for dt
  /// [time] since the last accepted step; 0 leaves memory as it is. `contacts` are those of the same force
  /// field.
  virtual void evaluate(const System<Dim>& system, BodyContacts<Dim>& contacts, double dt, Detail detail,
                        Evaluation<Dim>& out) = 0;
  /// Of the forces that the last evaluation with energies found, at the velocities and the shear rate of now.
  virtual LossPower loss_power(const System<Dim>& system) const = 0;
  /// The step is accepted: moves what `evaluation` would remember into `system`.
  virtual void commit(System<Dim>& system, Evaluation<Dim>& evaluation) = 0;
};

}  // namespace supple
