/// Whether a point lies inside a polygon.
#pragma once
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

}  // namespace supple
