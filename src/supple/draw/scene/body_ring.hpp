/// Bodies as closed curves and triangles, for programs that fill them.
#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "supple/core/vec.hpp"

namespace supple {

/// The outermost closed curve of body_outline, anticlockwise, arcs in steps of at most a sixteenth of a turn;
/// the ring itself where its outline does not close.
std::vector<Vec2> outer_ring(std::span<const Vec2> ring, std::span<const double> radius);

/// Triangles of a simple ring, as indices of its points, by cutting ears; together they cover it once.
std::vector<std::array<std::size_t, 3>> triangulate(std::span<const Vec2> ring);

}  // namespace supple
