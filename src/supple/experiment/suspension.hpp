/// A microgel suspension ready for its protocol, in either fidelity.
#pragma once
#include <memory>

#include "supple/experiment/case.hpp"
#include "supple/experiment/derived.hpp"
#include "supple/experiment/initial_state.hpp"
#include "supple/experiment/recorder.hpp"
#include "supple/model/crosslink.hpp"
#include "supple/solve/stepper.hpp"

namespace supple {

/// Discs, the stepper that moves them, and the step and damping (factor per step) of the protocol, in the
/// run's units.
struct Suspension {
  Units units;
  System<2> system;
  std::unique_ptr<Stepper> stepper;
  double time_step = 0, damping = 1;
  MaterialConstants material;
};

/// Discs from the state, or at rest after preparation (physics section 7.1, or the package's): relaxed,
/// crosslinked and cut, relaxed again, plates in place. Progress and the table "preparation" go to the
/// recorder. Throws a numerics error if the discs do not come to rest, and what make_* of the fidelity throw.
/// Time is the state's own; see start_clock.
Suspension make_suspension(const Case& c, const InitialState* initial, Recorder& recorder);

/// Records the derived numbers, and what a continuation takes over besides the final state: constants of the
/// contact law, step and damping, the ways of the plates. `initial`: what this run started from, or null.
void record_constants(const Suspension& s, const InitialState* initial, const std::vector<Derived>& derived,
                      Recorder& recorder);

/// The instant of `evaluation`, the stepper's last one: velocities, spins and the shear rate are of that
/// instant, too, where a leapfrog keeps them half a step back.
Frame frame_of(const Suspension& s, const Evaluation<2>& evaluation, ShearRates rates);

/// t and the number of steps begin at 0, unless the case goes on with those of its state.
void start_clock(System<2>& system, const Case& c);

/// The cell of a case, in these units.
Box<2> make_box(const Case& c, const Units& units);

/// How the case makes crosslinked particles.
CrosslinkSpec crosslink_spec(const Case& c);

}  // namespace supple
