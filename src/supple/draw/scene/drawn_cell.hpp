/// The sheared cell as pictures and exports show it: leaning about its mid-height by the least lean of equal
/// lattices.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "supple/model/box.hpp"

namespace supple {

/// Where something lies with respect to the cell; `across` where in doubt.
enum class Lies { inside, across, outside };

/// Strain of the cell as drawn. Images repeat along the flow, so a strain of Lx/Ly looks like none: the least
/// lean of equal lattices, within +-Lx/(2 Ly).
double drawn_strain(const Box<2>& box);

/// The box at this strain.
Box<2> sheared(Box<2> box, double strain);

/// Corners of the leaning cell, anticlockwise from the lower left.
std::array<Vec2, 4> cell_corners(const Box<2>& box);

/// Where points lie in a convex quadrilateral whose corners go anticlockwise.
Lies lies_in(const std::array<Vec2, 4>& corner, std::span<const Vec2> points);

/// Whether a circle (or a point with its surroundings) comes into such a quadrilateral, conservatively.
bool comes_near(const std::array<Vec2, 4>& corner, const Vec2& x, double reach);

/// Brings x into the leaning cell by lattice vectors; a point inside keeps its bits.
Vec2 into_cell(const Box<2>& box, Vec2 x);

/// Lattice vectors to the neighbouring cells that may show beside this one, none first.
std::vector<Vec2> neighbour_cells(const Box<2>& box);

}  // namespace supple
