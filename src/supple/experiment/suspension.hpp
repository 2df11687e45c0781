/// A microgel suspension ready for its protocol, in either fidelity.
#pragma once
#include <memory>
#include <vector>

#include "supple/experiment/experiments.hpp"
#include "supple/experiment/protocol.hpp"
#include "supple/observe/demodulate.hpp"
#include "supple/solve/stepper.hpp"

namespace supple {

/// What to run and how; `time_step` is that of the protocol, `damping` the factor per step (cool_factor per period).
struct Suspension {
  Units units;
  System<2> system;
  std::unique_ptr<Stepper> stepper;
  double time_step = 0, damping = 1;
};

/// Discs at rest or from the state, in the units of the run, and the stepper that moves them. Nothing is run yet.
Suspension make_suspension(const Case& c, const InitialState* initial);

/// Relaxes, links, cuts and relaxes again (physics section 7.1), then puts the plates in place. Progress and the table
/// "preparation" go to the recorder. Throws a numerics error if the discs do not come to rest.
void prepare(Suspension& suspension, const Case& c, Recorder& recorder);

/// From a state file: contacts remember, plates as the state or the case says, time starts at zero for a new protocol.
void adopt_state(Suspension& suspension, const Case& c, const InitialState& initial);

/// Whether the case asks for what the published package computes.
bool is_package(const Case& c);

}  // namespace supple
