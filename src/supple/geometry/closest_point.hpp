/// The point of a facet that is nearest to a given point.
#pragma once
#include <algorithm>

#include "supple/core/vec.hpp"

namespace supple {

/// Where the nearest point of a segment lies: a + along (b - a), along in [0, 1].
struct ClosestOnSegment {
  double along;
  Vec2 from;  ///< from the nearest point to the given one [length]
};

/// Nearest point of the segment a b to p; a segment of no length is the point a.
inline ClosestOnSegment closest_on_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 edge = b - a, to = p - a;
  const double square = dot(edge, edge);
  const double along = square > 0 ? std::clamp(dot(to, edge) / square, 0.0, 1.0) : 0.0;
  return {along, along == 1 ? p - b : to - along * edge};
}

}  // namespace supple
