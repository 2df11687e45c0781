/// Meshes of elastic solids: networks of springs that fill a disc or a ball, and bodies of triangles or
/// tetrahedra that meet in one point.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "supple/core/vec.hpp"
#include "supple/model/triangle_mesh.hpp"

namespace supple {

/// A solid as plain data. Whatever names a node counts them from 0 on.
template <int Dim>
struct SolidMesh {
  std::vector<Vec<Dim>> node;  ///< [length]
  /// Nodes [0, boundary) lie on the boundary, the others within; in 2D the former are in order,
  /// counter-clockwise.
  int boundary = 0;
  /// Pieces of the boundary: in 2D edges (k, k + 1), in 3D triangles, counter-clockwise as seen from outside.
  std::vector<std::array<std::int32_t, Dim>> facet;
  /// Pairs of nodes that a spring joins, first < second, ascending.
  std::vector<std::array<std::int32_t, 2>> bond;
  /// Triangles or tetrahedra that fill the boundary, each of positive area (volume): simplex_volume.
  std::vector<std::array<std::int32_t, Dim + 1>> element;
};

/// Number of springs at a node, on average: 2 bonds/nodes.
template <int Dim>
double coordination(const SolidMesh<Dim>& mesh);

/// Area (volume) within the boundary [length^Dim].
template <int Dim>
double boundary_volume(const SolidMesh<Dim>& mesh);

/// A disordered triangular network that fills a regular polygon, a disc, of this area about the origin. Bonds
/// are the edges of the Delaunay triangulation of its nodes, elements the triangles. With 1100 nodes, as
/// published [MacKeith 2025, section 9.3.4], 100 of them are on the boundary and there are 3197 bonds, a
/// coordination of 5.81. The same nodes, area and seed give the same bits on every machine that has the same
/// sines and roots. Input error for fewer than 7 nodes or an area that is not positive.
SolidMesh<2> network_disc(int nodes, double area, std::uint64_t seed);

/// A disordered network that fills a ball of this volume (that of its triangulated surface) about the origin:
/// nodes spread evenly over the surface and within it, a bond between any two that are nearer than a distance
/// which gives this coordination [MacKeith 2025, section 9.3.4: 3765 nodes, 43 334 bonds, 23.02]; the edges
/// of the surface are bonds in any case. Elements are the Delaunay tetrahedra of the nodes; they say whether
/// the network turned inside out. The same numbers give the same bits, as above. Input error for fewer than
/// 13 nodes, a volume that is not positive, or a coordination that the nodes cannot have.
SolidMesh<3> network_ball(int nodes, double volume, std::uint64_t seed, double coordination = 23.0194);

/// The corners of a polygon, counter-clockwise, or a closed surface as it is, and one more node at the
/// centroid of what they enclose; elements are the triangles (tetrahedra) of this node and the facets
/// [MacKeith 2025, section 9.3.4]. No bonds. Input error that names the facet where the centroid does not see
/// all of the boundary from within.
SolidMesh<2> star_mesh(std::span<const Vec2> polygon);
SolidMesh<3> star_mesh(const TriangleMesh& surface);

/// Young's modulus [energy/length^Dim] of a network whose bonds, all of this stiffness [energy/length^2],
/// follow a uniform strain and point in all directions alike: affine_constants. Nodes that relax make a
/// disordered network softer; the triangular lattice has exactly E = 2 k/sqrt(3), away from its boundary.
template <int Dim>
double affine_modulus(const SolidMesh<Dim>& mesh, double stiffness);

}  // namespace supple
