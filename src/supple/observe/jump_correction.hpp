/// The external shear stress as one continuous series.
#pragma once
#include <vector>

#include "supple/model/kept.hpp"
#include "supple/observe/stress.hpp"

namespace supple {

/// The external stress (S1-16) depends on where the cell is cut. When a disc leaves through one side and
/// enters at the other, its contacts change between internal and external, and the published series jumps
/// although no force does. At such a step the stress is evaluated twice with the same forces, with the disc
/// before and after the crossing, and the difference is subtracted from there on. The series is then as
/// smooth as the forces. Its level depends on the first cut and drifts as discs migrate, because a disc that
/// comes back later makes another jump than the one it made when it left.
class JumpCorrection {
 public:
  /// `removed`: the sum of the jumps that were already taken out of the series that this one continues.
  explicit JumpCorrection(double removed = 0) : start_(removed), removed_(removed) {}
  /// External shear stress without the jumps so far, in the unit of `tensors` (`unit` as in stress_tensors).
  /// To be called at every step: no disc may move by half a cell between two calls.
  double corrected(const System<2>& system, const Evaluation<2>& evaluation, const StressTensors& tensors,
                   double unit = 1);

  /// Sum of all jumps so far, and the largest distance of that sum from its value at the begin of this
  /// series.
  double removed() const { return removed_; }
  double most_removed() const { return most_removed_; }

  void keep(Keeper& k) {
    k("before", before_);
    k("start", start_);
    k("removed", removed_);
    k("most_removed", most_removed_);
  }

 private:
  std::vector<Vec2> before_;  ///< positions at the last call
  double start_, removed_, most_removed_ = 0;
};

}  // namespace supple
