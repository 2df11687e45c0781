/// Forces between bodies beside their conservative contacts: what a force field adds to them.
#pragma once
#include "supple/model/evaluation.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// Evaluated after the contacts, on the same rows.
class Interaction {
 public:
  virtual ~Interaction() = default;
  /// Adds forces and torques to `out` and, with Detail::energies, energies, dissipated power and the virial;
  /// fills what will be remembered if the step is accepted. The present velocities are taken to have acted
  /// over dt [time] since the last one was; 0 leaves memory as it is.
  virtual void evaluate(const System<2>& system, double dt, Detail detail, Evaluation<2>& out) = 0;
  /// The step is accepted: what the evaluation found is remembered.
  virtual void commit(System<2>& system, Evaluation<2>& evaluation) = 0;
};

}  // namespace supple
