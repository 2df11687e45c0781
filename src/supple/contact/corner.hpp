/// Where a point lies relative to one edge of a ring and the corner at the start of that edge.
#pragma once
#include "supple/core/vec.hpp"

namespace supple {

/// The place of a point p relative to the corner (before, start, end) of a counter-clockwise ring and the
/// edge from start to end. The strip of an edge is the set of points whose foot on its line lies within the
/// edge, on either side. S is a number, or several side by side; Flag is the type of a comparison of two S.
template <class S, class Flag>
struct CornerPlace {
  VecOf<S, 2> to, edge;     ///< p - start, end - start
  S along, height, square;  ///< to.edge; |edge| times the distance from its line, positive outside; edge.edge
  Flag over_edge;           ///< p is in the strip of the edge
  Flag over_last;           ///< p is before the end of the edge that ends at this corner
  Flag over_start;          ///< p is past the start of the edge
  Flag convex;              ///< the corner is convex or flat
};

/// Whether p is beyond the end of an edge is computed from the same numbers here and at the next corner, so
/// that rounding opens no gap between the strip of an edge and its corner.
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
