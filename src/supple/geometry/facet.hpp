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

/// Whether the spheres of these radii about its corners hold all of a triangle. If they leave a hole, a
/// corner of one of these is outside of them: where the part of the triangle that is nearest to one sphere,
/// by the power |p - x_k|^2 - radius_k^2, has a corner. On each such part the power is a convex function,
/// largest at a corner. These are the point of equal powers and, on the edges, the points of two equal
/// powers.
inline bool spheres_cover(const Vec3 (&x)[3], const double (&radius)[3]) {
  const double least = std::min({radius[0], radius[1], radius[2]});
  if (least > 0 && facet_covering_radius(x) < least) return true;
  const Vec3 u = x[1] - x[0], v = x[2] - x[0];
  // The point x0 + s u + t v has the powers |s u + t v|^2 + weight_k - 2 (s u + t v).(x_k - x0).
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v);
  const double weight[3] = {-radius[0] * radius[0], uu - radius[1] * radius[1], vv - radius[2] * radius[2]};
  const auto covered = [&](double s, double t) {
    const double square = s * s * uu + 2 * s * t * uv + t * t * vv, along_u = s * uu + t * uv,
                 along_v = s * uv + t * vv;
    return square + std::min({weight[0], weight[1] - 2 * along_u, weight[2] - 2 * along_v}) < 0;
  };
  // Equal powers of 0 and 1, of 0 and 2, of 1 and 2: lines p s + q t = r.
  const double lines[3][3] = {{2 * uu, 2 * uv, weight[1] - weight[0]},
                              {2 * uv, 2 * vv, weight[2] - weight[0]},
                              {2 * (uv - uu), 2 * (vv - uv), weight[2] - weight[1]}};
  const double corner[3][2] = {{0, 0}, {1, 0}, {0, 1}};
  for (const auto& [s, t] : corner)
    if (!covered(s, t)) return false;
  for (const auto& [p, q, r] : lines)
    for (int k = 0; k < 3; ++k) {
      const auto &from = corner[k], &to = corner[(k + 1) % 3];
      const double start = p * from[0] + q * from[1] - r,
                   change = p * (to[0] - from[0]) + q * (to[1] - from[1]);
      const double at = -start / change;
      if (at > 0 && at < 1 && !covered(from[0] + at * (to[0] - from[0]), from[1] + at * (to[1] - from[1])))
        return false;
    }
  const double determinant = lines[0][0] * lines[1][1] - lines[0][1] * lines[1][0];
  const double s = (lines[0][2] * lines[1][1] - lines[0][1] * lines[1][2]) / determinant;
  const double t = (lines[0][0] * lines[1][2] - lines[0][2] * lines[1][0]) / determinant;
  return !(s > 0 && t > 0 && s + t < 1) || covered(s, t);
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
