#include "supple/build/solid_bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "supple/build/surfaces.hpp"
#include "supple/core/error.hpp"
#include "supple/energy/element_strain.hpp"
#include "supple/geometry/facet.hpp"
#include "supple/geometry/hinge.hpp"
#include "supple/geometry/mesh_connections.hpp"
#include "supple/model/add_sites.hpp"
#include "supple/model/polygons.hpp"

namespace supple {

namespace {

using std::numbers::pi;

std::vector<Vec2> regular_polygon(int n) {
  if (n < 3)
    throw input_error(fmt::format("a polygon of {} vertices", n), "it encloses nothing", "give at least 3");
  const double radius = std::sqrt(2 / (n * std::sin(2 * pi / n)));
  std::vector<Vec2> ring;
  for (int k = 0; k < n; ++k) {
    const double angle = 2 * pi * k / n;
    ring.push_back(radius * Vec2{std::cos(angle), std::sin(angle)});
  }
  return ring;
}

template <int Dim>
std::vector<Vec<Dim>> boundary_nodes(const SolidMesh<Dim>& mesh) {
  return {mesh.node.begin(), mesh.node.begin() + mesh.boundary};
}

double mean_edge_of(const std::vector<Vec2>& ring) {
  double sum = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) sum += norm(ring[(k + 1) % ring.size()] - ring[k]);
  return sum / static_cast<double>(ring.size());
}

/// Adds the boundary as a body without shape energy; returns the diameter of its vertices.
double add_boundary(System<2>& system, const SolidMesh<2>& mesh, double diameter_ratio) {
  const std::vector<Vec2> ring = boundary_nodes(mesh);
  std::vector<double> length, angle;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Vec2 corner[3] = {ring[(k + ring.size() - 1) % ring.size()], ring[k], ring[(k + 1) % ring.size()]};
    length.push_back(norm(corner[2] - corner[1]));
    angle.push_back(hinge_angle(corner));
  }
  const double diameter = diameter_ratio * mean_edge_of(ring);
  add_ring(system, ring, 0.5 * diameter, {}, boundary_volume(mesh), length, angle);
  return diameter;
}
double add_boundary(System<3>& system, const SolidMesh<3>& mesh, double diameter_ratio) {
  const TriangleMesh surface{boundary_nodes(mesh), mesh.facet};
  const double diameter = diameter_ratio * mean_edge(surface);
  add_surface(system, surface, 0.5 * diameter, {}, boundary_volume(mesh), face_areas(surface),
              hinge_angles(surface));
  return diameter;
}

/// Adds sites to the last body.
template <int Dim>
void add_inside(System<Dim>& system, const SolidMesh<Dim>& mesh, double radius) {
  add_sites(system, std::vector<Vec<Dim>>(mesh.node.begin() + mesh.boundary, mesh.node.end()), radius);
  system.topology.begin.pop_back();
  system.topology.begin.back() = system.state.size();
}

/// Lists of the solid reach to the bodies before this one, which have no inside.
template <int Dim>
void fill_up(Solid<Dim>& solid, std::size_t bodies) {
  solid.stiffness.resize(bodies);
  solid.bond_begin.resize(bodies + 1, static_cast<std::int32_t>(solid.bond.size()));
  solid.element_begin.resize(bodies + 1, static_cast<std::int32_t>(solid.element.size()));
}

template <std::size_t N>
std::array<std::int32_t, N> from(std::int32_t first, std::array<std::int32_t, N> nodes) {
  for (std::int32_t& node : nodes) node += first;
  return nodes;
}

/// The ball that was made last in this thread: one of thousands of nodes takes a second, and is asked for by
/// its size, its radius and itself.
SolidMesh<3> ball_of_springs(int nodes, std::uint64_t seed) {
  struct Made {
    int nodes = 0;
    std::uint64_t seed = 0;
    SolidMesh<3> mesh;
  };
  static thread_local Made last;
  if (last.nodes != nodes || last.seed != seed) last = {nodes, seed, network_ball(nodes, 1, seed)};
  return last.mesh;
}

}  // namespace

template <int Dim>
SolidMesh<Dim> solid_mesh(const SolidSpec& spec, int vertices, std::uint64_t seed) {
  if constexpr (Dim == 2)
    return spec.filling == Filling::network ? network_disc(vertices, 1, seed)
                                            : star_mesh(std::span<const Vec2>(regular_polygon(vertices)));
  else
    return spec.filling == Filling::network ? ball_of_springs(vertices, seed)
                                            : star_mesh(geodesic_icosahedron(vertices));
}

template <int Dim>
void add_solid(System<Dim>& system, const SolidMesh<Dim>& mesh, double diameter_ratio,
               const SolidSpec& spec) {
  if (!(diameter_ratio > 0))
    throw input_error(fmt::format("a solid of vertex diameter {} edges", diameter_ratio),
                      "it must be positive");
  const std::int32_t first = system.state.size();
  const double diameter = add_boundary(system, mesh, diameter_ratio);
  add_inside(system, mesh, 0.5 * diameter);
  Solid<Dim>& solid = system.solid;
  const auto body = static_cast<std::size_t>(system.topology.body_count(system.state.size())) - 1;
  fill_up(solid, body);
  for (const auto& bond : mesh.bond) {
    solid.bond.push_back(from(first, bond));
    solid.rest_bond.push_back(norm(mesh.node[bond[1]] - mesh.node[bond[0]]));
  }
  LameConstants lame{};
  if (spec.filling == Filling::elements) lame = lame_constants<Dim>(spec.material);
  for (const auto& element : mesh.element) {
    Vec<Dim> x[Dim + 1];
    for (int a = 0; a <= Dim; ++a) x[a] = mesh.node[element[a]];
    const auto at_rest = ElementStrain<Dim>::at_rest(x, lame);
    Mat<Dim>& inverse = solid.rest_element.emplace_back();
    for (int a = 0; a < Dim; ++a)
      for (int d = 0; d < Dim; ++d) inverse[a][d] = at_rest.inverse[a * Dim + d];
    solid.element.push_back(from(first, element));
  }
  fill_up(solid, body + 1);
  SolidStiffness& k = solid.stiffness.back() = {0, lame.lambda, lame.mu};
  if (spec.filling == Filling::network)
    k.bond = spec.spring > 0 ? spec.spring : spec.material.young_modulus / affine_modulus(mesh, 1);
}

template <int Dim>
std::optional<ElasticConstants> nominal_constants(const System<Dim>& system, int b) {
  const Solid<Dim>& solid = system.solid;
  if (!solid.fills(b)) return std::nullopt;
  const SolidStiffness& k = solid.stiffness[b];
  if (k.mu > 0) return elastic_constants<Dim>(LameConstants{k.lambda, k.mu});
  double sum = 0;
  for (std::int32_t n = solid.bond_begin[b]; n < solid.bond_begin[b + 1]; ++n)
    sum += k.bond * solid.rest_bond[n] * solid.rest_bond[n];
  return affine_constants<Dim>(sum / system.shape.rest_volume[b]);
}

#define SUPPLE_SOLID(Dim)                                                                 \
  template SolidMesh<Dim> solid_mesh(const SolidSpec&, int, std::uint64_t);               \
  template void add_solid(System<Dim>&, const SolidMesh<Dim>&, double, const SolidSpec&); \
  template std::optional<ElasticConstants> nominal_constants(const System<Dim>&, int);
SUPPLE_SOLID(2)
SUPPLE_SOLID(3)
#undef SUPPLE_SOLID

}  // namespace supple
