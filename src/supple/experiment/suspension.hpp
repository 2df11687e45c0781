/// A suspension of microgel discs ready for its protocol.
#pragma once
#include <memory>

#include "supple/experiment/case.hpp"
#include "supple/experiment/derived.hpp"
#include "supple/experiment/initial_state.hpp"
#include "supple/experiment/recorder.hpp"
#include "supple/experiment/shear_protocol.hpp"
#include "supple/model/crosslink.hpp"
#include "supple/solve/stepper.hpp"

namespace supple {

/// Discs, the stepper that moves them, and the step and damping (factor per step) of the protocol, in the
/// run's units.
struct Suspension {
  Units units;
  System<2> system;
  std::unique_ptr<Stepper<2>> stepper;
  double time_step = 0, damping = 1;
  MaterialConstants material;
};

/// A model of discs: the documented one, or that of another program. Experiments on suspensions ask it for
/// all that differs between models.
struct SuspensionModel {
  /// The numbers of laws and scales that a run records.
  std::vector<Derived> (*constants)(const Case&, const InitialState*);
  double (*time_step)(const Case&, const InitialState*);  ///< of `dynamics` [s]
  ShearProtocol (*protocol)(const Case&, const InitialState*);
  /// Numbers that follow from the protocol.
  std::vector<Derived> (*consequences)(const Case&, const InitialState*, const ShearProtocol&);
  Suspension (*make)(const Case&, const InitialState*, Recorder&);
};
/// The documented model (docs/theory/microgel.md).
const SuspensionModel& documented_model();
/// The model of the particles of the case.
const SuspensionModel& suspension_model(const Case& c);

/// Takes over the particles of a state, with `history_width` numbers of contact memory in a row. Boundary and
/// plates are those of the case, which has adopted those of the state.
void take_state(Suspension& s, const Case& c, const InitialState& initial, int history_width);

/// Parts of a run, as a checkpoint names them.
inline constexpr auto preparation_part = "preparation", sheared_part = "shear";

/// Discs from the state, or at rest after preparation (physics section 7.1, or the package's): relaxed,
/// crosslinked and cut, relaxed again, plates in place. Progress and the table "preparation" go to the
/// recorder. Throws a numerics error if the discs do not come to rest, and what make_* of the fidelity throw.
/// Time is the state's own; see start_clock. Where a run goes on that was beyond its preparation, the discs
/// are as they were then.
Suspension make_suspension(const Case& c, const InitialState* initial, Recorder& recorder);

/// Records the derived numbers, and what a continuation takes over besides the final state: constants of the
/// contact law, step and damping, and whether forces on plate discs add up. `initial` is what this run
/// started from, or null.
void record_constants(const Suspension& s, const InitialState* initial, const std::vector<Derived>& derived,
                      Recorder& recorder);

/// The frame at the instant of `evaluation`, the last one of the stepper. Velocities, spins and the shear
/// rate are brought to that instant, where a leapfrog keeps those of half a step before.
Frame<2> frame_of(const Suspension& s, const Evaluation<2>& evaluation, ShearRates rates);

/// Sets time and step to 0, unless the case goes on with those of its state (initial.keep_time), or a run
/// goes on.
template <int Dim>
void start_clock(System<Dim>& system, const Case& c, const Recorder& recorder);

/// The cell of the case, in `units`.
Box<2> make_box(const Case& c, const Units& units);

/// How the case makes crosslinked particles.
CrosslinkSpec crosslink_spec(const Case& c);

}  // namespace supple
