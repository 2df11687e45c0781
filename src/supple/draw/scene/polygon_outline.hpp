/// The outline of a polygon with round vertices.
#pragma once
#include <span>
#include <vector>

#include "supple/core/vec.hpp"

namespace supple {

/// The boundary of the union of a polygon and the discs on its vertices (a body as its neighbours feel it),
/// in pieces: arcs and parts of edges, no point of an arc further than `step` from the next. `ring` goes
/// round once; one site alone gives its circle. A ring that crosses itself is filled by the even-odd rule.
std::vector<std::vector<Vec2>> body_outline(std::span<const Vec2> ring, std::span<const double> radius,
                                            double step);

}  // namespace supple
