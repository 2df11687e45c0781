/// Builders of deformable particles in 3D: closed triangulated surfaces and their preferred shapes.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "supple/geometry/mesh_measures.hpp"
#include "supple/model/polygons.hpp"
#include "supple/model/system.hpp"
#include "supple/model/triangle_mesh.hpp"

namespace supple {

/// The number of vertices of a geodesic icosahedron, 10 * 4^k + 2, that is nearest to this one.
int nearest_geodesic(int vertices);

/// A geodesic icosahedron: the triangles of an icosahedron cut into four again and again, all vertices on one
/// sphere about the origin, with this enclosed volume [length^3]. `vertices` is 12, 42, 162, 642 or a later
/// 10 * 4^k + 2; input error with the nearest of them otherwise.
TriangleMesh geodesic_icosahedron(int vertices, double volume = 1);

/// Adds the surface as it is, vertices of mass 1 and this radius [length], with rest volume [length^3], rest
/// area of each triangle [length^2] and rest angle of each hinge [radian] of its own. Input error where lists
/// differ in length or the mesh is not closed.
void add_surface(System<3>& system, const TriangleMesh& mesh, double radius, const ShapeStiffness& stiffness,
                 double rest_volume, const std::vector<double>& rest_area,
                 const std::vector<double>& rest_angle);

/// Adds the surface with the preferred shape that `shape` says: its own volume v0 and angles, and its own
/// areas, scaled where shape.shape_parameter asks for another s0^1.5/(6 sqrt(pi) v0). `shape.area`, k_v, is
/// of the volume, `shape.length`, k_a, of the triangles. Relative stiffnesses: (k_v/2)(v/v0 - 1)^2, (k_a/2)
/// sum (a - a0)^2/<a0>^2 with the mean <a0> over triangles, gamma s/s0. Vertices have the diameter sigma =
/// `diameter_ratio` times the mean edge.
void add_surface(System<3>& system, const TriangleMesh& mesh, double diameter_ratio, const ShapeSpec& shape);

/// Absolute stiffnesses (ShapeStiffness) of a surface with preferred volume v0 [length^3] and areas a0 of its
/// triangles [length^2], meant as above.
ShapeStiffness absolute_stiffness(const ShapeSpec& shape, double v0, const std::vector<double>& a0);

/// The present surface of body b; no triangles where it is a sphere.
TriangleMesh mesh_of(const System<3>& system, int b);

/// Adds a smooth sphere: a body of one site of mass 1.
void add_sphere_body(System<3>& system, const Vec3& centre, double radius);

}  // namespace supple
