#include "supple/build/solids.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tuple>

#include "supple/core/error.hpp"
#include "supple/core/random.hpp"
#include "supple/energy/elastic_constants.hpp"
#include "supple/geometry/delaunay.hpp"
#include "supple/geometry/facet.hpp"
#include "supple/geometry/simplex.hpp"

namespace supple {

namespace {

using std::numbers::pi;

/// Uniform in the ball of radius 1 about the origin.
template <int Dim>
Vec<Dim> point_in_ball(RandomStream& draw) {
  Vec<Dim> x;
  do
    for (int d = 0; d < Dim; ++d) x[d] = draw.uniform(-1, 1);
  while (dot(x, x) > 1);
  return x;
}

/// Uniform on the sphere of radius 1.
Vec3 point_on_sphere(RandomStream& draw) {
  for (;;) {
    const Vec3 x = point_in_ball<3>(draw);
    if (const double r = norm(x); r > 0.01) return (1 / r) * x;
  }
}

/// Adds points from `next` up to this many in all, none nearer to another than a gap [length], which begins
/// with this one and shrinks when no more points fit: about as evenly as random points can be.
template <int Dim, class Next>
void scatter(std::vector<Vec<Dim>>& points, std::size_t count, double gap, const Next& next) {
  constexpr int patience = 30;
  for (int failures = 0; points.size() < count;) {
    const Vec<Dim> x = next();
    const bool fits = std::all_of(points.begin(), points.end(),
                                  [&](const Vec<Dim>& y) { return dot(x - y, x - y) > gap * gap; });
    if (fits) points.push_back(x);
    failures = fits ? 0 : failures + 1;
    if (failures == patience) {
      gap *= 0.97;
      failures = 0;
    }
  }
}

template <int Dim, std::size_t N>
std::array<Vec<Dim>, N> corners(const std::vector<Vec<Dim>>& node, const std::array<std::int32_t, N>& of) {
  std::array<Vec<Dim>, N> x;
  for (std::size_t k = 0; k < N; ++k) x[k] = node[static_cast<std::size_t>(of[k])];
  return x;
}

template <int Dim>
double measure(const std::array<Vec<Dim>, Dim + 1>& x) {
  Vec<Dim> edges[Dim];
  for (int k = 0; k < Dim; ++k) edges[k] = x[k] - x[Dim];
  return facet_volume(edges);
}
template <int Dim>
double measure(const std::array<Vec<Dim>, Dim>& x) {
  Vec<Dim> points[Dim];
  std::copy(x.begin(), x.end(), points);
  return facet_measure(points);
}

/// Adds to each node the centroids of pieces that it is a corner of, weighted by their measures.
template <int Dim>
class Centroids {
 public:
  explicit Centroids(std::size_t nodes) : sum_(nodes), weight_(nodes) {}

  template <std::size_t N>
  void add(const std::vector<Vec<Dim>>& node, const std::vector<std::array<std::int32_t, N>>& pieces) {
    for (const auto& piece : pieces) {
      const auto x = corners(node, piece);
      const double weight = measure<Dim>(x);
      const Vec<Dim> moment = (weight / N) * std::accumulate(x.begin(), x.end(), Vec<Dim>{});
      for (const std::int32_t i : piece) {
        sum_[static_cast<std::size_t>(i)] += moment;
        weight_[static_cast<std::size_t>(i)] += weight;
      }
    }
  }
  Vec<Dim> operator[](std::size_t i) const { return (1 / weight_[i]) * sum_[i]; }

