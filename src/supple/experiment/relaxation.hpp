/// Bringing a suspension to rest.
#pragma once
#include <string>

#include "supple/experiment/recorder.hpp"
#include "supple/solve/stepper.hpp"

namespace supple {

/// When a suspension counts as at rest: over a window of steps no component of its virial stress varies by
/// more than `tolerance`.
struct RelaxationSpec {
  double time_step = 0;  ///< of the last stage
  double tolerance = 1;  ///< [Pa]
  int window = 250;      ///< steps
  std::int64_t most_steps = 100000;
};

/// Spread of the stresses over a window.
class StressSpread {
 public:
  void add(const Mat2& stress);
  double spread() const;
  void keep(Keeper& k) {
    k("low", low_);
    k("high", high_);
    k("count", count_);
  }

 private:
  double low_[3]{}, high_[3]{};
  int count_ = 0;
};

/// How far a relaxation has got.
struct RelaxationState {
  int coarse = 0;         ///< windows of coarse steps that are done
  int step = 0;           ///< in the present window
  std::int64_t done = 0;  ///< steps of whole windows
  StressSpread stress;    ///< over the present window

  void keep(Keeper& k) {
    k("coarse", coarse);
    k("step", step);
    k("done", done);
    k("stress", stress);
  }
};

/// Damped dynamics until at rest, from where `state` says it is. With `rough`, three windows come first, with
/// 4, 2 and 1 times the given step and velocities multiplied by 0.5, 0.75 and 0.875 per step; then the factor
/// is 0.98 per step. Every fifth step is a safe point, which `keep` saves, with the state. Throws a numerics
/// error after most_steps.
void relax(System<2>& system, Stepper<2>& stepper, const Units& units, const RelaxationSpec& spec, bool rough,
           const std::string& phase, RelaxationState& state, const Keep& keep, Recorder& recorder);

/// Subtracts the mean velocity of all discs, weighted by mass.
void remove_drift(System<2>& system);

}  // namespace supple
