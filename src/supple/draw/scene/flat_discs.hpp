/// Discs that overlap, flattened where they meet.
#pragma once
#include <cstdint>
#include <vector>

#include "supple/draw/scene/scene.hpp"

namespace supple {

/// The outline of a disc cut by the radical lines with its neighbours (its cell in the power diagram): such
/// discs tile what they cover.
struct FlatDisc {
  std::vector<Vec2> outline;         ///< anticlockwise, about its position
  std::vector<std::int32_t> across;  ///< body beyond the edge that starts at each point; -1: none
};

/// Of each body that is a disc, flattened by discs; empty for polygons.
std::vector<FlatDisc> flatten_discs(const Scene& scene);

}  // namespace supple
