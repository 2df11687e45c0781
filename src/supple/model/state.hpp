/// The sites: what moves.
#pragma once
#include <cstdint>
#include <vector>

#include "supple/core/vec.hpp"

namespace supple {

/// How a site moves: by its forces; with the upper or lower plate (it may spin); or not at all (it may spin).
enum class Mobility : std::uint8_t { free = 0, lower_plate = 1, upper_plate = 2, fixed = 3 };
inline bool is_plate(Mobility m) { return m == Mobility::lower_plate || m == Mobility::upper_plate; }

/// Arrays over sites. Angle, spin and inertia are of sites that can spin (discs).
template <int Dim>
struct State {
  std::vector<Vec<Dim>> position, velocity;
  std::vector<double> mass, radius;
  std::vector<double> angle, inertia;
  std::vector<Angular<Dim>> spin;
  std::vector<Mobility> mobility;

  int size() const { return static_cast<int>(position.size()); }

  void resize(int n) {
    position.resize(n);
    velocity.resize(n);
    spin.resize(n);
    for (auto* array : {&mass, &radius, &angle, &inertia}) array->resize(n);
    mobility.resize(n, Mobility::free);
  }
};

}  // namespace supple
