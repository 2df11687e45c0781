/// Bringing a suspension to rest.
#pragma once
#include <string>

#include "supple/experiment/recorder.hpp"
#include "supple/solve/stepper.hpp"

namespace supple {

/// Rest: over a window of steps the shear stress and the normal stresses vary by less than `tolerance` [Pa].
struct RelaxationSpec {
  double time_step = 0;  ///< of the last stage
  double tolerance = 1;  ///< [Pa]
  int window = 250;      ///< steps
  std::int64_t most_steps = 100000;
};

/// Damped dynamics: three stages with steps 4, 2, 1 times the given one and damping 0.5, 0.75, 0.875 per step
/// if `rough`, then 0.98 per step until at rest. Returns the steps taken; numerics error beyond most_steps.
std::int64_t relax(System<2>& system, Stepper& stepper, const Units& units, const RelaxationSpec& spec,
                   bool rough, const std::string& phase, Recorder& recorder);

/// Takes out the mean velocity of all discs, weighted by mass.
void remove_drift(System<2>& system);

}  // namespace supple
