/// Measures of a facet, a piece of a body's boundary: an edge in 2D, a triangle in 3D.
#pragma once
#include "supple/core/vec.hpp"

namespace supple {

/// Length of an edge [length].
template <class S>
S facet_measure(const VecOf<S, 2> (&x)[2]) {
  return norm(x[1] - x[0]);
}

/// Area of a triangle [length^2].
template <class S>
S facet_measure(const VecOf<S, 3> (&x)[3]) {
  return 0.5 * norm(cross(x[1] - x[0], x[2] - x[0]));
}

}  // namespace supple
