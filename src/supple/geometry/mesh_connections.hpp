/// How the triangles of a mesh hang together.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "supple/geometry/mesh_fault.hpp"

namespace supple {

/// An edge of a triangle: its vertices, ascending, the triangle, and whether this goes along it from `low` to
/// `high`.
struct EdgeOfFace {
  std::int32_t low, high, face;
  bool ascending;
};

/// The edges of all triangles, sorted by their vertices and then by triangle: the two of a closed surface
/// that share an edge stand side by side.
std::vector<EdgeOfFace> sorted_edges(const TriangleMesh& mesh);

/// The first fault of its kinds `repeated_triangle` to `several_pieces`, for a mesh whose triangles have
/// three different corners, all of them vertices.
std::optional<MeshFault> find_connection_fault(const TriangleMesh& mesh,
                                               const std::vector<EdgeOfFace>& edges);

}  // namespace supple
