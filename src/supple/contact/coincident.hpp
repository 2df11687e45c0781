/// Direction between two sites at the same point.
#pragma once
#include <cmath>
#include <cstdint>

#include "supple/core/random.hpp"
#include "supple/core/vec.hpp"

namespace supple {

/// Unit vector for sites i and j whose centres coincide: arbitrary, but the same at every call.
inline Vec2 arbitrary_direction(std::int32_t i, std::int32_t j) {
  const double angle = RandomStream(0, Purpose::coincident_normal, stream_index(i, j)).uniform(0, 6.283185307179586);
  return {std::cos(angle), std::sin(angle)};
}

}  // namespace supple
