/// A direction for two sites at the same point.
#pragma once
#include <cmath>
#include <cstdint>

#include "supple/core/random.hpp"
#include "supple/core/vec.hpp"

namespace supple {

/// Unit vector from site i to site j where their centres coincide: arbitrary, but the same at every call.
template <int Dim = 2>
Vec<Dim> arbitrary_direction(std::int32_t i, std::int32_t j) {
  RandomStream draw(0, Purpose::coincident_normal, stream_index(i, j));
  const double angle = draw.uniform(0, 6.283185307179586);
  if constexpr (Dim == 2) {
    return {std::cos(angle), std::sin(angle)};
  } else {
    const double z = draw.uniform(-1, 1), r = std::sqrt(1 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
  }
}

}  // namespace supple
