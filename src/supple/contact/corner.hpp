/// Where a point lies about one edge of a ring and the corner where that edge starts.
#pragma once
#include "supple/core/vec.hpp"

namespace supple {

/// The place of a point p about the corner x_- , x_0, x_+ of a counter-clockwise ring and its edge x_0 x_+.
/// The strip of an edge is what lies straight above it on either side. A corner is met where a point is
/// beyond the ends of both edges there, or over both.
struct CornerPlace {
  Vec2 to, edge;  ///< p - x_0, x_+ - x_0
  double along, height,
      square;      ///< to.edge; |edge| times the distance from the edge's line, positive outside; edge.edge
  bool over_edge;  ///< in the strip of the edge
  bool beyond_edge, beyond_last;  ///< before the start of this edge, past the end of the last one
  bool convex;                    ///< the corner; a flat one is
};

/// Whether p is in a strip and beyond which end is decided by the same bits for both edges of a corner, so
/// that no rounding opens a gap between them.
inline CornerPlace place_at_corner(const Vec2& p, const Vec2& before, const Vec2& start, const Vec2& end) {
  const Vec2 to{p[0] - start[0], p[1] - start[1]}, to_end{p[0] - end[0], p[1] - end[1]};
  const Vec2 edge{end[0] - start[0], end[1] - start[1]}, last{start[0] - before[0], start[1] - before[1]};
  CornerPlace at;
  at.to = to;
  at.edge = edge;
  at.along = dot(to, edge);
  at.height = cross(to, edge);
  at.square = dot(edge, edge);
  at.over_edge = (at.along > 0) & (dot(to_end, edge) < 0);
  at.beyond_edge = !(at.along > 0);
  at.beyond_last = !(dot(to, last) < 0);
  at.convex = cross(last, edge) >= 0;
  return at;
}

}  // namespace supple
