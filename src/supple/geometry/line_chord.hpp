/// Where a line along z is inside of spheres, cylinders and prisms: what is within a distance of a triangle
/// is the sphere about each corner, the cylinder along each edge and the prism over the face.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "supple/core/vec.hpp"
#include "supple/geometry/bands.hpp"

namespace supple {

/// The line through (x, y) along z.
using LineAlongZ = Vec2;

inline constexpr Interval whole_line{-std::numeric_limits<double>::infinity(),
                                     std::numeric_limits<double>::infinity()};
inline constexpr Interval no_part{1, 0};
inline bool is_empty(const Interval& i) { return !(i.low < i.high); }

/// Keeps the part of an interval where at + slope z >= 0.
inline void keep_positive(double at, double slope, Interval& i) {
  if (slope > 0) i.low = std::max(i.low, -at / slope);
  else if (slope < 0) i.high = std::min(i.high, -at / slope);
  else if (at < 0) i = no_part;
}

/// Heights z of the line inside of a sphere.
inline Interval chord_of_sphere(const LineAlongZ& line, const Vec3& centre, double radius) {
  const double x = line[0] - centre[0], y = line[1] - centre[1];
  const double square = radius * radius - x * x - y * y;
  if (!(square > 0)) return no_part;
  const double half = std::sqrt(square);
  return {centre[2] - half, centre[2] + half};
}

/// Heights z of the line inside of the cylinder about the segment a b, whose ends are flat.
inline Interval chord_of_cylinder(const LineAlongZ& line, const Vec3& a, const Vec3& b, double radius) {
  const Vec3 e = b - a;
  const double x = line[0] - a[0], y = line[1] - a[1];
  // In z - a_z: the point is at along + e_z z of the axis, of `square` in all, and at the distance from the
  // axis whose square is flat (z - middle)^2 + (x e_y - y e_x)^2/(e_x^2 + e_y^2) with flat = (e_x^2 +
  // e_y^2)/e^2.
  const double flat_square = e[0] * e[0] + e[1] * e[1], square = flat_square + e[2] * e[2];
  if (!(square > 0)) return no_part;
  const double along = x * e[0] + y * e[1], flat = flat_square / square, across = x * e[1] - y * e[0];
  Interval i = whole_line;
  const double reach = flat * radius * radius - across * across / square;
  if (flat > 0) {
    if (!(reach > 0)) return no_part;
    const double middle = along * e[2] / flat_square, half = std::sqrt(reach) / flat;
    i = {middle - half, middle + half};
  } else if (x * x + y * y >= radius * radius) {
    return no_part;
  }
  keep_positive(along, e[2], i);
  keep_positive(square - along, -e[2], i);
  return {i.low + a[2], i.high + a[2]};
}

/// Heights z of the line inside of what is within this distance of the triangle x and straight above or below
/// it.
inline Interval chord_of_prism(const LineAlongZ& line, const Vec3 (&x)[3], double distance) {
  const Vec3 normal = cross(x[1] - x[0], x[2] - x[0]);
  const Vec3 foot{line[0], line[1], x[0][2]};
  const double reach = distance * norm(normal), height = dot(normal, foot - x[0]);
  Interval i = whole_line;
  keep_positive(reach - height, -normal[2], i);
  keep_positive(reach + height, normal[2], i);
  for (int k = 0; k < 3; ++k) {
    const Vec3 inward = cross(normal, x[(k + 1) % 3] - x[k]);
    keep_positive(dot(inward, foot - x[k]), inward[2], i);
  }
  return {i.low + x[0][2], i.high + x[0][2]};
}

/// The side of the edge from a to b on which the line passes, as seen from above: positive on the left. The
/// same number, turned over, for the edge from b to a, so that a line passes between no two triangles.
inline double side_of_edge(const LineAlongZ& line, const Vec3& a, const Vec3& b) {
  const bool turned = std::lexicographical_compare(b.e, b.e + 3, a.e, a.e + 3);
  const Vec3 &from = turned ? b : a, &to = turned ? a : b;
  const double side = (to[0] - from[0]) * (line[1] - from[1]) - (to[1] - from[1]) * (line[0] - from[0]);
  return (turned ? -1 : 1) * (side == 0 ? std::numeric_limits<double>::min() : side);
}

/// Where the line passes through a triangle, upward along it: out of what is below a triangle that looks up.
struct Crossing {
  double height;
  int winding;  ///< what the winding number gains above: -1 where the triangle looks up, 0 where it is missed
};

inline Crossing crossing_of(const LineAlongZ& line, const Vec3 (&x)[3]) {
  double side[3], sum = 0;
  for (int k = 0; k < 3; ++k) {
    side[k] = side_of_edge(line, x[k], x[(k + 1) % 3]);
    if ((side[k] > 0) != (side[0] > 0)) return {0, 0};
    sum += side[k];
  }
  const double height = (side[0] * x[2][2] + side[1] * x[0][2] + side[2] * x[1][2]) / sum;
  return {height, side[0] > 0 ? -1 : 1};
}

/// How often a closed surface winds about p, by the triangles that the line through p passes below it: a few
/// products for each triangle. It is that of solid angles except within rounding of the surface.
inline int winding_along_z(const Vec3& p, std::span<const Vec3> vertex,
                           std::span<const std::array<std::int32_t, 3>> faces) {
  int winding = 0;
  for (const auto& [a, b, c] : faces) {
    const Vec3 x[3] = {vertex[static_cast<std::size_t>(a)], vertex[static_cast<std::size_t>(b)],
                       vertex[static_cast<std::size_t>(c)]};
    const auto [low, high] = std::minmax({x[0][0], x[1][0], x[2][0]});
    if (p[0] < low || high < p[0]) continue;
    const Crossing at = crossing_of({p[0], p[1]}, x);
    if (at.height < p[2]) winding += at.winding;
  }
  return winding;
}

}  // namespace supple
