#include "supple/experiment/random_surfaces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "supple/core/error.hpp"
#include "supple/core/random.hpp"
#include "supple/experiment/random_centres.hpp"

namespace supple {

namespace {

using std::numbers::pi;

/// Turns all vertices about the origin by a rotation drawn uniformly [Shoemake 1992].
void turn(TriangleMesh& mesh, RandomStream& draw) {
  const double u = draw.uniform(0, 1), a = draw.uniform(0, 2 * pi), b = draw.uniform(0, 2 * pi);
  const Vec3 v{std::sqrt(1 - u) * std::cos(a), std::sqrt(u) * std::sin(b), std::sqrt(u) * std::cos(b)};
  const double w = std::sqrt(1 - u) * std::sin(a);
  for (Vec3& x : mesh.vertex) x += 2 * cross(v, cross(v, x) + w * x);
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

}  // namespace

System<3> random_surfaces(const SurfaceSample& sample, const std::function<bool()>& stop_requested) {
  check(sample);
  const auto large = static_cast<int>(std::lround(sample.large_fraction * sample.count));
  const bool round = sample.vertices == 1;
  const TriangleMesh unit = round ? TriangleMesh{} : geodesic_icosahedron(sample.vertices);
  const double sphere = std::cbrt(3 / (4 * pi));  // radius of volume 1
  const double reach = round ? sphere : norm(unit.vertex[0]) + 0.5 * sample.diameter_ratio * mean_edge(unit);
  std::vector<double> size, radius;
  double enclosed = 0;
  for (int b = 0; b < sample.count; ++b) {
    size.push_back(b < sample.count - large ? 1 : sample.size_ratio);
    radius.push_back(size.back() * reach);
    enclosed += 4 * pi / 3 * std::pow(radius.back(), 3);
  }
  System<3> system;
  const double length = std::cbrt(enclosed / sample.packing_fraction);
  system.box.length = {length, length, length};
  const std::vector<Vec3> centre = random_centres(radius, system.box, sample.seed, stop_requested);
  for (int b = 0; b < sample.count; ++b) {
    if (round) {
      add_sphere_body(system, centre[b], radius[b]);
      continue;
    }
    RandomStream draw(static_cast<std::uint64_t>(sample.seed), Purpose::body_angle,
                      static_cast<std::uint64_t>(b));
    TriangleMesh mesh = unit;
    for (Vec3& x : mesh.vertex) x = size[b] * x;
    turn(mesh, draw);
    add_surface(system, mesh, sample.diameter_ratio, sample.shape);
    const auto first = static_cast<std::size_t>(system.topology.begin[b]);
    if (sample.shape.shape_parameter > 0) push(mesh, draw);
    for (std::size_t k = 0; k < mesh.vertex.size(); ++k)
      system.state.position[first + k] = mesh.vertex[k] + centre[b];
  }
  return system;
}

}  // namespace supple
