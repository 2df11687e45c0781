/// Discs that overlap, flattened where they meet.
#pragma once
#include <cstdint>
#include <vector>

#include "supple/draw/scene/scene.hpp"

namespace supple {

/// The outline of a disc, cut by the lines through the crossings of its circle with those of its neighbours
/// (its cell in the power diagram). Discs cut this way tile what they cover.
struct FlatDisc {
  std::vector<Vec2> outline;         ///< anticlockwise, about its position
  std::vector<std::int32_t> across;  ///< body beyond the edge that starts at each point; -1: none
};

/// The outline of each body that is a disc, flattened by other discs; empty for polygons.
std::vector<FlatDisc> flatten_discs(const Scene& scene);

}  // namespace supple
