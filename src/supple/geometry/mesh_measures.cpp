#include "supple/geometry/mesh_measures.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <numbers>

#include "supple/core/error.hpp"
#include "supple/geometry/facet.hpp"
#include "supple/geometry/hinge.hpp"

namespace supple {

namespace {

using Edge = std::array<std::int32_t, 2>;

/// The corners of a facet or a hinge.
template <std::size_t N>
void gather(const TriangleMesh& mesh, const std::array<std::int32_t, N>& sites, Vec3 (&x)[N]) {
  for (std::size_t k = 0; k < N; ++k) x[k] = mesh.vertex[sites[k]];
}

}  // namespace

double enclosed_volume(const TriangleMesh& mesh) {
  // About a vertex, so that a surface far from the origin loses no digits.
  double volume = 0;
  for (const auto& face : mesh.face) {
    Vec3 x[3];
    gather(mesh, face, x);
    for (Vec3& p : x) p -= mesh.vertex[0];
    volume += facet_volume(x);
  }
  return volume;
}

std::vector<double> face_areas(const TriangleMesh& mesh) {
  std::vector<double> areas;
  for (const auto& face : mesh.face) {
    Vec3 x[3];
    gather(mesh, face, x);
    areas.push_back(facet_measure(x));
  }
  return areas;
}

std::vector<double> hinge_angles(const TriangleMesh& mesh) {
  std::vector<double> angles;
  for (const auto& hinge : hinges_of(mesh)) {
    Vec3 x[4];
    gather(mesh, hinge, x);
    angles.push_back(hinge_angle(x));
  }
  return angles;
}

double mean_edge(const TriangleMesh& mesh) {
  double length = 0;
  for (const auto& f : mesh.face)
    for (std::size_t k = 0; k < 3; ++k) length += norm(mesh.vertex[f[(k + 1) % 3]] - mesh.vertex[f[k]]);
  return length / (3 * static_cast<double>(mesh.face.size()));
}

std::vector<std::array<std::int32_t, 4>> hinges_of(const TriangleMesh& mesh) {
  std::map<Edge, std::int32_t> opposite;  // of each directed edge, the third corner of its triangle
  for (const auto& f : mesh.face)
    for (std::size_t k = 0; k < 3; ++k) {
      const Edge edge{f[k], f[(k + 1) % 3]};
      if (!opposite.try_emplace(edge, f[(k + 2) % 3]).second)
        throw input_error(fmt::format("two triangles have the edge from vertex {} to {}", edge[0], edge[1]),
                          "the surface is not closed, or some triangles are turned over",
                          "order the corners of every triangle counter-clockwise as seen from outside");
    }
  std::vector<std::array<std::int32_t, 4>> hinges;
  for (const auto& f : mesh.face)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t a = f[k], b = f[(k + 1) % 3];
      const auto other = opposite.find({b, a});
      if (other == opposite.end())
        throw input_error(fmt::format("one triangle alone has the edge of vertices {} and {}", a, b),
                          "the surface has a hole", "close it");
      if (a < b) hinges.push_back({a, b, f[(k + 2) % 3], other->second});
    }
  return hinges;
}

double surface_shape_parameter(double area, double volume) {
  return area * std::sqrt(area) / (6 * std::sqrt(std::numbers::pi) * volume);
}

}  // namespace supple
