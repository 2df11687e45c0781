/// Stiffnesses in runs of deformable particles that start from a given packing.
#pragma once
#include "supple/experiment/case.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// Sets the stiffnesses of [bodies] that the user did not give to those of the first deformable body of
/// `system`; other bodies may have other ones.
template <int Dim>
void adopt_stiffness(Case& c, const System<Dim>& system);

/// Replaces the stiffnesses of all deformable bodies of `system` by those of [bodies] that the user gave,
/// made absolute with the preferred area, edge length and perimeter (3D: volume, area of a triangle and of
/// all) of each body. The others stay.
template <int Dim>
void give_stiffness(const Case& c, System<Dim>& system);

}  // namespace supple
