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

/// Signed area of the triangle of the origin and an edge [length^2]; around a closed boundary these sum to
/// the enclosed area.
template <class S>
S facet_volume(const VecOf<S, 2> (&x)[2]) {
  return 0.5 * cross(x[0], x[1]);
}

/// Signed volume of the tetrahedron of the origin and a triangle [length^3]; over a closed surface these sum
/// to the enclosed volume.
template <class S>
S facet_volume(const VecOf<S, 3> (&x)[3]) {
  return (1.0 / 6) * dot(x[0], cross(x[1], x[2]));
}

}  // namespace supple
