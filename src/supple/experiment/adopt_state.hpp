/// What a state holds stays, unless the case names it.
#pragma once
#include "supple/experiment/case.hpp"
#include "supple/experiment/initial_state.hpp"

namespace supple {

/// The case with what it leaves open and the state knows: the model, the laws that act, their constants,
/// plates, walls, gravity, and how the particles were made. Keys that the user gave win where they are about
/// what acts; input error where they are about particles that are there already and say otherwise, and where
/// the experiment is not about what the state holds. The one place where a run takes over names; the numbers
/// of a contact law follow in resolve_material and give_stiffness.
Case adopt_state(Case c, const InitialState* initial);

}  // namespace supple
