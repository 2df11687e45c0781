/// Runs of deformable particles that start from a packing that is there.
#pragma once
#include "supple/experiment/case.hpp"
#include "supple/experiment/initial_state.hpp"

namespace supple {

/// The case with what it leaves open and the state knows: the law of contacts, unless [contact] k_c or [bodies]
/// stiffness are given, and the stiffnesses of its first deformable body (others may have others). Input error where
/// the state holds discs of microgels and the case is about deformable particles, or the reverse.
Case adopt_state(Case c, const InitialState* initial);

/// Stiffnesses of [bodies] that the user gave replace those of the deformable bodies of `system`, by their preferred
/// areas, lengths and perimeters; the others stay.
void give_stiffness(const Case& c, System<2>& system);

}  // namespace supple
