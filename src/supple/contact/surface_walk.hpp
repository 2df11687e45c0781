/// What a point meets of a triangulated boundary: the parts that act, and where they are nearest. The
/// geometry of SmoothSurfaces, whose comment has the formula.
#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "supple/contact/corner_index.hpp"
#include "supple/contact/surface_fans.hpp"
#include "supple/geometry/closest_point.hpp"

namespace supple::smooth {

/// Where surfaces are, and how they hang together.
struct Surfaces {
  const std::vector<Vec3>& position;
  const Topology<3>& topology;
  const SurfaceFans& fans;
};

/// The nearest point of a triangle, an edge or a vertex to the point: the sum of weight[k] x[site[k]].
struct SurfaceFoot {
  int sites = 0;
  std::array<std::int32_t, 3> site{};
  std::array<double, 3> weight{};
  double distance = 0;  ///< from there, negative where the point is inside [length]
  Vec3 normal{};        ///< gradient of the distance by the point's position: a unit vector
  int sign = 1;         ///< how often this part counts

  void add(std::int32_t a, double w) {
    site[static_cast<std::size_t>(sites)] = a;
    weight[static_cast<std::size_t>(sites++)] = w;
  }
};

/// How many parts a point met, and the sum of their signs: the Euler number of what is within reach, 1 where
/// that is one piece without holes.
struct MetParts {
  int parts = 0, euler = 0;
};

/// The parts of one surface within reach of one point. To be used for one point after the other, so that its
/// memory is used again.
class PatchInReach {
 public:
  explicit PatchInReach(const Surfaces& surfaces) : surfaces_(surfaces) {}

  /// visit(foot) for each part within `reach` [length] of p that acts, in the order of triangles and of what
  /// they speak for. `facets`: ascending, triangles of one surface, among them all within reach.
  template <class Visit>
  MetParts meet(std::span<const std::int32_t> facets, const Vec3& p, double reach, const Visit& visit) {
    find(facets, p, reach);
    MetParts met;
    const auto act = [&](const SurfaceFoot& foot) {
      ++met.parts;
      met.euler += foot.sign;
      visit(foot);
    };
    for (const Near& near : near_) {
      if (near.at.part == TrianglePart::face && is_before_face(near)) act(face_foot(near));
      const FacetNeighbours& neighbours = surfaces_.fans.of(near.facet);
      for (int k = 0; k < 3; ++k) {
        if (neighbours.speaks_for_edge[static_cast<std::size_t>(k)]) meet_edge(near, k, act);
        if (neighbours.speaks_for_corner[static_cast<std::size_t>(k)]) meet_corner(near, k, act);
      }
    }
    if (const Near* nearest = nearest_if_inside()) act(inner_foot(*nearest));
    return met;
  }

 private:
  struct Near {
    std::int32_t facet;
    ClosestOnTriangle at;
  };

  void find(std::span<const std::int32_t> facets, const Vec3& p, double reach) {
    p_ = p;
    square_ = reach * reach;
    near_.clear();
    for (const std::int32_t f : facets) {
      const Vec3 x[3] = {corner(f, 0), corner(f, 1), corner(f, 2)};
      const ClosestOnTriangle at = closest_on_triangle(p, x);
      if (dot(at.from, at.from) < square_) near_.push_back({f, at});
    }
  }

  std::int32_t corner_site(std::int32_t facet, int k) const {
    return surfaces_.topology.facet[facet][static_cast<std::size_t>(k % 3)];
  }
  const Vec3& corner(std::int32_t facet, int k) const { return surfaces_.position[corner_site(facet, k)]; }

  static Vec3 unit(const Vec3& a) { return (1 / norm(a)) * a; }
  static bool is_before_face(const Near& near) { return dot(near.at.normal, near.at.from) >= 0; }

  SurfaceFoot face_foot(const Near& near) const {
    SurfaceFoot foot;
    for (int k = 0; k < 3; ++k) foot.add(corner_site(near.facet, k), near.at.weight[k]);
    foot.normal = unit(near.at.normal);
    foot.distance = dot(foot.normal, near.at.from);
    return foot;
  }

