/// Surfaces in motion, for tests of dynamics in 3D.
#pragma once
#include <algorithm>
#include <vector>

#include "supple/build/surfaces.hpp"
#include "supple/contact/rough_contacts.hpp"
#include "supple/contact/smooth_surfaces.hpp"
#include "supple/core/random.hpp"
#include "supple/force/surface_shape.hpp"
#include "supple/observe/summary.hpp"
#include "supple/solve/mover.hpp"
#include "supple/solve/time_step.hpp"

namespace supple::testing {

/// Contacts and shape energy.
inline ForceField<3> surface_field(const BodyContacts<3>& contacts) {
  ForceField<3> field(contacts);
  field.terms().add(std::make_shared<SurfaceShape>());
  return field;
}
inline ForceField<3> rough_surfaces() { return surface_field(RoughContacts<3>(Harmonic{1, true})); }
inline ForceField<3> smooth_surfaces() { return surface_field(SmoothSurfaces(Harmonic{1, true})); }

inline constexpr double shell_bending = 0.05;

/// Adds an undeformed shell of volume 1 that is heavier where `mass` says so.
inline void add_shell(System<3>& system, int vertices, const Vec3& centre, double mass = 1) {
  TriangleMesh mesh = geodesic_icosahedron(vertices);
  for (Vec3& x : mesh.vertex) x += centre;
  add_surface(system, mesh, 1, {.area = 1, .length = 1, .bending = shell_bending});
  for (auto i = system.state.mass.size() - mesh.vertex.size(); i < system.state.mass.size(); ++i)
    system.state.mass[i] = mass;
}

/// Gives every site a random velocity, each component up to `speed`.
inline void heat(System<3>& system, double speed, std::uint64_t seed = 7) {
  RandomStream draw(seed, Purpose::test);
  for (Vec3& v : system.state.velocity)
    for (int d = 0; d < 3; ++d) v[d] = speed * draw.uniform(-1, 1);
}

/// Shells of 12 vertices on a cubic lattice of side^3 places, which touch, in a sheared periodic cell.
inline System<3> touching_shells(int side, double strain = 0.13) {
  System<3> system;
  const double spacing = 1.7;
  system.box.length = {side * spacing, side * spacing, side * spacing};
  system.box.strain = strain;
  for (int k = 0; k < side * side * side; ++k)
    add_shell(system, 12,
              spacing * Vec3{0.5 + k % side, 0.5 + k / side % side, 0.5 + k / (side * side)} +
                  Vec3{0.1 * (k / side % side), 0, 0});
  return system;
}

inline double total_energy(Mover<3>& dynamics, System<3>& system) {
  return dynamics.evaluate_energies(system).energy.stored() + kinetic_energy(system).total();
}

/// Largest |a_i - b_i|.
inline double largest(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, norm(a[i] - b[i]));
  return most;
}

}  // namespace supple::testing
