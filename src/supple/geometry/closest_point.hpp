/// The point of a facet that is nearest to a given point.
#pragma once
#include <algorithm>

#include "supple/core/vec.hpp"

namespace supple {

/// Where the nearest point of a segment lies: a + along (b - a), along in [0, 1].
template <int Dim>
struct ClosestOnSegment {
  double along;
  Vec<Dim> from;  ///< from the nearest point to the given one [length]
};

/// Nearest point of the segment a b to p; a segment of no length is the point a.
template <int Dim>
ClosestOnSegment<Dim> closest_on_segment(const Vec<Dim>& p, const Vec<Dim>& a, const Vec<Dim>& b) {
  const Vec<Dim> edge = b - a, to = p - a;
  const double square = dot(edge, edge);
  const double along = square > 0 ? std::clamp(dot(to, edge) / square, 0.0, 1.0) : 0.0;
  return {along, along == 1 ? p - b : to - along * edge};
}

/// Whether p is beyond the corner as seen along the edge from there to `end`: its foot on the line is not on
/// the side of `end`, and so neither within the edge.
inline bool is_beyond_corner(const Vec3& p, const Vec3& corner, const Vec3& end) {
  return !(dot(end - corner, p - corner) > 0);
}

/// The part of a triangle whose inner points are nearest to a point: the triangle itself, its edge from
/// corner 0 to 1, from 1 to 2, from 2 to 0, or a corner.
enum class TrianglePart { face, edge_0, edge_1, edge_2, corner_0, corner_1, corner_2 };

inline TrianglePart edge_part(int k) { return static_cast<TrianglePart>(1 + k); }
inline TrianglePart corner_part(int k) { return static_cast<TrianglePart>(4 + k); }

/// Where the nearest point of a triangle lies: the sum of weight[k] x[k]. The weights are at least 0 and sum
/// to 1.
struct ClosestOnTriangle {
  TrianglePart part;
  double weight[3];
  Vec3 from;    ///< from the nearest point to the given one [length]; along `normal` over the face
  Vec3 normal;  ///< (x1 - x0) x (x2 - x0), twice the area long [length^2]
};

/// Whether the triangle x may be nearer to p than the root of `square` [length^2]: whether the box about it
/// is. Several times as quick as to find its nearest point, and most triangles that are looked at are not
/// near.
inline bool may_be_nearer(const Vec3& p, const Vec3 (&x)[3], double square) {
  double least = 0;
  for (int d = 0; d < 3; ++d) {
    const double low = std::min(std::min(x[0][d], x[1][d]), x[2][d]),
                 high = std::max(std::max(x[0][d], x[1][d]), x[2][d]);
    const double away = std::max(std::max(low - p[d], p[d] - high), 0.0);
    least += away * away;
  }
  return least < square;
}

/// Nearest point of the triangle x to p. A corner is nearest where p is beyond it along both of its edges, an
/// edge where p is beyond neither of its ends and its foot on the plane is beyond the edge [the conditions of
/// Karush, Kuhn and Tucker]. Corners are asked first and by is_beyond_corner(): what a corner decides is,
/// bit for bit, the same in all triangles there.
inline ClosestOnTriangle closest_on_triangle(const Vec3& p, const Vec3 (&x)[3]) {
  bool beyond_start[3], beyond_end[3];  // of edge k, from corner k to the next
  for (int k = 0; k < 3; ++k) {
    const Vec3 &start = x[k], &end = x[(k + 1) % 3];
    beyond_start[k] = is_beyond_corner(p, start, end);
    beyond_end[k] = is_beyond_corner(p, end, start);
  }
  ClosestOnTriangle at{TrianglePart::face, {0, 0, 0}, {}, cross(x[1] - x[0], x[2] - x[0])};
  for (int k = 0; k < 3; ++k) {
    if (!beyond_start[k] || !beyond_end[(k + 2) % 3]) continue;
    at.part = corner_part(k);
    at.weight[k] = 1;
    at.from = p - x[k];
    return at;
  }
  double inner[3];  // of edge k: how far the foot is on the inner side, and so the weight of the third corner
  for (int k = 0; k < 3; ++k) {
    inner[k] = dot(at.normal, cross(x[(k + 1) % 3] - x[k], p - x[k]));
    if (inner[k] > 0 || beyond_start[k] || beyond_end[k]) continue;
    const auto on_edge = closest_on_segment(p, x[k], x[(k + 1) % 3]);
    at.part = edge_part(k);
    at.weight[k] = 1 - on_edge.along;
    at.weight[(k + 1) % 3] = on_edge.along;
    at.from = on_edge.from;
    return at;
  }
  const double square = dot(at.normal, at.normal);
  for (int k = 0; k < 3; ++k) at.weight[(k + 2) % 3] = std::max(inner[k], 0.0);
  const double sum = at.weight[0] + at.weight[1] + at.weight[2];
  for (double& w : at.weight) w /= sum;
  at.from = (dot(at.normal, p - x[0]) / square) * at.normal;
  return at;
}

}  // namespace supple
