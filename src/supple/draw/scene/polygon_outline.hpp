/// The outline of a polygon with round vertices; bodies as closed curves and triangles, for programs that
/// fill them.
#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "supple/core/vec.hpp"

namespace supple {

/// The boundary of the union of a polygon and the discs on its vertices (what neighbours of the body touch),
/// in pieces: parts of edges, and arcs whose points are at most `step` apart. One site alone gives its
/// circle. In a ring that crosses itself, what it winds about is inside.
std::vector<std::vector<Vec2>> body_outline(std::span<const Vec2> ring, std::span<const double> radius,
                                            double step);

/// The outermost closed curve of body_outline(), anticlockwise, with arcs in steps of at most a sixteenth of
/// a turn; the ring itself where the outline does not close.
std::vector<Vec2> outer_ring(std::span<const Vec2> ring, std::span<const double> radius);

/// Triangles that together cover a simple ring once, as indices of its points, by cutting ears.
std::vector<std::array<std::size_t, 3>> triangulate(std::span<const Vec2> ring);

}  // namespace supple
