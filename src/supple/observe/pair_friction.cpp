#include "supple/observe/pair_friction.hpp"

#include <cmath>

#include "supple/model/bodies.hpp"

namespace supple {

MutualForce force_on(const System<2>& system, const std::vector<SiteContact<2>>& contacts, int on, int by) {
  MutualForce pair;
  const Vec2 apart = body_centre(system, on) - body_centre(system, by);
  pair.distance = norm(apart);
  if (pair.distance > 0) pair.normal = (1 / pair.distance) * apart;
  for (const SiteContact<2>& c : contacts) {
    if (c.body == on && c.other_body == by) pair.force += c.force;
    else if (c.body == by && c.other_body == on) pair.force -= c.force;
    else continue;
    ++pair.contacts;
  }
  return pair;
}

std::optional<double> rough_friction_bound(double half_edge, double sigma) {
  if (!(half_edge < sigma)) return {};
  return half_edge / std::sqrt(sigma * sigma - half_edge * half_edge);
}

namespace {

/// Of the heights that are found, the greatest.
void raise(std::optional<double>& height, double found) {
  if (!height || found > *height) height = found;
}

/// A vertex at x on its way down to one edge of a ring, a to b, that looks up: where it is at `reach` from
/// the inner part of the edge.
std::optional<double> height_over_edge(double x, const Vec2& a, const Vec2& b, double reach) {
  const double length = norm(b - a);
  if (!(length > 0)) return {};
  const Vec2 along = (1 / length) * (b - a), outward{along[1], -along[0]};
  if (!(outward[1] > 0)) return {};
  const double y = a[1] + (reach - (x - a[0]) * outward[0]) / outward[1];
  const double foot = dot(Vec2{x, y} - a, along);
  if (foot < 0 || foot > length) return {};
  return y;
}

/// The height of the vertices of one ring over the edges of the other one; `turned`: upside down, for the
/// edges of the upper ring over the vertices of the lower.
void meet_edges(const TouchingRing& of_edges, const TouchingRing& of_vertices, bool turned, double reach,
                std::optional<double>& height) {
  const double sign = turned ? -1 : 1;
  const std::size_t n = of_edges.vertices.size();
  for (const Vec2& vertex : of_vertices.vertices)
    for (std::size_t k = 0; k < n; ++k) {
      const Vec2 a = sign * of_edges.vertices[k], b = sign * of_edges.vertices[(k + 1) % n];
      if (const auto y = height_over_edge(sign * vertex[0], a, b, reach))
        raise(height, *y - sign * vertex[1]);
    }
}

}  // namespace

std::optional<double> first_touch(const TouchingRing& lower, const TouchingRing& upper, Outline outline) {
  const double reach = lower.radius + upper.radius;
  std::optional<double> height;
  for (const Vec2& l : lower.vertices)
    for (const Vec2& u : upper.vertices)
      if (const double across = l[0] - u[0]; std::abs(across) < reach)
        raise(height, l[1] - u[1] + std::sqrt(reach * reach - across * across));
  if (outline == Outline::rough) return height;
  meet_edges(lower, upper, false, reach, height);
  meet_edges(upper, lower, true, reach, height);
  return height;
}

}  // namespace supple
