/// Runs of deformable particles that start from a packing that is there.
#pragma once
#include "supple/experiment/case.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// Stiffnesses of [bodies] that the user did not give become those of the first deformable body of `system`
/// (others may have others).
void adopt_stiffness(Case& c, const System<2>& system);

/// Stiffnesses of [bodies] that the user gave replace those of the deformable bodies of `system`, by their
/// preferred areas, lengths and perimeters; the others stay.
void give_stiffness(const Case& c, System<2>& system);

}  // namespace supple
