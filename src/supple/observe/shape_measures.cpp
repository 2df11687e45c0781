#include "supple/observe/shape_measures.hpp"

#include <cmath>
#include <numbers>
#include <span>

#include "supple/geometry/facet.hpp"
#include "supple/geometry/mesh_measures.hpp"
#include "supple/geometry/polygon.hpp"

namespace supple {

namespace {

using std::numbers::pi;

template <int Dim>
struct BodyMeasures {
  double volume = 0, surface = 0, shape_parameter = 0;
  Vec<Dim> centre{};
};

/// By triangles from the first vertex.
BodyMeasures<2> measure_many(const System<2>& system, int b) {
  const std::span<const Vec2> ring{&system.state.position[system.topology.body_begin(b)],
                                   static_cast<std::size_t>(system.topology.boundary_size(b))};
  BodyMeasures<2> m;
  m.volume = polygon_area(ring);
  Vec2 before = ring.back() - ring[0];
  for (const Vec2& vertex : ring) {
    const Vec2 here = vertex - ring[0];
    const double part = 0.5 * cross(before, here);
    m.centre += (part / 3) * (before + here);
    m.surface += norm(here - before);
    before = here;
  }
  m.centre = ring[0] + (1 / m.volume) * m.centre;
  m.shape_parameter = m.surface * m.surface / (4 * pi * m.volume);
  return m;
}

/// By tetrahedra from the first vertex.
BodyMeasures<3> measure_many(const System<3>& system, int b) {
  const std::vector<Vec3>& position = system.state.position;
  const Topology<3>& t = system.topology;
  const Vec3 origin = position[t.body_begin(b)];
  BodyMeasures<3> m;
  for (int f = t.facet_begin[b]; f < t.facet_begin[b + 1]; ++f) {
    Vec3 x[3];
    for (int k = 0; k < 3; ++k) x[k] = position[t.facet[f][k]] - origin;
    const double part = facet_volume(x);
    m.volume += part;
    m.surface += facet_measure(x);
    m.centre += (part / 4) * (x[0] + x[1] + x[2]);
  }
  m.centre = origin + (1 / m.volume) * m.centre;
  m.shape_parameter = surface_shape_parameter(m.surface, m.volume);
  return m;
}

BodyMeasures<2> measure_one(double r, const Vec2& centre) { return {pi * r * r, 2 * pi * r, 0, centre}; }
BodyMeasures<3> measure_one(double r, const Vec3& centre) {
  return {4 * pi / 3 * r * r * r, 4 * pi * r * r, 0, centre};
}

template <int Dim>
ShapeMeasures<Dim> measure_all(const System<Dim>& system) {
  ShapeMeasures<Dim> out;
  const Topology<Dim>& t = system.topology;
  for (int b = 0; b < t.body_count(system.state.size()); ++b) {
    const int first = t.body_begin(b);
    const BodyMeasures<Dim> m = t.body_size(b) < 3
                                    ? measure_one(system.state.radius[first], system.state.position[first])
                                    : measure_many(system, b);
    out.volume.push_back(m.volume);
    out.surface.push_back(m.surface);
    out.shape_parameter.push_back(m.shape_parameter);
    out.centre.push_back(m.centre);
  }
  return out;
}

}  // namespace

ShapeMeasures<2> measure_shapes(const System<2>& system) { return measure_all(system); }
ShapeMeasures<3> measure_shapes(const System<3>& system) { return measure_all(system); }

}  // namespace supple
