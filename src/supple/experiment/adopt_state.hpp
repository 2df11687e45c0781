/// A run that starts from a state takes over what the state holds, unless the case says otherwise.
#pragma once
#include "supple/experiment/case.hpp"
#include "supple/experiment/initial_state.hpp"

namespace supple {

/// The case, with the keys that the user did not give taken from the state: the model, the laws that act and
/// their constants, plates, walls, gravity, and how the particles were made. A key that the user gave wins if
/// it is about what acts. Throws an input error where a key that was given contradicts particles that exist
/// already, and where the experiment is not about the particles of the state. Keys are adopted here alone;
/// the numbers of a contact law follow in resolve_material() and give_stiffness().
Case adopt_state(Case c, const InitialState* initial);

}  // namespace supple
