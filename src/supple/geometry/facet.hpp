/// Measures of a facet, a piece of a body's boundary: an edge in 2D, a triangle in 3D.
#pragma once
#include <algorithm>
#include <cmath>

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

/// How far a point of the facet may be from the nearest of its corners, at most [length]: half of an edge.
inline double facet_covering_radius(const Vec2 (&x)[2]) { return 0.5 * norm(x[1] - x[0]); }

/// Of a triangle the same: the radius of the circle through its corners, whose centre is as far from all
/// three, if the triangle holds that centre. In an obtuse one no point is farther than half of the longest
/// edge from the nearest corner. In all, at most 1/sqrt(3) of the longest edge.
inline double facet_covering_radius(const Vec3 (&x)[3]) {
  const Vec3 edge[3] = {x[1] - x[0], x[2] - x[1], x[0] - x[2]};
  const double a = dot(edge[0], edge[0]), b = dot(edge[1], edge[1]), c = dot(edge[2], edge[2]);
  const double longest = std::max({a, b, c});
  if (2 * longest >= a + b + c) return 0.5 * std::sqrt(longest);
  return std::sqrt(a * b * c) / (4 * facet_measure(x));
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
