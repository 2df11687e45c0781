/// The shape energy as terms of energy/: for Hessians, energies by term, 3D, and to check the fast path.
#pragma once
#include "supple/force/terms.hpp"

namespace supple {

/// The terms of energy/ with the stiffnesses and rest values that System::shape has now.
template <int Dim>
TermSet<Dim> shape_terms(const System<Dim>& system);

}  // namespace supple
