/// Whether two triangles in space go through each other.
#pragma once
#include "supple/core/vec.hpp"

namespace supple {

/// What two triangles have in common.
enum class TriangleMeeting {
  none,      ///< nothing, or they touch: see below
  crossing,  ///< each goes through the other's plane, and they share a segment there
  overlap    ///< they lie in one plane and share an area
};

/// How triangles p and q meet. They cross where each has corners on both sides of the other's plane and both
/// cut the line in which these planes meet along a common segment. What only touches does not count: a corner
/// or an edge that lies on the other triangle without going through it, a common corner or a common edge.
/// Corners are compared by their coordinates, so that triangles with one common corner cross where they do so
/// beyond it; with a common edge they cannot cross, but overlap where they are folded flat onto each other.
/// Signs are those of side_of_plane(): what rounding could decide counts as touching, and triangles lie in
/// one plane where all corners do within rounding. A triangle without area meets nothing. By orientations of
/// four points alone, after Guigue and Devillers (2003).
TriangleMeeting meeting_of(const Vec3 (&p)[3], const Vec3 (&q)[3]);

/// Whether they cross.
inline bool triangles_cross(const Vec3 (&p)[3], const Vec3 (&q)[3]) {
  return meeting_of(p, q) == TriangleMeeting::crossing;
}

}  // namespace supple
