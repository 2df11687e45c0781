#include "supple/build/surfaces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include "supple/core/error.hpp"
#include "supple/model/add_sites.hpp"

namespace supple {

namespace {

using Edge = std::array<std::int32_t, 2>;

TriangleMesh icosahedron() {
  const double g = std::numbers::phi;
  return {{{-1, g, 0},
           {1, g, 0},
           {-1, -g, 0},
           {1, -g, 0},
           {0, -1, g},
           {0, 1, g},
           {0, -1, -g},
           {0, 1, -g},
           {g, 0, -1},
           {g, 0, 1},
           {-g, 0, -1},
           {-g, 0, 1}},
          {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
           {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
           {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
}

void put_on_sphere(TriangleMesh& mesh) {
  for (Vec3& x : mesh.vertex) x = (1 / norm(x)) * x;
}

/// Each triangle cut into four by the middles of its edges.
TriangleMesh refined(const TriangleMesh& mesh) {
  TriangleMesh fine{mesh.vertex, {}};
  std::map<Edge, std::int32_t> middles;
  const auto middle = [&](std::int32_t a, std::int32_t b) {
    const auto [at, is_new] =
        middles.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<std::int32_t>(fine.vertex.size()));
    if (is_new) fine.vertex.push_back(0.5 * (mesh.vertex[a] + mesh.vertex[b]));
    return at->second;
  };
  for (const auto& [a, b, c] : mesh.face) {
    const std::int32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    fine.face.insert(fine.face.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
  }
  return fine;
}

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

}  // namespace

ShapeStiffness absolute_stiffness(const ShapeSpec& shape, double v0, const std::vector<double>& a0) {
  if (shape.kind == StiffnessKind::absolute) return {shape.area, shape.length, shape.bending, shape.tension};
  const double s0 = sum(a0), mean = s0 / static_cast<double>(a0.size());
  return {shape.area / (v0 * v0), shape.length / (mean * mean), shape.bending, shape.tension / s0};
}

int nearest_geodesic(int vertices) {
  int below = 12;
  for (int next = 42; next <= vertices; next = 4 * next - 6) below = next;
  const int above = vertices < below ? below : 4 * below - 6;
  return vertices - below < above - vertices ? below : above;
}

TriangleMesh geodesic_icosahedron(int vertices, double volume) {
  if (!(volume > 0)) throw input_error(fmt::format("a surface of volume {}", volume), "it must be positive");
  if (const int nearest = nearest_geodesic(vertices); nearest != vertices)
    throw input_error(
        fmt::format("a geodesic sphere of {} vertices", vertices),
        "an icosahedron whose triangles are cut into four again and again has 12, 42, 162, 642 ...",
        fmt::format("take {}", nearest));
  TriangleMesh mesh = icosahedron();
  put_on_sphere(mesh);
  while (static_cast<int>(mesh.vertex.size()) < vertices) {
    mesh = refined(mesh);
    put_on_sphere(mesh);
  }
  const double scale = std::cbrt(volume / enclosed_volume(mesh));
  for (Vec3& x : mesh.vertex) x = scale * x;
  return mesh;
}

void add_surface(System<3>& system, const TriangleMesh& mesh, double radius, const ShapeStiffness& stiffness,
                 double rest_volume, const std::vector<double>& rest_area,
                 const std::vector<double>& rest_angle) {
  std::vector<std::array<std::int32_t, 4>> hinges = hinges_of(mesh);
  if (mesh.face.empty() || rest_area.size() != mesh.face.size() || rest_angle.size() != hinges.size())
    throw input_error(
        fmt::format("a surface of {} triangles and {} edges with {} rest areas and {} rest angles",
                    mesh.face.size(), hinges.size(), rest_area.size(), rest_angle.size()),
        "they do not match");
  begin_bodies(system);
  const std::int32_t first = system.state.size();
  add_sites(system, mesh.vertex, radius);
  Topology<3>& t = system.topology;
  for (auto face : mesh.face) {
    for (std::int32_t& site : face) site += first;
    t.facet.push_back(face);
  }
  for (auto& hinge : hinges) {
    for (std::int32_t& site : hinge) site += first;
    t.hinge.push_back(hinge);
  }
  t.facet_begin.push_back(static_cast<std::int32_t>(t.facet.size()));
  t.hinge_begin.push_back(static_cast<std::int32_t>(t.hinge.size()));
  Shape& shape = system.shape;
  shape.stiffness.push_back(stiffness);
  shape.rest_volume.push_back(rest_volume);
  shape.rest_facet.insert(shape.rest_facet.end(), rest_area.begin(), rest_area.end());
  shape.rest_hinge.insert(shape.rest_hinge.end(), rest_angle.begin(), rest_angle.end());
}

void add_surface(System<3>& system, const TriangleMesh& mesh, double diameter_ratio, const ShapeSpec& shape) {
  if (!(diameter_ratio > 0))
    throw input_error(fmt::format("a surface of vertex diameter {} edges", diameter_ratio),
                      "it must be positive");
  std::vector<double> areas = face_areas(mesh);
  const double volume = enclosed_volume(mesh), own = surface_shape_parameter(sum(areas), volume);
  if (!(volume > 0))
    throw input_error(fmt::format("a surface that encloses the volume {}", volume),
                      "its triangles look inward, or it encloses nothing",
                      "order the corners of every triangle counter-clockwise as seen from outside");
  if (shape.shape_parameter > 0) {
    const double scale = std::pow(shape.shape_parameter / own, 2.0 / 3);
    for (double& a : areas) a *= scale;
  }
  add_surface(system, mesh, 0.5 * diameter_ratio * mean_edge(mesh), absolute_stiffness(shape, volume, areas),
              volume, areas, hinge_angles(mesh));
}

TriangleMesh mesh_of(const System<3>& system, int b) {
  const Topology<3>& t = system.topology;
  const auto first = t.body_begin(b);
  TriangleMesh mesh;
  for (int i = first; i < t.body_end(b); ++i) mesh.vertex.push_back(system.state.position[i]);
  for (std::int32_t f = t.facet_begin[b]; f < t.facet_begin[b + 1]; ++f)
    mesh.face.push_back({t.facet[f][0] - first, t.facet[f][1] - first, t.facet[f][2] - first});
  return mesh;
}

void add_sphere_body(System<3>& system, const Vec3& centre, double radius) {
  add_round_body(system, centre, radius);
}

}  // namespace supple
