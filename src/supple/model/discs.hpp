/// Builders of systems of discs: bimodal random suspensions, lattices, and discs given as lists.
#pragma once
#include <cstdint>
#include <vector>

#include "supple/model/system.hpp"

namespace supple {

/// What a suspension is made of. Lengths and density in the run's units; density per area in 2D.
struct DiscSpec {
  int count = 150;
  double packing_fraction = 1.5;  ///< area of all discs over area of the cell
  double size_ratio = 1.4;        ///< b: large over small radius
  double density = 1000;
};

/// Radii [length] of a bimodal suspension in a cell of this area [length^2]: half of the discs are large, an
/// odd last one too, and the packing fraction is exact (S1-14, with the actual numbers of large and small
/// discs). A coin tells which of the discs 2k and 2k+1 is large.
std::vector<double> bimodal_radii(const DiscSpec& spec, double area, std::uint64_t seed);

/// Adds a disc at rest, with mass m = density pi r^2 and moment of inertia I = m r^2 / 2.
void add_disc(State<2>& state, const Vec2& position, double radius, double density);

/// Bimodal discs at rest at uniform random positions. The seed and the index of a disc decide where it is and
/// whether it is large, so that another count or size ratio reshuffles nothing. Throws input errors on
/// numbers out of range.
System<2> random_discs(const Box<2>& box, const DiscSpec& spec, std::uint64_t seed);

/// Equal discs on a periodic triangular lattice of rows along the flow; the box fits it, so `rows` must be
/// even.
System<2> hexagonal_discs(int columns, int rows, double spacing, double radius, double density);

/// Discs as listed; velocity and spin are zero unless given. Input error where the lists differ in length.
System<2> listed_discs(const Box<2>& box, const std::vector<Vec2>& position,
                       const std::vector<double>& radius, double density,
                       const std::vector<Vec2>& velocity = {}, const std::vector<double>& spin = {});

}  // namespace supple
