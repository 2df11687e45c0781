/// Measures of closed polygons: rings of vertices, counter-clockwise.
#pragma once
#include <algorithm>
#include <cmath>
#include <span>

#include "supple/core/vec.hpp"

namespace supple {

/// Area [length^2], positive if counter-clockwise.
inline double polygon_area(std::span<const Vec2> ring) {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) twice += cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
  return 0.5 * twice;
}

/// Distance from x to the closed segment from a to b [length].
inline double distance_to_segment(const Vec2& x, const Vec2& a, const Vec2& b) {
  const Vec2 edge = b - a, r = x - a;
  const double square = dot(edge, edge);
  const double t = square > 0 ? std::clamp(dot(r, edge) / square, 0.0, 1.0) : 0;
  return norm(r - t * edge);
}

}  // namespace supple
