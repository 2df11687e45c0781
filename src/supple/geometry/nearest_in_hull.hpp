/// How far the origin is from a convex hull.
#pragma once
#include <span>
#include <vector>

#include "supple/core/vec.hpp"

namespace supple {

/// Distance from the origin to the convex hull of these points, 0 inside, with an error of at most 1e-9 of
/// the distance of the farthest point [Wolfe 1976, Math. Program. 11, 128]. Infinite for no points. In as
/// many dimensions as wrenches of bodies have: 2, 3 and 6.
template <int Dim>
double distance_to_hull(std::span<const Vec<Dim>> points);
template <int Dim>
double distance_to_hull(const std::vector<Vec<Dim>>& points) {
  return distance_to_hull(std::span<const Vec<Dim>>(points));
}

}  // namespace supple
