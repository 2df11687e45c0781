/// States to start from: the published package's JSON layout, and Supple's own runs.
#pragma once
#include <string>

#include "supple/core/new_file.hpp"
#include "supple/experiment/initial_state.hpp"

namespace supple {

/// Reads a run of Supple (its last state, finished or not) or the JSON layout: `params`, `initial.spheres`,
/// `initial.neighbors`, and numbers of the protocol. A state from JSON has the units micrometre, mg and s,
/// and pair rows of width 2: history[2r] is the elongation of first toward second, history[2r+1] that of
/// second toward first. Throws a file error (file, where, what) where the file is unreadable, truncated,
/// incomplete or inconsistent.
InitialState read_state(const std::string& path);

/// Writes a state of discs in the JSON layout, converted to micrometre, mg and s. A pair row of width 1 gives
/// both elongations.
void write_state_json(const InitialState& state, const std::string& path,
                      Existing existing = Existing::refuse);

}  // namespace supple
