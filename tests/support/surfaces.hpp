/// Systems of closed surfaces and spheres for tests.
#pragma once
#include "tests/support/corner_meshes.hpp"
#include "tests/support/meshes.hpp"

namespace supple::testing {

/// Adds a mesh with all vertices of this radius, without stiffness.
inline void add_mesh(System<3>& system, TriangleMesh mesh, double radius, const Vec3& shift = {}) {
  for (Vec3& x : mesh.vertex) x += shift;
  add_surface(system, mesh, radius, {}, 1, std::vector<double>(mesh.face.size(), 1),
              std::vector<double>(hinges_of(mesh).size(), 0));
}

/// The mesh, turned by a random rotation about the origin (of a random unit quaternion).
inline TriangleMesh turned(TriangleMesh mesh, RandomStream& draw) {
  double q[4], square = 2;
  while (square > 1 || square < 0.01) {
    square = 0;
    for (double& c : q) {
      c = draw.uniform(-1, 1);
      square += c * c;
    }
  }
  const double w = q[0] / std::sqrt(square);
  const Vec3 v = (1 / std::sqrt(square)) * Vec3{q[1], q[2], q[3]};
  for (Vec3& x : mesh.vertex) x += 2 * cross(v, cross(v, x) + w * x);
  return mesh;
}

/// Convex, pitted and spiky surfaces and spheres about 2 in size, at random places; they may overlap.
inline System<3> random_surfaces(int bodies, double cell, std::uint64_t seed, double least_radius = 0.05) {
  System<3> system;
  system.box.length = {cell, 0.9 * cell, 1.1 * cell};
  for (int b = 0; b < bodies; ++b) {
    RandomStream draw(seed, Purpose::test, static_cast<std::uint64_t>(b));
    Vec3 centre;
    for (int d = 0; d < 3; ++d) centre[d] = draw.uniform(-20, 20);
    const double radius = draw.uniform(least_radius, 0.4);
    if (b % 4 == 0) add_mesh(system, turned(geodesic_icosahedron(42, 3), draw), radius, centre);
    if (b % 4 == 1) add_mesh(system, turned(dented_sphere(42, 0.7, 0.9), draw), radius, centre);
    if (b % 4 == 2) add_mesh(system, turned(star_mesh(12, 0.4, seed + b), draw), radius, centre);
    if (b % 4 == 3) add_sphere_body(system, centre, 2 * radius);
  }
  return system;
}

}  // namespace supple::testing
