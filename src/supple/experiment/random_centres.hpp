/// Random places for particles.
#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "supple/model/box.hpp"

namespace supple {

/// Random positions in the cell, moved apart and away from its walls, as soft discs (3D: spheres) of these
/// radii, until none overlap or as far as can be. Discs more than twelve times as wide as others are placed
/// first, and the others drawn beside them: a narrow disc inside a wide one would have a long way out in its
/// small steps. Throws `interrupted` where asked to stop.
template <int Dim>
std::vector<Vec<Dim>> random_centres(const std::vector<double>& radius, const Box<Dim>& box,
                                     std::int64_t seed, const std::function<bool()>& stop_requested);

}  // namespace supple
