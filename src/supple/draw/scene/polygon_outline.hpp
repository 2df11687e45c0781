/// The outline of a polygon with round vertices; bodies as closed curves and triangles, for programs that
/// fill them.
#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "supple/core/vec.hpp"

namespace supple {

/// The boundary of the union of a polygon and the discs on its vertices (a body as its neighbours feel it),
/// in pieces: arcs and parts of edges, no point of an arc further than `step` from the next. `ring` goes
/// round once; one site alone gives its circle. What a ring that crosses itself winds about is
/// inside.
std::vector<std::vector<Vec2>> body_outline(std::span<const Vec2> ring, std::span<const double> radius,
                                            double step);

/// The outermost closed curve of body_outline, anticlockwise, arcs in steps of at most a sixteenth of a turn;
/// the ring itself where its outline does not close.
std::vector<Vec2> outer_ring(std::span<const Vec2> ring, std::span<const double> radius);

/// Triangles of a simple ring, as indices of its points, by cutting ears; together they cover it once.
std::vector<std::array<std::size_t, 3>> triangulate(std::span<const Vec2> ring);

}  // namespace supple
