/// The angle of a hinge, where two facets of a boundary meet: 0 where it is flat, positive where it is
/// convex.
#pragma once
#include "supple/core/vec.hpp"

namespace supple {

/// Exterior (turning) angle at x[1] of a counter-clockwise boundary x[0], x[1], x[2] [radian], in (-pi, pi].
/// The angles of a simple polygon sum to 2 pi.
template <class S>
S hinge_angle(const VecOf<S, 2> (&x)[3]) {
  using std::atan2;
  const VecOf<S, 2> before = x[1] - x[0], after = x[2] - x[1];
  return atan2(cross(before, after), dot(before, after));
}

/// Angle between the outward normals of the triangles (x[0], x[1], x[2]) and (x[1], x[0], x[3]), which share
/// the edge x[0] x[1] [radian].
template <class S>
S hinge_angle(const VecOf<S, 3> (&x)[4]) {
  using std::atan2;
  const VecOf<S, 3> edge = x[1] - x[0];
  const VecOf<S, 3> left = cross(edge, x[2] - x[0]), right = cross(x[3] - x[0], edge);
  return atan2(dot(cross(left, right), edge) / norm(edge), dot(left, right));
}

}  // namespace supple
