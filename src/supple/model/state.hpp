/// The sites: what moves.
#pragma once
#include <cstdint>
#include <vector>

#include "supple/core/vec.hpp"

namespace supple {

/// How a site moves: by the forces on it; with the lower or upper plate; or not at all. It may spin in every
/// case.
enum class Mobility : std::uint8_t { free = 0, lower_plate = 1, upper_plate = 2, fixed = 3 };
inline bool is_plate(Mobility m) { return m == Mobility::lower_plate || m == Mobility::upper_plate; }

/// Arrays over sites: position and radius [length], velocity [length/time], mass (per depth in 2D), angle
/// [radian], spin [1/time] and moment of inertia [mass length^2]. Angle and spin are counter-clockwise; they
/// matter for discs, as vertices do not spin.
template <int Dim>
struct State {
  std::vector<Vec<Dim>> position, velocity;
  std::vector<double> mass, radius;
  std::vector<double> angle, inertia;
  std::vector<Angular<Dim>> spin;
  std::vector<Mobility> mobility;

  int size() const { return static_cast<int>(position.size()); }

  /// Takes memory for n sites at once, of which as yet there are fewer.
  void reserve(std::size_t n) {
    position.reserve(n);
    velocity.reserve(n);
    spin.reserve(n);
    for (auto* array : {&mass, &radius, &angle, &inertia}) array->reserve(n);
    mobility.reserve(n);
  }

  void resize(int n) {
    position.resize(n);
    velocity.resize(n);
    spin.resize(n);
    for (auto* array : {&mass, &radius, &angle, &inertia}) array->resize(n);
    mobility.resize(n, Mobility::free);
  }
};

}  // namespace supple
