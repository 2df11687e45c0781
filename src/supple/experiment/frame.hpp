/// Frames from a system and its forces.
#pragma once
#include "supple/contact/laws/harmonic.hpp"
#include "supple/contact/record.hpp"
#include "supple/experiment/recorder.hpp"

namespace supple {

/// The instant of `evaluation`: contacts as it found them.
Frame make_frame(const System<2>& system, const Evaluation<2>& evaluation);

Frame make_frame(const System<2>& system, const Evaluation<2>& evaluation, const std::vector<ContactRecord<2>>& records, const Harmonic& law);

/// What a run is: sizes, masses and crosslinked particles of the discs.
RunInfo make_run_info(const System<2>& system, const Units& units);

}  // namespace supple
