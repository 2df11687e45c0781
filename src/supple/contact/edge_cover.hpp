/// How thick vertices must be for edges of surfaces not to pass through each other.
#pragma once
#include "supple/model/system.hpp"

namespace supple {

/// The least diameter of vertices over the longest edge of their surface [docs/decisions/0020]. No contact is
/// of an edge with an edge, so where two of them cross, ends must be near. Smooth: the nearer end of the
/// shorter one is at most half of it away from the other. Rough: with the crossing point at s and t of the
/// two edges, the squares of the four distances between ends have a weighted mean of s(1-s) l^2 + t(1-t) m^2,
/// at most (l^2 + m^2)/4.
inline constexpr double least_smooth_diameter = 0.5, least_rough_diameter = 0.70710678118654752;

/// Input error where an edge of a surface is longer than the diameter of its vertices over `least` allows:
/// one of the two above.
void require_covered_edges(const System<3>& system, double least);

}  // namespace supple
