/// Delaunay triangulations in 2D and 3D.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "supple/core/vec.hpp"

namespace supple {

/// Triangles or tetrahedra of points, which they name from 0 on, and the boundary of all of them together.
template <int Dim>
struct DelaunayMesh {
  /// Of positive area (volume), simplex_volume.
  std::vector<std::array<std::int32_t, Dim + 1>> simplex;
  /// In 2D edges, counter-clockwise; in 3D triangles, counter-clockwise as seen from outside.
  std::vector<std::array<std::int32_t, Dim>> hull;
};

/// The Delaunay triangulation of these points: no simplex has a point within the circle (sphere) through its
/// corners. Where more points than needed lie on one circle (sphere), it is one of those that are possible.
/// Found by adding one point after the other [Bowyer 1981; Watson 1981], with coordinates rounded to 2^-23 of
/// the longest side of the box round all points, for which every decision is exact: the same points give the
/// same triangulation everywhere. With N points in no order this takes a time of N^(1 + 1/Dim) at most.
/// Input error where all points lie on a line (plane), two are the same within the rounding, or one is not
/// finite.
template <int Dim>
DelaunayMesh<Dim> delaunay(std::span<const Vec<Dim>> points);

}  // namespace supple
