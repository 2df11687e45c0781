/// How often a vertex of a closed surface counts for a point.
#pragma once
#include <cmath>
#include <span>
#include <vector>

#include "supple/core/vec.hpp"

namespace supple::smooth {

/// A vertex, the ring of vertices round it, counter-clockwise as seen from outside, and the direction to a
/// point. Let K be the cone that the body fills at the vertex, and H the half of a small sphere about the
/// vertex that looks to the point. The vertex counts
///     1 - chi(K in H),    chi: the number of pieces less the number of holes,
/// times: by that the number of pieces less holes of the part of the body within a distance r of the point
/// falls when r passes the vertex [critical points of the distance from a polyhedron, e.g. Banchoff 1967].
class CornerFan {
 public:
  /// `to`: from the vertex to the point.
  CornerFan(const std::vector<Vec3>& position, std::int32_t vertex, std::span<const std::int32_t> ring,
            const Vec3& to)
      : position_(position), at_(position[static_cast<std::size_t>(vertex)]), ring_(ring), to_(to) {}

  /// How often it counts. The surface that bounds K meets H in some arcs. Without any, K fills all of H or
  /// nothing of it. One arc leaves one piece. More are counted in order.
  int outer_index() const {
    const int arcs = count_arcs();
    if (arcs == 0) return is_before();
    return arcs == 1 ? 0 : pieces_outside(arcs) - arcs;
  }

  /// Whether the point is outside, where the surface does not cross the edge of H.
  bool is_before() const {
    bool all = true, none = true;
    for (std::size_t k = 0; k < ring_.size(); ++k) {
      const bool before = dot(cross(edge(k), edge(after(k))), to_) >= 0;
      all = all && before;
      none = none && !before;
    }
    return all || (!none && dot(outward(), to_) >= 0);
  }

  /// Mean of the normals of its triangles, weighted by their angles here, not normalised.
  Vec3 outward() const {
    Vec3 sum{};
    for (std::size_t k = 0; k < ring_.size(); ++k) {
      const Vec3 a = edge(k), b = edge(after(k)), normal = cross(a, b);
      const double area = norm(normal);
      if (area > 0) sum += (std::atan2(area, dot(a, b)) / area) * normal;
    }
    return sum;
  }

 private:
  Vec3 edge(std::size_t k) const { return position_[static_cast<std::size_t>(ring_[k])] - at_; }
  double height(std::size_t k) const { return dot(edge(k), to_); }
  bool is_in(std::size_t k) const { return height(k) > 0; }
  std::size_t after(std::size_t k) const { return k + 1 < ring_.size() ? k + 1 : 0; }

  int count_arcs() const {
    int arcs = 0;
    bool before = is_in(ring_.size() - 1);
    for (std::size_t k = 0; k < ring_.size(); ++k) {
      const bool here = is_in(k);
      arcs += !before && here;
      before = here;
    }
    return arcs;
  }

  /// Where the triangle between edge k and the next one crosses the edge of H.
  Vec3 crossing(std::size_t k) const {
    return std::abs(height(k)) * edge(after(k)) + std::abs(height(after(k))) * edge(k);
  }
  /// Whether, turning counter-clockwise about `to`, r comes before b if one starts at a.
  bool is_between(const Vec3& a, const Vec3& r, const Vec3& b) const {
    const auto left = [&](const Vec3& x, const Vec3& y) { return dot(cross(x, y), to_) > 0; };
    return left(a, b) ? left(a, r) && left(r, b) : left(a, r) || left(r, b);
  }

  /// Number of pieces of H outside of K. They lie on the left of the arcs, of which no two cross. A piece has
  /// as many arcs as stretches of the edge of H, and those turn by 2 pi together with the chords of the arcs;
  /// so the number of pieces is that of arcs that have a point of the edge on their right, plus 1 if the
  /// point is outside of K. The point here is just behind the end of one of the arcs, on its left.
  int pieces_outside(int arcs) const {
    std::size_t k = 0;
    while (!(!is_in(k) && is_in(after(k)))) ++k;
    Vec3 point{};
    int pieces = 1;
    for (int arc = 0; arc < arcs; ++arc) {
      while (!(!is_in(k) && is_in(after(k)))) k = after(k);
      const Vec3 begin = crossing(k);
      while (!(is_in(k) && !is_in(after(k)))) k = after(k);
      const Vec3 end = crossing(k);
      if (arc == 0) point = end;
      else pieces += is_between(begin, point, end);
    }
    return pieces;
  }

  const std::vector<Vec3>& position_;
  Vec3 at_;
  std::span<const std::int32_t> ring_;
  Vec3 to_;
};

}  // namespace supple::smooth
