/// Measures of closed triangulated surfaces, and where their triangles meet.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "supple/model/triangle_mesh.hpp"

namespace supple {

/// Volume that a mesh encloses [length^3], positive where its triangles look outward; area of each triangle
/// [length^2]; angle of each hinge (hinges_of) [radian].
double enclosed_volume(const TriangleMesh& mesh);
std::vector<double> face_areas(const TriangleMesh& mesh);
std::vector<double> hinge_angles(const TriangleMesh& mesh);
/// Mean length of the edges [length].
double mean_edge(const TriangleMesh& mesh);

/// The hinges of a closed mesh, in the order of its triangles and of their edges: for the edge a b of the
/// triangle (a, b, c), a < b, the sites (a, b, c, d) with d the corner of the triangle on the other side.
/// Input error where an edge does not belong to exactly two triangles, once in each direction.
std::vector<std::array<std::int32_t, 4>> hinges_of(const TriangleMesh& mesh);

/// s^1.5/(6 sqrt(pi) v) of a surface of area s that encloses v: 1 for a sphere [MacKeith 2025, section 9.2].
double surface_shape_parameter(double area, double volume);

}  // namespace supple
