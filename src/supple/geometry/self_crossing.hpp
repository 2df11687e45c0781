/// Whether a closed ring of vertices crosses itself.
#pragma once
#include <optional>
#include <span>
#include <utility>

#include "supple/core/vec.hpp"

namespace supple {

/// Two edges of the ring that cross, each by the number of its first vertex; nothing where no two do. Edges
/// that only touch do not count. Only edges whose extents along x overlap are compared.
std::optional<std::pair<int, int>> find_self_crossing(std::span<const Vec2> ring);

}  // namespace supple
