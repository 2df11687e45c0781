#include "supple/geometry/mesh_connections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <tuple>

#include "supple/core/disjoint_sets.hpp"

namespace supple {

namespace {

using Edges = std::vector<EdgeOfFace>;

bool same_edge(const EdgeOfFace& a, const EdgeOfFace& b) { return a.low == b.low && a.high == b.high; }

/// visit(first, count) for each edge of the mesh: its rows in the sorted list.
template <class Visit>
void for_edges(const Edges& edges, const Visit& visit) {
  for (std::size_t k = 0; k < edges.size();) {
    std::size_t end = k + 1;
    while (end < edges.size() && same_edge(edges[k], edges[end])) ++end;
    visit(&edges[k], end - k);
    k = end;
  }
}

std::optional<MeshFault> find_repeated_triangle(const TriangleMesh& mesh) {
  std::vector<std::pair<std::array<std::int32_t, 3>, std::int32_t>> sorted;
  for (std::size_t f = 0; f < mesh.face.size(); ++f) {
    sorted.emplace_back(mesh.face[f], static_cast<std::int32_t>(f));
    std::sort(sorted.back().first.begin(), sorted.back().first.end());
  }
  std::sort(sorted.begin(), sorted.end());
  const auto at = std::adjacent_find(sorted.begin(), sorted.end(),
                                     [](const auto& a, const auto& b) { return a.first == b.first; });
  if (at == sorted.end()) return std::nullopt;
  const auto& [a, b, c] = at->first;
  const std::int32_t first = at->second, second = (at + 1)->second;
  return MeshFault{
      MeshFaultKind::repeated_triangle,
      fmt::format("triangles {} and {} have the same corners {}, {} and {}", first, second, a, b, c),
      "each triangle must be listed once",
      fmt::format("remove triangle {}", second),
      {a, b, c},
      {first, second}};
}

std::optional<MeshFault> find_border(const Edges& edges) {
  std::size_t count = 0;
  const EdgeOfFace* first = nullptr;
  for_edges(edges, [&](const EdgeOfFace* edge, std::size_t faces) {
    if (faces != 1) return;
    if (count++ == 0) first = edge;
  });
  if (count == 0) return std::nullopt;
  return MeshFault{
      MeshFaultKind::border_edge,
      count == 1
          ? fmt::format("the edge of vertices {} and {} belongs to triangle {} alone", first->low,
                        first->high, first->face)
          : fmt::format("{} edges belong to one triangle alone, the first of them, of vertices {} and {}, "
                        "to triangle {}",
                        count, first->low, first->high, first->face),
      "the surface has a hole or a border, and encloses nothing",
      "fill it with triangles; where the surface looks closed, merge vertices that stand twice",
      {first->low, first->high},
      {first->face}};
}

std::optional<MeshFault> find_crowded_edge(const Edges& edges) {
  std::optional<MeshFault> fault;
  for_edges(edges, [&](const EdgeOfFace* edge, std::size_t faces) {
    if (faces <= 2 || fault) return;
    std::vector<std::int32_t> named;
    for (std::size_t k = 0; k < std::min(faces, std::size_t{6}); ++k) named.push_back(edge[k].face);
    fault = MeshFault{MeshFaultKind::crowded_edge,
                      fmt::format("{} triangles have the edge of vertices {} and {}: {}{}", faces, edge->low,
                                  edge->high, fmt::join(named, ", "), faces > named.size() ? " ..." : ""),
                      "an edge of a closed surface has one triangle on each side",
                      "remove inner walls, or give touching parts vertices of their own",
                      {edge->low, edge->high},
                      named};
  });
  return fault;
}

/// Every edge has two triangles here.
std::optional<MeshFault> find_turned_triangle(const TriangleMesh& mesh, const Edges& edges) {
  std::vector<int> against(mesh.face.size());  // neighbours that each triangle disagrees with
  std::size_t count = 0;
  for (std::size_t k = 0; k < edges.size(); k += 2)
    if (edges[k].ascending == edges[k + 1].ascending) {
      ++count;
      ++against[edges[k].face];
      ++against[edges[k + 1].face];
    }
  if (count == 0) return std::nullopt;
  // The triangle that disagrees with most of its neighbours is the one to turn, where only few are wrong.
  const auto turned =
      static_cast<std::int32_t>(std::max_element(against.begin(), against.end()) - against.begin());
  std::size_t k = 0;
  while (edges[k].ascending != edges[k + 1].ascending ||
         (edges[k].face != turned && edges[k + 1].face != turned))
    k += 2;
  const std::int32_t other = edges[k].face == turned ? edges[k + 1].face : edges[k].face;
  return MeshFault{
      MeshFaultKind::turned_triangle,
      fmt::format("triangles {} and {} are turned against each other along the edge of vertices {} and {}{}",
                  turned, other, edges[k].low, edges[k].high,
                  count > 1 ? fmt::format(", one of {} such edges", count) : ""),
      "the corners of every triangle must go counter-clockwise as seen from outside",
      fmt::format("swap two corners of triangle {}", turned),
      {edges[k].low, edges[k].high},
      {turned, other}};
}

/// Every edge has two triangles here.
std::optional<MeshFault> find_pinched_vertex(const TriangleMesh& mesh, const Edges& edges) {
  // Corner k of triangle f has the number 3 f + k. Corners at one vertex that triangles with a common edge
  // have there are one fan.
  DisjointSets fans(static_cast<int>(3 * mesh.face.size()));
  const auto corner = [&](std::int32_t face, std::int32_t vertex) {
    const auto& f = mesh.face[face];
    return 3 * face + static_cast<std::int32_t>(std::find(f.begin(), f.end(), vertex) - f.begin());
  };
  for (std::size_t k = 0; k < edges.size(); k += 2)
    for (const std::int32_t vertex : {edges[k].low, edges[k].high})
      fans.merge(corner(edges[k].face, vertex), corner(edges[k + 1].face, vertex));
  std::vector<std::int32_t> fan_of(mesh.vertex.size(), -1);
  for (std::int32_t f = 0; f < static_cast<std::int32_t>(mesh.face.size()); ++f)
    for (int k = 0; k < 3; ++k) {
      const std::int32_t vertex = mesh.face[f][k], fan = fans.root(3 * f + k);
      if (fan_of[vertex] < 0) fan_of[vertex] = fan;
      if (fan_of[vertex] == fan) continue;
      const std::int32_t first = fan_of[vertex] / 3;
      return MeshFault{
          MeshFaultKind::pinched_vertex,
          fmt::format("two parts of the surface meet in vertex {} alone, that of triangle {} and "
                      "that of triangle {}",
                      vertex, first, f),
          "round a vertex of a closed surface its triangles form one fan",
          "give each part a vertex of its own there, a little apart",
          {vertex},
          {first, f}};
    }
  return std::nullopt;
}

std::optional<MeshFault> find_second_piece(const TriangleMesh& mesh) {
  DisjointSets joined(static_cast<int>(mesh.vertex.size()));
  for (const auto& [a, b, c] : mesh.face) {
    joined.merge(a, b);
    joined.merge(a, c);
  }
  std::int32_t other = -1;
  std::vector<std::int32_t> roots;
  for (std::size_t f = 0; f < mesh.face.size(); ++f) {
    const std::int32_t root = joined.root(mesh.face[f][0]);
    if (other < 0 && root != joined.root(mesh.face[0][0])) other = static_cast<std::int32_t>(f);
    roots.push_back(root);
  }
  if (other < 0) return std::nullopt;
  std::sort(roots.begin(), roots.end());
  const auto pieces = std::unique(roots.begin(), roots.end()) - roots.begin();
  return MeshFault{
      MeshFaultKind::several_pieces,
      fmt::format("the surface is in {} pieces: triangles 0 and {} are of two of them", pieces, other),
      "a particle has one surface, and no cavity",
      "make each piece a particle of its own",
      {},
      {0, other}};
}

}  // namespace

std::vector<EdgeOfFace> sorted_edges(const TriangleMesh& mesh) {
  Edges edges;
  edges.reserve(3 * mesh.face.size());
  for (std::size_t f = 0; f < mesh.face.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t a = mesh.face[f][k], b = mesh.face[f][(k + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b), static_cast<std::int32_t>(f), a < b});
    }
  std::sort(edges.begin(), edges.end(), [](const EdgeOfFace& a, const EdgeOfFace& b) {
    return std::tie(a.low, a.high, a.face) < std::tie(b.low, b.high, b.face);
  });
  return edges;
}

std::optional<MeshFault> find_connection_fault(const TriangleMesh& mesh, const Edges& edges) {
  if (auto fault = find_repeated_triangle(mesh)) return fault;
  if (auto fault = find_border(edges)) return fault;
  if (auto fault = find_crowded_edge(edges)) return fault;
  if (auto fault = find_turned_triangle(mesh, edges)) return fault;
  if (auto fault = find_pinched_vertex(mesh, edges)) return fault;
  return find_second_piece(mesh);
}

}  // namespace supple
