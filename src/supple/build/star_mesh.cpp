#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "supple/build/solids.hpp"
#include "supple/core/error.hpp"
#include "supple/geometry/facet.hpp"
#include "supple/geometry/mesh_fault.hpp"
#include "supple/geometry/star_surface.hpp"

namespace supple {

namespace {

template <int Dim>
using Facet = std::array<std::int32_t, Dim>;

/// Signed area (volume) of a facet and a point.
template <int Dim>
double volume_with(const std::vector<Vec<Dim>>& node, const Facet<Dim>& facet, const Vec<Dim>& point) {
  Vec<Dim> x[Dim];
  for (int k = 0; k < Dim; ++k) x[k] = node[static_cast<std::size_t>(facet[k])] - point;
  return facet_volume(x);
}

/// Centroid of what facets enclose: of the triangles (tetrahedra) that they form with the first node.
template <int Dim>
Vec<Dim> centroid(const std::vector<Vec<Dim>>& node, const std::vector<Facet<Dim>>& facets) {
  double volume = 0;
  Vec<Dim> moment;
  for (const auto& facet : facets) {
    const double part = volume_with<Dim>(node, facet, node[0]);
    volume += part;
    for (const std::int32_t i : facet)
      moment += part / (Dim + 1) * (node[static_cast<std::size_t>(i)] - node[0]);
  }
  return node[0] + (1 / volume) * moment;
}

/// Whether a boundary whose facets all face the centre goes round it once.
bool goes_round_once(const Vec2& centre, const SolidMesh<2>& mesh) {
  int crossings = 0;  // of the ray from the centre along x, each upward
  for (const auto& [i, j] : mesh.facet)
    crossings += mesh.node[static_cast<std::size_t>(i)][1] <= centre[1] &&
                 mesh.node[static_cast<std::size_t>(j)][1] > centre[1];
  return crossings == 1;
}
bool goes_round_once(const Vec3& centre, const SolidMesh<3>& mesh) {
  return is_seen_from(centre, mesh.node, mesh.facet);
}

/// The first facet that does not face the centre. It must be farther away from it than this share of its
/// size.
template <int Dim>
std::size_t first_hidden(const SolidMesh<Dim>& mesh, const Vec<Dim>& centre) {
  constexpr double least = 1e-9;
  const auto hidden = [&](const Facet<Dim>& facet) {
    double size = 1;
    for (const std::int32_t i : facet) size *= norm(mesh.node[static_cast<std::size_t>(i)] - centre);
    return !(volume_with<Dim>(mesh.node, facet, centre) > least * size);
  };
  return static_cast<std::size_t>(std::find_if(mesh.facet.begin(), mesh.facet.end(), hidden) -
                                  mesh.facet.begin());
}

/// Adds the centre and the elements about it to a mesh of a boundary.
template <int Dim>
SolidMesh<Dim> with_centre(SolidMesh<Dim> mesh) {
  const Vec<Dim> centre = centroid<Dim>(mesh.node, mesh.facet);
  const char *solid = Dim == 2 ? "an elastic polygon" : "an elastic solid",
             *to_do = "take a shape that its centroid sees from within, or a network of springs";
  const std::size_t hidden = first_hidden(mesh, centre);
  if (hidden < mesh.facet.size()) {
    std::string place;
    if constexpr (Dim == 2)
      place = fmt::format("vertex {} to vertex {}", mesh.facet[hidden][0], mesh.facet[hidden][1]);
    else
      place = fmt::format("vertices {}, {} and {}", mesh.facet[hidden][0], mesh.facet[hidden][1],
                          mesh.facet[hidden][2]);
    throw input_error(fmt::format("{} about its centroid", solid),
                      fmt::format("{} {}, from {}, does not face it: the shape is not star-shaped about it",
                                  Dim == 2 ? "edge" : "triangle", hidden, place),
                      to_do);
  }
  if (!goes_round_once(centre, mesh))
    throw input_error(fmt::format("{} about its centroid", solid),
                      "its boundary goes round this point more than once, and crosses itself", to_do);
  const auto number = static_cast<std::int32_t>(mesh.node.size());
  for (const auto& facet : mesh.facet) {
    std::array<std::int32_t, Dim + 1> element;
    std::copy(facet.begin(), facet.end(), element.begin());
    element[Dim] = number;
    mesh.element.push_back(element);
  }
  mesh.node.push_back(centre);
  return mesh;
}

}  // namespace

SolidMesh<2> star_mesh(std::span<const Vec2> polygon) {
  if (polygon.size() < 3)
    throw input_error(fmt::format("an elastic polygon of {} vertices", polygon.size()), "it has 3 or more");
  for (std::size_t k = 0; k < polygon.size(); ++k)
    if (!(std::abs(polygon[k][0]) < 1e100 && std::abs(polygon[k][1]) < 1e100))
      throw input_error(
          fmt::format("vertex {} of an elastic polygon at ({}, {})", k, polygon[k][0], polygon[k][1]),
          "this is no place");
  SolidMesh<2> mesh;
  mesh.node.assign(polygon.begin(), polygon.end());
  mesh.boundary = static_cast<int>(polygon.size());
  for (int k = 0; k < mesh.boundary; ++k) mesh.facet.push_back({k, (k + 1) % mesh.boundary});
  if (const double area = boundary_volume(mesh); !(area > 0))
    throw input_error(fmt::format("an elastic polygon of area {}", area), "it must be positive",
                      "order its vertices counter-clockwise");
  return with_centre(std::move(mesh));
}

SolidMesh<3> star_mesh(const TriangleMesh& surface) {
  require_sound(surface, "the surface of an elastic solid");
  SolidMesh<3> mesh;
  mesh.node = surface.vertex;
  mesh.boundary = static_cast<int>(surface.vertex.size());
  mesh.facet = surface.face;
  return with_centre(std::move(mesh));
}

}  // namespace supple
