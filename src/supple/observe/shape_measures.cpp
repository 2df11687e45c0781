#include "supple/observe/shape_measures.hpp"

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

std::optional<double> mean_shape_parameter(const ShapeMeasures& shapes) {
  double sum = 0, polygons = 0;
  for (const double a : shapes.shape_parameter)
    if (a > 0) sum += a, ++polygons;
  if (polygons == 0) return std::nullopt;
  return sum / polygons;
}

}  // namespace supple
