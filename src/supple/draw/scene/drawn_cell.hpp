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

/// Corners of the leaning cell, anticlockwise from the lower left.
std::array<Vec2, 4> cell_corners(const Box<2>& box);

/// Where something made of points, or of discs of these radii about them, lies when moved by `shift`, with
/// respect to a convex quadrilateral whose corners go anticlockwise, its sides moved out by `margin`.
Lies lies_in(const std::array<Vec2, 4>& corner, std::span<const Vec2> points,
             std::span<const double> radius = {}, const Vec2& shift = {}, double margin = 0);

/// Brings x into the leaning cell by lattice vectors; a point inside keeps its bits.
Vec2 into_cell(const Box<2>& box, Vec2 x);

/// Lattice vectors to the neighbouring cells that may show beside this one, none first.
std::vector<Vec2> neighbour_cells(const Box<2>& box);

}  // namespace supple
