/// Samples of solids beside other bodies for tests.
#pragma once
#include <cmath>

#include "supple/build/solid_bodies.hpp"
#include "supple/build/surfaces.hpp"
#include "supple/core/random.hpp"
#include "supple/model/polygons.hpp"

namespace supple::testing {

/// Moves a mesh, and scales it before.
template <int Dim>
SolidMesh<Dim> placed(SolidMesh<Dim> mesh, double scale, const Vec<Dim>& centre) {
  for (Vec<Dim>& x : mesh.node) x = scale * x + centre;
  return mesh;
}

/// Displaces every site at random, by at most `most` along each axis.
template <int Dim>
void shake(System<Dim>& system, double most, std::uint64_t seed = 1) {
  for (int i = 0; i < system.state.size(); ++i) {
    RandomStream draw(seed, Purpose::test, static_cast<std::uint64_t>(i));
    for (int d = 0; d < Dim; ++d) system.state.position[i][d] += draw.uniform(-most, most);
  }
}

/// A network, a shell, a star of elements and a disc in a sheared periodic cell, where they touch.
inline System<2> solids_among_others(double jitter = 0.02) {
  System<2> system;
  system.box.length = {3, 2.9};
  system.box.strain = 0.13;
  const SolidSpec network{Filling::network, 0.7, {}}, elements{Filling::elements, 0, {2, 0.3}};
  add_solid(system, placed<2>(solid_mesh<2>(network, 24, 3), 1.2, {0.7, 0.7}), 1, network);
  add_polygon(system, {2.0, 0.7}, 1.3, 9, 0.3, 1, {1, 1, 0.1, 0});
  add_solid(system, placed<2>(solid_mesh<2>(elements, 11, 1), 1.2, {0.9, 1.9}), 1, elements);
  add_disc_body(system, {2.3, 2.0}, 0.72);
  shake(system, jitter);
  return system;
}

/// A ball of springs, a surface, a ball of elements.
inline System<3> solids_among_others_in_3d(double jitter = 0.02) {
  System<3> system;
  system.box.length = {4.2, 4.1, 4.0};
  system.box.strain = 0.1;
  const SolidSpec network{Filling::network, 0.7, {}}, elements{Filling::elements, 0, {2, 0.3}};
  add_solid(system, placed<3>(solid_mesh<3>(network, 60, 3), 1.1, {0.8, 0.8, 0.8}), 1, network);
  TriangleMesh shell = geodesic_icosahedron(12, 1.2);
  for (Vec3& x : shell.vertex) x += Vec3{2.1, 0.8, 0.9};
  add_surface(system, shell, 1, {1, 1, 0.1, 0});
  add_solid(system, placed<3>(solid_mesh<3>(elements, 12, 1), 1.1, {0.9, 2.05, 0.9}), 1, elements);
  shake(system, jitter);
  return system;
}

}  // namespace supple::testing
