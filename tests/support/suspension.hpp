/// A random suspension for tests: overlapping discs in a sheared cell.
#pragma once
#include "supple/contact/neighbor_list.hpp"
#include "supple/core/random.hpp"
#include "supple/model/system.hpp"

namespace supple::testing {

/// n bidisperse discs at random in a cell of 10 x 8, with random velocities and spins and radii that give the
/// packing fraction.
inline System<2> random_suspension(int n, double packing_fraction, double strain = 0,
                                   std::uint64_t seed = 1) {
  System<2> system;
  system.box.length = {10, 8};
  system.box.strain = strain;
  system.box.strain_rate = 0.3;
  system.state.resize(n);
  const double large =
      std::sqrt(packing_fraction * system.box.volume() / (n * 3.141592653589793 * (0.5 + 0.5 / 1.96)));
  for (int i = 0; i < n; ++i) {
    RandomStream draw(seed, Purpose::test, static_cast<std::uint64_t>(i));
    State<2>& s = system.state;
    s.position[i] = {draw.uniform(0, 10), draw.uniform(0, 8)};
    s.velocity[i] = {draw.uniform(-1, 1), draw.uniform(-1, 1)};
    s.radius[i] = i % 2 ? large : large / 1.4;
    s.mass[i] = s.radius[i] * s.radius[i] / (large * large);
    s.inertia[i] = 0.5 * s.mass[i] * s.radius[i] * s.radius[i];
    s.spin[i] = draw.uniform(-1, 1);
  }
  return system;
}

}  // namespace supple::testing
