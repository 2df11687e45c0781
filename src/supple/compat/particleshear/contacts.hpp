/// The two passes of a particleShear step over the contacts: forces, then elongations while the discs move.
#pragma once
#include <vector>

#include "supple/compat/particleshear/law.hpp"
#include "supple/model/evaluation.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// Keeps nothing from call to call but memory that is used again.
class ParticleShearContacts {
 public:
  /// Adds forces and torques of all contacts to `out` and fills its pair rows, trial states and trial history
  /// (two elongations a row). The box must be periodic in both directions.
  void evaluate(const System<2>& system, const ParticleShearConstants& constants, Evaluation<2>& out);

  /// Takes over the trial states and adds v_t dt to the elongations of contacts that stick or are linked. To
  /// be called after velocities have changed and before positions do. The package moves one disc after the
  /// other, and each visits its contacts before it moves: `first` sees both discs where they were, `second`
  /// sees `first` where it will be.
  void elongate(System<2>& system, const Evaluation<2>& evaluation, double dt);

 private:
  void collect(const State<2>& state);

  std::vector<Vec2> rim_;                     ///< radius and speed of the rim, r w, of each disc
  std::vector<Vec<4>> as_first_, as_second_;  ///< sums over contacts of force and couple
};

}  // namespace supple
