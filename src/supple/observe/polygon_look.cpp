#include "supple/observe/polygon_look.hpp"

#include <algorithm>

#include "supple/geometry/inside.hpp"
#include "supple/geometry/polygon.hpp"
#include "supple/geometry/self_crossing.hpp"

namespace supple {

namespace {

/// Whether the open segments a b and c d cross. Those that only touch do not.
bool cross_each_other(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const Vec2 first = b - a, second = d - c;
  return cross(first, c - a) * cross(first, d - a) < 0 && cross(second, a - c) * cross(second, b - c) < 0;
}

Bounds bounds_of_ring(const BodyShape& shape) {
  Bounds bounds{shape.ring[0], shape.ring[0]};
  for (const Vec2& x : shape.ring) bounds.include(x);
  return bounds;
}

/// Whether a vertex of one body lies in the polygon of the other.
bool has_site_inside(const BodyShape& one, const Vec2& shift, const BodyShape& other, const Vec2& other_shift,
                     const Bounds& region) {
  if (other.is_disc()) return false;
  return std::any_of(one.ring.begin(), one.ring.end(), [&](const Vec2& site) {
    const Vec2 x = site + shift;
    return region.holds(x) && is_inside(x - other_shift, other.ring);
  });
}

}  // namespace

PolygonLook::PolygonLook(std::size_t bodies, const std::vector<BodyShape>& shapes, Outline outline)
    : shapes_(shapes), outline_(outline), tally_(bodies) {
  for (const BodyShape& shape : shapes) rings_.push_back(bounds_of_ring(shape));
}

void PolygonLook::alone(int b, const BodyShape& shape, double narrowest) {
  if (shape.is_disc()) return;
  tally_.count(b, &Soundness::turned_over, !(polygon_area(shape.ring) > 0));
  tally_.count(b, &Soundness::self_crossing, find_self_crossing(shape.ring).has_value());
  if (outline_ == Outline::smooth) return;
  bool open = false;
  double& longest = tally_.found.longest_edge;
  for (int k = 0; k < shape.size(); ++k) {
    const double length = norm(shape.ring[shape.next(k)] - shape.ring[k]);
    const double discs = shape.radius[k] + shape.radius[shape.next(k)];
    if (discs > 0) longest = std::max(longest, length / discs);
    open = open || length >= discs + narrowest;
  }
  tally_.count(b, &Soundness::open, open);
}

void PolygonLook::together(int a, const BodyImage& image) {
  const BodyShape &first = shapes_[a], &second = shapes_[image.body];
  if (first.is_disc() && second.is_disc()) {
    const double distance = norm(second.ring[0] + image.shift - first.ring[0]);
    return tally_.look_at_round(a, first.radius[0], image.body, second.radius[0], distance);
  }
  const Bounds other = rings_[image.body].shifted(image.shift);
  if (!rings_[a].meets(other)) return;
  const Bounds region = common_part(rings_[a], other);
  if (has_site_inside(first, {}, second, image.shift, region)) tally_.note_inside(a);
  if (has_site_inside(second, image.shift, first, {}, region)) tally_.note_inside(image.body);
  if (first.is_disc() || second.is_disc() || !boundaries_cross(first, second, image.shift, region)) return;
  tally_.note_crossing(a);
  tally_.note_crossing(image.body);
}

/// The edges of a displaced body that meet a region, from left to right.
void PolygonLook::edges_in(const BodyShape& shape, const Vec2& shift, const Bounds& region,
                           std::vector<Edge>& edges) {
  edges.clear();
  for (int k = 0; k < shape.size(); ++k) {
    const Vec2 from = shape.ring[k] + shift, to = shape.ring[shape.next(k)] + shift;
    Bounds bounds{from, from};
    bounds.include(to);
    if (bounds.meets(region)) edges.push_back({from, to, bounds});
  }
  std::sort(edges.begin(), edges.end(),
            [](const Edge& a, const Edge& b) { return a.bounds.low[0] < b.bounds.low[0]; });
}

bool PolygonLook::boundaries_cross(const BodyShape& first, const BodyShape& second, const Vec2& shift,
                                   const Bounds& region) {
  edges_in(first, {}, region, first_);
  edges_in(second, shift, region, second_);
  for (const Edge& a : first_)
    for (const Edge& b : second_) {
      if (b.bounds.low[0] > a.bounds.high[0]) break;
      if (a.bounds.meets(b.bounds) && cross_each_other(a.from, a.to, b.from, b.to)) return true;
    }
  return false;
}

}  // namespace supple
