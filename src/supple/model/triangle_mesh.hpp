/// A triangulated surface as plain data.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "supple/core/vec.hpp"

namespace supple {

/// Vertices [length] and triangles, each counter-clockwise as seen from outside.
struct TriangleMesh {
  std::vector<Vec3> vertex;
  std::vector<std::array<std::int32_t, 3>> face;
};

}  // namespace supple
