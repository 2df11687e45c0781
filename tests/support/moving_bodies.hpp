/// Bodies in motion, for tests of dynamics.
#pragma once
#include <algorithm>

#include "supple/contact/rough_contacts.hpp"
#include "supple/model/rigid.hpp"
#include "supple/observe/summary.hpp"
#include "supple/solve/mover.hpp"
#include "supple/solve/time_step.hpp"
#include "tests/support/polygons.hpp"

namespace supple::testing {

/// A force field of rough contacts and shape energy.
inline ForceField<2> shell_field() { return polygon_field(RoughContacts<2>(Harmonic{1, true})); }

/// Gives every site a random velocity, every component up to `speed`, and rigid bodies one of their own.
inline void heat(System<2>& system, double speed) {
  RandomStream stream(7, Purpose::test);
  const auto draw = [&] { return Vec2{speed * stream.uniform(-1, 1), speed * stream.uniform(-1, 1)}; };
  for (Vec2& v : system.state.velocity) v = draw();
  for (Vec2& v : system.rigid.velocity) v = draw();
  for (double& w : system.rigid.spin) w = speed * stream.uniform(-1, 1);
  place_sites(system);
}

/// Rough shells that touch in a sheared periodic cell, damped for 200 steps and then given velocities (heat).
/// The bodies 0, 2, ... are rigid, `rigid` of them.
inline System<2> warm_shells(int bodies, int rigid = 0, double speed = 0.1) {
  System<2> system = random_polygons({.bodies = bodies, .jitter = 0});
  for (int r = 0; r < rigid; ++r) make_rigid(system, 2 * r);
  Mover dynamics(shell_field(), 1);
  const double dt = default_step(system, dynamics.forces(), 0.3);
  for (int k = 0; k < 200; ++k) dynamics.advance(system, dt);
  heat(system, speed);
  system.step = 0;
  system.time = 0;
  return system;
}

inline double total_energy(Mover<2>& dynamics, System<2>& system) {
  return dynamics.evaluate_energies(system).energy.stored() + kinetic_energy(system).total();
}

/// Angular momentum of the sites [begin, end) about the origin; with end = -1, of all from begin on.
inline double angular_momentum(const System<2>& system, int begin = 0, int end = -1) {
  double sum = 0;
  for (int i = begin; i < (end < 0 ? system.state.size() : end); ++i)
    sum += system.state.mass[i] * cross(system.state.position[i], system.state.velocity[i]);
  return sum;
}

/// Largest |a_i - b_i|.
inline double largest(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, norm(a[i] - b[i]));
  return most;
}

}  // namespace supple::testing
