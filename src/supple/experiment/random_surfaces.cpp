#include "supple/experiment/random_surfaces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "supple/core/error.hpp"
#include "supple/core/random.hpp"
#include "supple/experiment/random_centres.hpp"
#include "supple/model/rigid.hpp"

namespace supple {

namespace {

using std::numbers::pi;

/// Turns all vertices about the origin by a rotation drawn uniformly [Shoemake 1992].
void turn(std::vector<Vec3>& points, RandomStream& draw) {
  const double u = draw.uniform(0, 1), a = draw.uniform(0, 2 * pi), b = draw.uniform(0, 2 * pi);
  const Vec3 v{std::sqrt(1 - u) * std::cos(a), std::sqrt(u) * std::sin(b), std::sqrt(u) * std::cos(b)};
  const double w = std::sqrt(1 - u) * std::sin(a);
  for (Vec3& x : points) x += 2 * cross(v, cross(v, x) + w * x);
}

/// Pushes vertices toward and from the centre, by a hundredth at most, or a flat compressed surface would
/// stay one to rounding.
void push(TriangleMesh& mesh, RandomStream& draw) {
  for (Vec3& x : mesh.vertex) x += 0.01 * draw.uniform(-1, 1) * x;
}

void check(const SurfaceSample& s) {
  if (s.count < 1 || !(s.size_ratio > 0) || !(s.large_fraction >= 0 && s.large_fraction <= 1))
    throw input_error(fmt::format("{} particles of size ratio {}, {} of them large", s.count, s.size_ratio,
                                  s.large_fraction),
                      "there must be one, sizes are positive, and a share is from 0 to 1");
  if (!(s.packing_fraction > 0 && s.packing_fraction < 0.74))
    throw input_error(fmt::format("random particles at packing fraction {}", s.packing_fraction),
                      "spheres fill no more than 0.74 of a cell", "start at a lower one, and compress");
}

const double unit_radius = std::cbrt(3 / (4 * pi));  // of the sphere of volume 1

bool is_sphere(const SurfaceKind& kind) { return kind.vertices == 1; }

void add_solid_particle(const SurfaceKind& kind, int body, const Vec3& centre, std::int64_t seed,
                        RandomStream& draw, System<3>& system) {
  SolidMesh<3> mesh = solid_mesh<3>(*kind.solid, kind.vertices, network_seed(seed, body));
  turn(mesh.node, draw);
  for (Vec3& x : mesh.node) x = kind.diameter * x + centre;
  add_solid(system, mesh, kind.diameter_ratio, *kind.solid);
}

/// The surface of volume 1.
TriangleMesh unit_mesh(const SurfaceKind& kind) {
  if (kind.solid) {
    const SolidMesh<3> mesh =
        solid_mesh<3>(*kind.solid, kind.vertices, network_seed(1, 0));  // nearly as wide as others
    return {{mesh.node.begin(), mesh.node.begin() + mesh.boundary}, mesh.facet};
  }
  return is_sphere(kind) ? TriangleMesh{} : geodesic_icosahedron(kind.vertices);
}

/// Adds particle `body` of this kind about a centre.
void add_particle(const SurfaceKind& kind, const TriangleMesh& unit, int body, const Vec3& centre,
                  std::int64_t seed, System<3>& system) {
  if (is_sphere(kind)) return add_sphere_body(system, centre, kind.diameter * unit_radius);
  RandomStream draw(static_cast<std::uint64_t>(seed), Purpose::body_angle, static_cast<std::uint64_t>(body));
  if (kind.solid) return add_solid_particle(kind, body, centre, seed, draw, system);
  TriangleMesh mesh = unit;
  for (Vec3& x : mesh.vertex) x = kind.diameter * x;
  turn(mesh.vertex, draw);
  const auto first = static_cast<std::size_t>(system.state.size());
  add_surface(system, mesh, kind.diameter_ratio, kind.shape);
  const bool rigid = kind.motion == SurfaceMotion::rigid;
  if (!rigid && kind.shape.shape_parameter > 0) push(mesh, draw);
  for (std::size_t k = 0; k < mesh.vertex.size(); ++k)
    system.state.position[first + k] = mesh.vertex[k] + centre;
  if (rigid) make_rigid(system, body);
}

}  // namespace

std::vector<double> enclosing_radii(const std::vector<SurfaceKind>& kinds) {
  std::vector<double> radius;
  for (const SurfaceKind& kind : kinds) {
    const TriangleMesh unit = unit_mesh(kind);
    const double reach =
        is_sphere(kind) ? unit_radius : norm(unit.vertex[0]) + 0.5 * kind.diameter_ratio * mean_edge(unit);
    radius.insert(radius.end(), static_cast<std::size_t>(kind.count), kind.diameter * reach);
  }
  return radius;
}

System<3> surfaces_about(const std::vector<SurfaceKind>& kinds, const std::vector<Vec3>& centre,
                         const Box<3>& box, std::int64_t seed) {
  System<3> system;
  system.box = box;
  int body = 0;
  for (const SurfaceKind& kind : kinds) {
    const TriangleMesh unit = unit_mesh(kind);
    for (int k = 0; k < kind.count; ++k, ++body)
      add_particle(kind, unit, body, centre.at(static_cast<std::size_t>(body)), seed, system);
  }
  return system;
}

System<3> random_surfaces(const SurfaceSample& sample, const std::function<bool()>& stop_requested) {
  check(sample);
  SurfaceKind small{sample.count, sample.vertices, 1, sample.diameter_ratio, sample.shape, sample.motion},
      large = small;
  large.count = static_cast<int>(std::lround(sample.large_fraction * sample.count));
  large.diameter = sample.size_ratio;
  small.count -= large.count;
  const std::vector<SurfaceKind> kinds{small, large};
  const std::vector<double> radius = enclosing_radii(kinds);
  double enclosed = 0;
  for (const double r : radius) enclosed += 4 * pi / 3 * std::pow(r, 3);
  Box<3> box;
  const double length = std::cbrt(enclosed / sample.packing_fraction);
  box.length = {length, length, length};
  return surfaces_about(kinds, random_centres(radius, box, sample.seed, stop_requested), box, sample.seed);
}

}  // namespace supple
