/// What makes a triangle mesh no closed surface of a particle.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "supple/model/triangle_mesh.hpp"

namespace supple {

enum class MeshFaultKind {
  no_triangles,
  too_few_vertices,     ///< fewer than 4
  no_such_vertex,       ///< a corner that is none of the vertices
  no_number,            ///< a coordinate that is not finite, or beyond what can be computed with
  repeated_corner,      ///< a triangle with two equal corners
  unused_vertex,        ///< of no triangle
  coincident_vertices,  ///< two within 1e-9 of the diagonal of the box round the mesh
  flat_triangle,        ///< lower over its longest edge than 1e-9 of this edge
  repeated_triangle,    ///< the same three corners twice
  border_edge,          ///< of one triangle alone: a hole
  crowded_edge,         ///< of three or more triangles
  turned_triangle,      ///< neighbours that go along their edge in one direction
  pinched_vertex,       ///< where two fans of triangles meet in one point
  several_pieces,
  no_volume,  ///< less than 1e-9 of that of a sphere of its area
  inside_out,
  folded_edge,  ///< neighbours that lie on each other, within 1e-9 radian
  crossing,     ///< two triangles that go through each other (meeting_of)
  overlap       ///< two triangles of one plane that share an area
};

/// A fault in words for an error, and where it is: vertices and triangles by their numbers from 0 on, those
/// that the words name. Where there are several of a kind, they say how many, and name the first.
struct MeshFault {
  MeshFaultKind kind;
  std::string what, why, to_do;
  std::vector<std::int32_t> vertices, triangles;
};

/// The first fault of a mesh, in the order of MeshFaultKind; none where it is a closed surface in one piece
/// that does not meet itself, and looks outward. Every genus is allowed: a torus is a sound particle. So is
/// any shape, such as one that is not convex. Takes a time that grows as n log n, 0.3 s for 100 000
/// triangles.
std::optional<MeshFault> find_fault(const TriangleMesh& mesh);

/// Throws an input error that begins with the name of the mesh ("the mesh of 'cell.stl'") where it has a
/// fault.
void require_sound(const TriangleMesh& mesh, const std::string& name);

}  // namespace supple
