#include "supple/geometry/mesh_fault.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "supple/core/error.hpp"
#include "supple/geometry/box_tree.hpp"
#include "supple/geometry/mesh_connections.hpp"
#include "supple/geometry/mesh_measures.hpp"
#include "supple/geometry/surface_crossings.hpp"
#include "supple/model/sanity.hpp"

namespace supple {

namespace {

constexpr double negligible = 1e-9;  // of a length, area, volume or angle: see MeshFaultKind

std::string in_words(const Vec3& x) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", x[0], x[1], x[2]); }

std::optional<MeshFault> find_fault_of_lists(const TriangleMesh& mesh) {
  const auto vertices = static_cast<std::int32_t>(mesh.vertex.size());
  if (mesh.face.empty())
    return MeshFault{MeshFaultKind::no_triangles,
                     fmt::format("there are {} vertices and no triangles", vertices),
                     "a surface consists of triangles",
                     "list the three vertices of each",
                     {},
                     {}};
  if (vertices < 4)
    return MeshFault{MeshFaultKind::too_few_vertices,
                     fmt::format("there are {} vertices", vertices),
                     "a closed surface has at least 4, those of a tetrahedron",
                     "add the others",
                     {},
                     {}};
  std::vector<bool> used(mesh.vertex.size());
  for (std::int32_t f = 0; f < static_cast<std::int32_t>(mesh.face.size()); ++f)
    for (const std::int32_t corner : mesh.face[f]) {
      if (corner < 0 || corner >= vertices)
        return MeshFault{
            MeshFaultKind::no_such_vertex,
            fmt::format("triangle {} has the corner {}", f, corner),
            fmt::format("the vertices are numbered from 0 to {}", vertices - 1),
            corner == vertices ? "count vertices from 0 on" : "correct the number, or add the vertex",
            {corner},
            {f}};
      used[corner] = true;
    }
  for (std::int32_t v = 0; v < vertices; ++v)
    for (int d = 0; d < 3; ++d)
      if (const double x = mesh.vertex[v][d]; !is_computable(x))
        return MeshFault{MeshFaultKind::no_number,
                         fmt::format("vertex {} has the {} coordinate {}", v, "xyz"[d], x),
                         std::isfinite(x)
                             ? fmt::format("sizes must be between {} and {}, or 0", least_number, most_number)
                             : "it must be a finite number",
                         std::isfinite(x) ? "take another unit of length" : "correct it",
                         {v},
                         {}};
  for (std::int32_t f = 0; f < static_cast<std::int32_t>(mesh.face.size()); ++f)
    if (const auto& [a, b, c] = mesh.face[f]; a == b || b == c || c == a)
      return MeshFault{MeshFaultKind::repeated_corner,
                       fmt::format("triangle {} has the corners {}, {} and {}", f, a, b, c),
                       "two of them are the same vertex",
                       "remove this triangle, or correct the corner",
                       {a, b, c},
                       {f}};
  const auto unused = std::count(used.begin(), used.end(), false);
  if (unused == 0) return std::nullopt;
  const auto first = static_cast<std::int32_t>(std::find(used.begin(), used.end(), false) - used.begin());
  return MeshFault{MeshFaultKind::unused_vertex,
                   unused == 1 ? fmt::format("vertex {} belongs to no triangle", first)
                               : fmt::format("{} vertices belong to no triangle, the first of them vertex {}",
                                             unused, first),
                   "nothing would hold it",
                   "remove it, or add its triangles",
                   {first},
                   {}};
}

std::optional<MeshFault> find_coincident_vertices(const TriangleMesh& mesh) {
  Extent all{mesh.vertex[0], mesh.vertex[0]};
  for (const Vec3& x : mesh.vertex) all.include({x, x});
  const double near = negligible * norm(all.high - all.low);
  // Only vertices whose places along some direction are near each other are compared. Along this one the
  // vertices of no plane of a simple grid share a place.
  const Vec3 oblique = {0.412, 0.631, 0.657};  // of length 1, nearly
  std::vector<std::pair<double, std::int32_t>> sorted;
  for (std::int32_t v = 0; v < static_cast<std::int32_t>(mesh.vertex.size()); ++v)
    sorted.emplace_back(dot(oblique, mesh.vertex[v] - all.low), v);
  std::sort(sorted.begin(), sorted.end());
  std::int32_t count = 0;
  std::array<std::int32_t, 2> first{};
  for (auto at = sorted.begin(); at != sorted.end(); ++at)
    for (auto next = at + 1; next != sorted.end() && next->first - at->first <= 2 * near; ++next) {
      const auto [i, j] = std::minmax({at->second, next->second});
      if (norm(mesh.vertex[j] - mesh.vertex[i]) > near) continue;
      if (count++ == 0 || std::array{i, j} < first) first = {i, j};
      break;
    }
  if (count == 0) return std::nullopt;
  return MeshFault{
      MeshFaultKind::coincident_vertices,
      fmt::format("vertices {} and {} are both at {}{}", first[0], first[1], in_words(mesh.vertex[first[0]]),
                  count > 1 ? fmt::format(", one of {} such pairs", count) : ""),
      "each place of the surface is one vertex, which all triangles round it share",
      fmt::format("name vertex {} in their place", first[0]),
      {first[0], first[1]},
      {}};
}

std::optional<MeshFault> find_flat_triangle(const TriangleMesh& mesh) {
  for (std::int32_t f = 0; f < static_cast<std::int32_t>(mesh.face.size()); ++f) {
    const auto& [a, b, c] = mesh.face[f];
    const Vec3 u = mesh.vertex[b] - mesh.vertex[a], v = mesh.vertex[c] - mesh.vertex[a];
    const double longest = std::max({norm(u), norm(v), norm(v - u)});
    if (norm(cross(u, v)) > negligible * longest * longest) continue;
    return MeshFault{MeshFaultKind::flat_triangle,
                     fmt::format("triangle {} of the vertices {}, {} and {} has no area", f, a, b, c),
                     "its corners are on one line",
                     "move a corner, or flip an edge with its neighbour",
                     {a, b, c},
                     {f}};
  }
  return std::nullopt;
}

std::optional<MeshFault> find_fault_of_volume(const TriangleMesh& mesh) {
  const std::vector<double> areas = face_areas(mesh);
  const double area = std::accumulate(areas.begin(), areas.end(), 0.0), volume = enclosed_volume(mesh);
  const double sphere = surface_shape_parameter(area, 1);  // the volume of a sphere of this area
  if (std::abs(volume) <= negligible * sphere)
    return MeshFault{
        MeshFaultKind::no_volume,
        fmt::format("the surface has the area {:.6g} and encloses the volume {:.6g}", area, volume),
        "it encloses nothing, or as much from inside as from outside",
        "move its sides apart, so that it goes round a volume",
        {},
        {}};
  if (volume < 0)
    return MeshFault{MeshFaultKind::inside_out,
                     fmt::format("the surface encloses the volume {:.6g}", volume),
                     "its triangles look inward: their corners go clockwise as seen from outside",
                     "swap two corners of every triangle",
                     {},
                     {}};
  return std::nullopt;
}

std::optional<MeshFault> find_folded_edge(const TriangleMesh& mesh, const std::vector<EdgeOfFace>& edges) {
  const auto normal = [&](std::int32_t f) {
    const auto& [a, b, c] = mesh.face[f];
    return cross(mesh.vertex[b] - mesh.vertex[a], mesh.vertex[c] - mesh.vertex[a]);
  };
  for (std::size_t k = 0; k < edges.size(); k += 2) {
    const std::int32_t f = edges[k].face, g = edges[k + 1].face;
    const Vec3 m = normal(f), n = normal(g);
    if (dot(m, n) >= 0 || norm(cross(m, n)) > negligible * norm(m) * norm(n)) continue;
    return MeshFault{
        MeshFaultKind::folded_edge,
        fmt::format("triangles {} and {} lie on each other, folded along the edge of vertices {} and {}", f,
                    g, edges[k].low, edges[k].high),
        "there is nothing between them",
        "move their corners apart",
        {edges[k].low, edges[k].high},
        {f, g}};
  }
  return std::nullopt;
}

std::optional<MeshFault> find_crossing_or_overlap(const TriangleMesh& mesh) {
  const std::vector<MeetingTriangles> all = self_crossings({mesh.vertex, mesh.face});
  const auto of_kind = [&](TriangleMeeting kind, MeshFaultKind fault, const char* words,
                           const char* to_do) -> std::optional<MeshFault> {
    const auto is = [&](const MeetingTriangles& m) { return m.meeting == kind; };
    const auto first = std::find_if(all.begin(), all.end(), is);
    if (first == all.end()) return std::nullopt;
    const auto count = std::count_if(all.begin(), all.end(), is);
    const Vec3 near = mesh.vertex[mesh.face[first->first][0]];
    return MeshFault{
        fault,
        fmt::format("triangles {} and {}, near {}, {}{}", first->first, first->second, in_words(near), words,
                    count > 1 ? fmt::format(", one of {} such pairs", count) : ""),
        "a surface must not meet itself",
        to_do,
        {},
        {first->first, first->second}};
  };
  auto fault = of_kind(TriangleMeeting::crossing, MeshFaultKind::crossing, "go through each other",
                       "move their vertices until none does");
  if (!fault)
    fault = of_kind(TriangleMeeting::overlap, MeshFaultKind::overlap, "lie on each other in one plane",
                    "move them apart, or remove what is twice");
  return fault;
}

}  // namespace

std::optional<MeshFault> find_fault(const TriangleMesh& mesh) {
  if (auto fault = find_fault_of_lists(mesh)) return fault;
  if (auto fault = find_coincident_vertices(mesh)) return fault;
  if (auto fault = find_flat_triangle(mesh)) return fault;
  const std::vector<EdgeOfFace> edges = sorted_edges(mesh);
  if (auto fault = find_connection_fault(mesh, edges)) return fault;
  if (auto fault = find_fault_of_volume(mesh)) return fault;
  if (auto fault = find_folded_edge(mesh, edges)) return fault;
  return find_crossing_or_overlap(mesh);
}

void require_sound(const TriangleMesh& mesh, const std::string& name) {
  if (const auto fault = find_fault(mesh))
    throw input_error(fmt::format("{}: {}", name, fault->what), fault->why, fault->to_do);
}

}  // namespace supple
