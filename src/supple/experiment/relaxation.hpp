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

/// Damped dynamics until at rest. With `rough`, three windows come first, with 4, 2 and 1 times the given
/// step and velocities multiplied by 0.5, 0.75 and 0.875 per step; then the factor is 0.98 per step. Returns
/// the number of steps. Throws a numerics error after most_steps.
std::int64_t relax(System<2>& system, Stepper& stepper, const Units& units, const RelaxationSpec& spec,
                   bool rough, const std::string& phase, Recorder& recorder);

/// Subtracts the mean velocity of all discs, weighted by mass.
void remove_drift(System<2>& system);

}  // namespace supple
