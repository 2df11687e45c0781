/// The sheared cell as pictures and exports show it: it leans about its mid-height, by the smallest of the
/// strains that give the same lattice of images.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "supple/model/box.hpp"

namespace supple {

/// Where something lies relative to the cell; `across` also where this is in doubt.
enum class Lies { inside, across, outside };

/// Strain of the cell as drawn, within +-Lx/(2 Ly). Images repeat along the flow, so that strains which
/// differ by Lx/Ly have the same lattice; this is the smallest of them.
template <int Dim>
double drawn_strain(const Box<Dim>& box);

/// Edges of the leaning cell along x, y and z [length]: that along the gradient has the drawn strain times
/// its length along the flow.
template <int Dim>
std::array<Vec<Dim>, Dim> cell_edges(const Box<Dim>& box);

/// Corners of the leaning cell, anticlockwise from the lower left.
std::array<Vec2, 4> cell_corners(const Box<2>& box);
/// The same in 3D: bit d of the index is set for those on the far side in direction d.
std::array<Vec3, 8> cell_corners(const Box<3>& box);

/// Where points, or discs of these radii about them, lie when moved by `shift`, relative to a convex
/// quadrilateral with anticlockwise corners whose sides are moved out by `margin`.
Lies lies_in(const std::array<Vec2, 4>& corner, std::span<const Vec2> points,
             std::span<const double> radius = {}, const Vec2& shift = {}, double margin = 0);

/// Brings x into the leaning cell by lattice vectors; a point inside stays the same to the last bit.
template <int Dim>
Vec<Dim> into_cell(const Box<Dim>& box, Vec<Dim> x);

/// Lattice vectors to this cell (zero, first) and to the neighbouring cells that may show beside it.
std::vector<Vec2> neighbour_cells(const Box<2>& box);
std::vector<Vec3> neighbour_cells(const Box<3>& box);

}  // namespace supple