  /// The triangle across edge k of another. It is within reach where the edge is, but for rounding.
  const Near* across(const Near& near, int k) const {
    const std::int32_t facet = surfaces_.fans.of(near.facet).across[static_cast<std::size_t>(k)];
    for (const Near& other : near_)
      if (other.facet == facet) return &other;
    return nullptr;
  }
  /// Which of its edges starts at this site.
  int edge_from(const Near& near, std::int32_t site) const {
    return corner_site(near.facet, 0) == site ? 0 : corner_site(near.facet, 1) == site ? 1 : 2;
  }

  template <class Act>
  void meet_edge(const Near& near, int k, const Act& act) const {
    const std::int32_t start = corner_site(near.facet, k), end = corner_site(near.facet, k + 1);
    const Vec3 &a = surfaces_.position[start], &b = surfaces_.position[end];
    if (is_beyond_corner(p_, a, b) || is_beyond_corner(p_, b, a)) return;
    const Near* other = across(near, k);
    if (!other) return;
    const int sign =
        (near.at.part == edge_part(k)) + (other->at.part == edge_part(edge_from(*other, end))) - 1;
    if (sign == 0) return;
    const auto [along, from] = closest_on_segment(p_, a, b);
    if (!(dot(from, from) < square_)) return;
    const Vec3 outward = unit(near.at.normal) + unit(other->at.normal);
    if (dot(from, outward) < 0) return;
    SurfaceFoot foot;
    foot.add(start, 1 - along);
    foot.add(end, along);
    foot.distance = norm(from);
    foot.normal = unit(foot.distance > 0 ? from : outward);
    foot.sign = sign;
    act(foot);
  }

  template <class Act>
  void meet_corner(const Near& near, int k, const Act& act) const {
    const std::int32_t site = corner_site(near.facet, k);
    const Vec3 from = p_ - surfaces_.position[site];
    if (!(dot(from, from) < square_)) return;
    const CornerFan fan(surfaces_.position, site, surfaces_.fans.round(site), from);
    const int sign = fan.outer_index();
    if (sign == 0) return;
    SurfaceFoot foot;
    foot.add(site, 1);
    foot.distance = norm(from);
    foot.normal = unit(foot.distance > 0 ? from : fan.outward());
    foot.sign = sign;
    act(foot);
  }

  /// The triangle that is nearest, if the point is behind the nearest part of it. Then the point is inside:
  /// from outside, another part would be nearer. The side of an edge or a vertex is that of the mean of the
  /// normals there, weighted by angles [Baerentzen & Aanaes 2005, theorem 1].
  const Near* nearest_if_inside() const {
    const Near* nearest = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const Near& near : near_)
      if (const double square = dot(near.at.from, near.at.from); square < least)
        least = square, nearest = &near;
    return nearest && is_behind(*nearest) ? nearest : nullptr;
  }

  bool is_behind(const Near& near) const {
    if (near.at.part == TrianglePart::face) return !is_before_face(near);
    for (int k = 0; k < 3; ++k) {
      if (near.at.part == edge_part(k)) {
        const Near* other = across(near, k);
        return other && dot(near.at.from, unit(near.at.normal) + unit(other->at.normal)) < 0;
      }
      if (near.at.part == corner_part(k)) {
        const std::int32_t site = corner_site(near.facet, k);
        return !CornerFan(surfaces_.position, site, surfaces_.fans.round(site), near.at.from).is_before();
      }
    }
    return false;
  }

  SurfaceFoot inner_foot(const Near& near) const {
    SurfaceFoot foot;
    for (int k = 0; k < 3; ++k)
      if (near.at.weight[k] != 0) foot.add(corner_site(near.facet, k), near.at.weight[k]);
    foot.distance = -norm(near.at.from);
    foot.normal = (1 / foot.distance) * near.at.from;
    return foot;
  }

  const Surfaces surfaces_;
  Vec3 p_;
  double square_ = 0;
  std::vector<Near> near_;
};

}  // namespace supple::smooth
