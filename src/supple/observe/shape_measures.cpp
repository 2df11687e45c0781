#include "supple/observe/shape_measures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "supple/geometry/polygon.hpp"

namespace supple {

namespace {

using std::numbers::pi;

std::span<const Vec2> ring_of(const System<2>& system, int b) {
  return {&system.state.position[system.topology.body_begin(b)],
          static_cast<std::size_t>(system.topology.body_size(b))};
}

struct RingMeasures {
  double area = 0, perimeter = 0;
  Vec2 centre{};
};

/// By triangles from the first vertex.
RingMeasures measure(std::span<const Vec2> ring) {
  RingMeasures m;
  m.area = polygon_area(ring);
  Vec2 before = ring.back() - ring[0];
  for (const Vec2& vertex : ring) {
    const Vec2 here = vertex - ring[0];
    const double part = 0.5 * cross(before, here);
    m.centre += (part / 3) * (before + here);
    m.perimeter += norm(here - before);
    before = here;
  }
  m.centre = ring[0] + (1 / m.area) * m.centre;
  return m;
}

double reach_from(const Vec2& centre, std::span<const Vec2> ring) {
  double square = 0;
  for (const Vec2& x : ring) square = std::max(square, dot(x - centre, x - centre));
  return std::sqrt(square);
}

}  // namespace

ShapeMeasures measure_shapes(const System<2>& system) {
  ShapeMeasures out;
  for (int b = 0; b < system.topology.body_count(system.state.size()); ++b) {
    const std::span<const Vec2> ring = ring_of(system, b);
    if (ring.size() < 3) {
      const double radius = system.state.radius[system.topology.body_begin(b)];
      out.area.push_back(pi * radius * radius);
      out.perimeter.push_back(2 * pi * radius);
      out.shape_parameter.push_back(0);
      out.centre.push_back(ring[0]);
      continue;
    }
    const RingMeasures m = measure(ring);
    out.area.push_back(m.area);
    out.perimeter.push_back(m.perimeter);
    out.shape_parameter.push_back(m.perimeter * m.perimeter / (4 * pi * m.area));
    out.centre.push_back(m.centre);
  }
  return out;
}

std::vector<std::int32_t> bodies_inside_others(const System<2>& system) {
  const int bodies = system.topology.body_count(system.state.size());
  const ShapeMeasures shapes = measure_shapes(system);
  std::vector<double> reach;
  for (int b = 0; b < bodies; ++b) reach.push_back(reach_from(shapes.centre[b], ring_of(system, b)));
  const auto has_site_in = [&](int b, int other) {
    const std::span<const Vec2> ring = ring_of(system, other);
    if (ring.size() < 3) return false;
    const Vec2& centre = shapes.centre[other];
    for (const Vec2& x : ring_of(system, b)) {
      const Vec2 r = system.box.displacement(centre, x);
      if (dot(r, r) < reach[other] * reach[other] && encloses(ring, centre + r)) return true;
    }
    return false;
  };
  // Distances are exact up to half of the shortest length: larger bodies are looked at whatever their distance.
  const double exact = 0.5 * std::min(system.box.length[0], system.box.length[1]);
  const auto may_meet = [&](int a, int b) {
    const double sum = reach[a] + reach[b];
    return sum >= exact || norm(system.box.displacement(shapes.centre[a], shapes.centre[b])) < sum;
  };
  std::vector<std::int32_t> inside;
  for (int b = 0; b < bodies; ++b)
    for (int other = 0; other < bodies; ++other) {
      if (other == b || !may_meet(b, other) || !has_site_in(b, other)) continue;
      inside.push_back(b);
      break;
    }
  return inside;
}

}  // namespace supple
