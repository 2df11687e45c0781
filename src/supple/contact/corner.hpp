/// Where a point lies about one edge of a ring and the corner where that edge starts.
#pragma once
#include "supple/core/vec.hpp"

namespace supple {

/// The place of a point p about the corner (before, start, end) of a counter-clockwise ring and the edge from
/// start to end. The strip of an edge is what lies straight over it, on either side. S: a number, or several
/// side by side; Flag: what their comparison gives.
template <class S, class Flag>
struct CornerPlace {
  VecOf<S, 2> to, edge;     ///< p - start, end - start
  S along, height, square;  ///< to.edge; |edge| times the distance from its line, positive outside; edge.edge
  Flag over_edge;           ///< in the strip of the edge
  Flag over_last;           ///< before the end of the edge that ends at this corner
  Flag over_start;          ///< past the start of the edge
  Flag convex;              ///< the corner; a flat one is
};

/// Where p is about the end of an edge is decided by the same bits for this edge and for the next one, so
/// that no rounding opens a gap between a strip and its corner.
template <class S>
[[gnu::always_inline]] inline auto place_at_corner(const VecOf<S, 2>& p, const VecOf<S, 2>& before,
                                                   const VecOf<S, 2>& start, const VecOf<S, 2>& end) {
  const VecOf<S, 2> to = p - start, edge = end - start, last = start - before;
  const S along = dot(to, edge);
  using Flag = decltype(along > 0.0);
  const Flag over_start = along > 0.0, over_end = dot(p - end, edge) < 0.0, over_last = dot(to, last) < 0.0;
  return CornerPlace<S, Flag>{to,
                              edge,
                              along,
                              cross(to, edge),
                              dot(edge, edge),
                              Flag(over_start & over_end),
                              over_last,
                              over_start,
                              cross(last, edge) >= 0.0};
}

}  // namespace supple
