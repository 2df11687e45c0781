/// Whether a point lies inside a polygon.
#pragma once
#include <span>

#include "supple/core/vec.hpp"

namespace supple {

/// How often a closed ring winds about p, counter-clockwise positive; 0 outside. Crossings of the ray to +x
/// are counted by the half-open rule, so that a ray through a vertex counts once. Wrong only where p is
/// within rounding (1e-16 of the coordinates' differences) of an edge.
inline int winding_number(const Vec2& p, std::span<const Vec2> ring) {
  int winding = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Vec2 a = ring[k] - p, b = ring[k + 1 < ring.size() ? k + 1 : 0] - p;
    const bool rises = a[1] <= 0 && b[1] > 0, falls = a[1] > 0 && b[1] <= 0;
    if (!rises && !falls) continue;
    const double side = cross(a, b);  // positive: p is on the left of the edge
    winding += (rises && side > 0) - (falls && side < 0);
  }
  return winding;
}

/// Whether p is inside; also in a loop that the ring makes by crossing itself.
inline bool is_inside(const Vec2& p, std::span<const Vec2> ring) { return winding_number(p, ring) != 0; }

}  // namespace supple