 private:
  std::vector<Vec<Dim>> sum_;
  std::vector<double> weight_;
};

/// Makes the triangles or tetrahedra about nodes in a ball of radius 1 more alike: each node within goes to
/// the centroid of those that it is a corner of, each of the first `boundary` ones to that of its facets of
/// the boundary, and back to the sphere. Returns the triangulation of the last nodes.
template <int Dim>
DelaunayMesh<Dim> relax(std::vector<Vec<Dim>>& node, std::size_t boundary, int turns) {
  for (int turn = 0; turn < turns; ++turn) {
    const DelaunayMesh<Dim> mesh = delaunay<Dim>(node);
    Centroids<Dim> within(node.size()), along(node.size());
    within.add(node, mesh.simplex);
    along.add(node, mesh.hull);
    for (std::size_t i = 0; i < node.size(); ++i) {
      if (i >= boundary) {
        node[i] = within[i];
      } else if constexpr (Dim == 3) {  // the corners of a regular polygon are even
        const Vec<Dim> x = along[i];
        node[i] = (1 / norm(x)) * x;
      }
    }
  }
  return delaunay<Dim>(node);
}

/// All edges of these triangles or tetrahedra, ascending.
template <std::size_t N>
std::vector<std::array<std::int32_t, 2>> edges_of(const std::vector<std::array<std::int32_t, N>>& pieces) {
  std::vector<std::array<std::int32_t, 2>> edges;
  for (const auto& piece : pieces)
    for (std::size_t a = 0; a < N; ++a)
      for (std::size_t b = 0; b < a; ++b)
        edges.push_back({std::min(piece[a], piece[b]), std::max(piece[a], piece[b])});
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

void require_network(int nodes, int least, double volume, const char* what) {
  if (nodes < least)
    throw input_error(fmt::format("a network of {} nodes in a {}", nodes, what), "it has too few",
                      fmt::format("take {} or more", least));
  if (!(volume > 0 && volume < 1e300))
    throw input_error(fmt::format("a {} of size {}", what, volume), "it must be positive");
}

/// The hull must have all of the nodes on the boundary.
template <int Dim>
void require_hull(const DelaunayMesh<Dim>& mesh, int boundary) {
  const auto expected = static_cast<std::size_t>(Dim == 2 ? boundary : 2 * boundary - 4);
  if (mesh.hull.size() != expected)
    throw input_error(fmt::format("a network with {} nodes on its boundary", boundary),
                      "these lie too close to tell on which side of each other they are", "take fewer nodes");
}

template <int Dim>
void scale_to(SolidMesh<Dim>& mesh, double volume) {
  const double grown = volume / boundary_volume(mesh), scale = Dim == 2 ? std::sqrt(grown) : std::cbrt(grown);
  for (Vec<Dim>& x : mesh.node) x = scale * x;
}

/// Nodes on the circle of a disc. The number of triangles, 2 nodes - boundary - 2, gives the edge of
/// equilateral triangles that would fill the disc; the edges of the boundary are longer by a factor which
/// makes them 100 of 1100, as published.
int nodes_on_circle(int nodes) {
  constexpr double published = 0.94, c = pi * std::numbers::sqrt3;
  return static_cast<int>(std::lround(published * 0.5 * (std::sqrt(c * c + 8 * c * (nodes - 1)) - c)));
}

/// Distance between neighbours in a ball of radius 1, where each node within has the volume 0.75 s^3 (between
/// the closest packing, s^3/sqrt 2, and the body-centred lattice, 0.77 s^3) and one on the sphere half of it.
double spacing_in_ball(int nodes, int boundary) {
  return std::cbrt(4 * pi / 3 / (0.75 * (nodes - 0.5 * boundary)));
}

/// Nodes on the sphere of a ball, so that the edges of their triangles, equilateral, would be as long.
int nodes_on_sphere(int nodes) {
  int boundary = 0;
  for (int turn = 0; turn < 50; ++turn) {
    const double s = spacing_in_ball(nodes, boundary);
    boundary = std::min(nodes - 1, 2 + static_cast<int>(std::lround(8 * pi / (std::numbers::sqrt3 * s * s))));
  }
  return boundary;
}

/// The edges, and the shortest of all other pairs up to this number of bonds, ascending.
std::vector<std::array<std::int32_t, 2>> nearest_pairs(const std::vector<Vec3>& node,
                                                       const std::vector<std::array<std::int32_t, 2>>& edges,
                                                       std::size_t count) {
  std::vector<std::tuple<double, std::int32_t, std::int32_t>> pairs;
  // A cutoff that surely holds enough of them: in the bulk a node has 4 pi r^3/3 neighbours per its volume,
  // at the surface half of these.
  const auto n = static_cast<std::int32_t>(node.size());
  double reach = 1.5 * std::cbrt(2 * static_cast<double>(count) / n / n);
  const std::size_t all = node.size() * (node.size() - 1) / 2;
  while (pairs.size() < std::min(all, count + edges.size())) {
    pairs.clear();
    reach *= 1.2;
    for (std::int32_t i = 0; i < n; ++i)
      for (std::int32_t j = i + 1; j < n; ++j) {
        const Vec3 r = node[static_cast<std::size_t>(j)] - node[static_cast<std::size_t>(i)];
        if (const double square = dot(r, r); square < reach * reach) pairs.emplace_back(square, i, j);
      }
  }
  std::sort(pairs.begin(), pairs.end());
  std::vector<std::array<std::int32_t, 2>> bonds = edges;
  for (const auto& [square, i, j] : pairs) {
    if (bonds.size() == count) break;
    const std::array<std::int32_t, 2> pair{i, j};
    if (!std::binary_search(edges.begin(), edges.end(), pair)) bonds.push_back(pair);
  }
  std::sort(bonds.begin(), bonds.end());
  return bonds;
}

}  // namespace

template <int Dim>
double coordination(const SolidMesh<Dim>& mesh) {
  return mesh.node.empty()
             ? 0
             : 2.0 * static_cast<double>(mesh.bond.size()) / static_cast<double>(mesh.node.size());
}

template <int Dim>
double boundary_volume(const SolidMesh<Dim>& mesh) {
  double sum = 0;
  for (const auto& facet : mesh.facet) {
    Vec<Dim> x[Dim];
    for (int k = 0; k < Dim; ++k) x[k] = mesh.node[static_cast<std::size_t>(facet[k])] - mesh.node[0];
    sum += facet_volume(x);
  }
  return sum;
}

SolidMesh<2> network_disc(int nodes, double area, std::uint64_t seed) {
  require_network(nodes, 7, area, "disc");
  SolidMesh<2> mesh;
  mesh.boundary = nodes_on_circle(nodes);
  for (int k = 0; k < mesh.boundary; ++k) {
    const double angle = 2 * pi * k / mesh.boundary;
    mesh.node.push_back({std::cos(angle), std::sin(angle)});
    mesh.facet.push_back({k, (k + 1) % mesh.boundary});
  }
  RandomStream draw(seed, Purpose::solid_node);
  const double spacing = 2 * pi / mesh.boundary;
  scatter(mesh.node, static_cast<std::size_t>(nodes), spacing,
          [&] { return (1 - 0.7 * spacing) * point_in_ball<2>(draw); });
  DelaunayMesh<2> found = relax(mesh.node, static_cast<std::size_t>(mesh.boundary), 10);
  require_hull(found, mesh.boundary);
  mesh.element = std::move(found.simplex);
  mesh.bond = edges_of(mesh.element);
  scale_to(mesh, area);
  return mesh;
}

SolidMesh<3> network_ball(int nodes, double volume, std::uint64_t seed, double wanted) {
  require_network(nodes, 13, volume, "ball");
  SolidMesh<3> mesh;
  mesh.boundary = nodes_on_sphere(nodes);
  const double bonds = std::round(0.5 * wanted * nodes);
  if (!(wanted >= 6 && wanted <= nodes - 1 && bonds >= 3 * mesh.boundary - 6))
    throw input_error(fmt::format("a network of {} nodes with a coordination of {}", nodes, wanted),
                      fmt::format("it can be from 6, below which nothing is stiff, to {}", nodes - 1));
  RandomStream draw(seed, Purpose::solid_node);
  const double spacing = spacing_in_ball(nodes, mesh.boundary);
  scatter(mesh.node, static_cast<std::size_t>(mesh.boundary), spacing, [&] { return point_on_sphere(draw); });
  scatter(mesh.node, static_cast<std::size_t>(nodes), spacing,
          [&] { return (1 - 0.7 * spacing) * point_in_ball<3>(draw); });
  DelaunayMesh<3> found = relax(mesh.node, static_cast<std::size_t>(mesh.boundary), 10);
  require_hull(found, mesh.boundary);
  mesh.facet = std::move(found.hull);
  mesh.element = std::move(found.simplex);
  const auto edges = edges_of(mesh.facet);
  mesh.bond = nearest_pairs(mesh.node, edges, static_cast<std::size_t>(bonds));
  scale_to(mesh, volume);
  return mesh;
}

template <int Dim>
double affine_modulus(const SolidMesh<Dim>& mesh, double stiffness) {
  double sum = 0;
  for (const auto& [i, j] : mesh.bond) {
    const Vec<Dim> r = mesh.node[static_cast<std::size_t>(j)] - mesh.node[static_cast<std::size_t>(i)];
    sum += stiffness * dot(r, r);
  }
  return affine_constants<Dim>(sum / boundary_volume(mesh)).young_modulus;
}

template double coordination(const SolidMesh<2>&);
template double coordination(const SolidMesh<3>&);
template double boundary_volume(const SolidMesh<2>&);
template double boundary_volume(const SolidMesh<3>&);
template double affine_modulus(const SolidMesh<2>&, double);
template double affine_modulus(const SolidMesh<3>&, double);

}  // namespace supple
