/// The external shear stress as one continuous series.
#pragma once
#include <vector>

#include "supple/observe/stress.hpp"

namespace supple {

/// The external stress (S1-16) depends on where the cell is cut: when a disc leaves through one side and
/// enters at the other, its contacts change between internal and external, and the published series jumps
/// although no force does. At such a step the stress is evaluated twice with the same forces, for the cut
/// before and the cut after the disc crossed, and the difference is subtracted from there on. The series is
/// then as smooth as the forces, but its level is that of the first cut: it drifts as discs migrate, and a
/// disc that comes back brings its jump of that instant.
class JumpCorrection {
 public:
  /// Goes on from a series from which jumps of this sum were removed already.
  explicit JumpCorrection(double removed = 0) : start_(removed), removed_(removed) {}
  /// External shear stress without the jumps so far, in the unit of `tensors` (`unit` as in stress_tensors).
  /// Call it at every step: a disc must not move by half a cell between two calls.
  double corrected(const System<2>& system, const Evaluation<2>& evaluation, const StressTensors& tensors,
                   double unit = 1);

  /// Sum of all jumps so far, and how far it has been from where this series began.
  double removed() const { return removed_; }
  double most_removed() const { return most_removed_; }

 private:
  std::vector<Vec2> before_;  ///< positions at the last call
  double start_, removed_, most_removed_ = 0;
};

}  // namespace supple
