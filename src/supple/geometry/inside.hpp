/// Whether a point lies inside a polygon, or inside a closed surface.
#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>

#include "supple/core/vec.hpp"

namespace supple {

/// 1 where the edge crosses the ray from p along +x upward, with p on its left; -1 where it crosses downward,
/// with p on its right; else 0.
inline int ray_crossing(const Vec2& p, const Vec2& from, const Vec2& to) {
  const Vec2 a = from - p, b = to - p;
  const bool rises = a[1] <= 0 && b[1] > 0, falls = a[1] > 0 && b[1] <= 0;
  if (!rises && !falls) return 0;
  const double side = cross(a, b);  // positive: p is on the left of the edge
  return (rises && side > 0) - (falls && side < 0);
}

/// How often a closed ring winds about p, counter-clockwise positive; 0 outside. An edge holds its lower end
/// and not its upper one, so that a ray through a vertex counts once. Wrong only where p is within rounding
/// (1e-16 of the differences of coordinates) of an edge.
inline int winding_number(const Vec2& p, std::span<const Vec2> ring) {
  int winding = 0;
  for (std::size_t k = 0; k < ring.size(); ++k)
    winding += ray_crossing(p, ring[k], ring[k + 1 < ring.size() ? k + 1 : 0]);
  return winding;
}

/// Whether p is inside the ring, or inside a loop that the ring makes by crossing itself.
inline bool is_inside(const Vec2& p, std::span<const Vec2> ring) { return winding_number(p, ring) != 0; }

/// Solid angle of the triangle x as seen from p, in (-2 pi, 2 pi) and positive where its corners are
/// clockwise from there, so that p is behind it [van Oosterom & Strackee 1983, eq. 8].
inline double solid_angle(const Vec3& p, const Vec3 (&x)[3]) {
  const Vec3 a = x[0] - p, b = x[1] - p, c = x[2] - p;
  const double la = norm(a), lb = norm(b), lc = norm(c);
  return 2 * std::atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
}

/// How often a closed surface winds about p; 1 inside and 0 outside of one that does not cross itself and
/// whose triangles are counter-clockwise as seen from outside. Corners of the triangles are indices into
/// `vertex`. Wrong only where p is within rounding of a triangle.
inline int winding_number(const Vec3& p, std::span<const Vec3> vertex,
                          std::span<const std::array<std::int32_t, 3>> faces) {
  double sum = 0;
  for (const auto& [a, b, c] : faces) {
    const Vec3 x[3] = {vertex[static_cast<std::size_t>(a)], vertex[static_cast<std::size_t>(b)],
                       vertex[static_cast<std::size_t>(c)]};
    sum += solid_angle(p, x);
  }
  return static_cast<int>(std::lround(sum / (4 * std::numbers::pi)));
}

/// Whether p is inside the surface, or inside a part of it that it makes by crossing itself.
inline bool is_inside(const Vec3& p, std::span<const Vec3> vertex,
                      std::span<const std::array<std::int32_t, 3>> faces) {
  return winding_number(p, vertex, faces) != 0;
}

}  // namespace supple
