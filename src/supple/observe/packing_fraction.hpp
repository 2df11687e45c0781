/// How much of a cell its bodies cover: exactly, by the published sum for rough particles, by Monte Carlo.
#pragma once
#include <cstdint>
#include <vector>

#include "supple/observe/body_shapes.hpp"

namespace supple {

/// Covered part of a cell. In a direction without periods, what reaches beyond the cell counts too.
struct PackingFraction {
  double total = 0;  ///< covered area / area of the cell
  /// Of each body [length^2]; what n bodies cover goes to each of them by 1/n. Adds to total.
  std::vector<double> area;
};

/// The exact fraction: the outlines, cut where they cross, integrated by Green's theorem. It has no limits of
/// overlap, size or shape, except that rings must not cross themselves and that no two bodies may lie in the
/// very same place. Throws as body_shapes does.
PackingFraction packing_fraction(const System<2>& system, Outline outline);

/// The published sum for rough particles, polygons + vertices - sectors - pairs [MacKeith 2025,
/// eq. 9.18-9.22], every part as a fraction of the cell.
struct RoughSum {
  double total = 0, polygons = 0, vertices = 0, sectors = 0, pairs = 0;
  /// Of each body [length^2], bodies parted on the line through the crossings of circles (9.21). Adds to
  /// total.
  std::vector<double> area;
  /// Sites whose disc takes part in an overlap that the sum may count wrongly; where 0, the sum is exact. It
  /// cannot see a disc that meets another body's polygon, three discs with a point in common that are not of
  /// one ring, and in a ring that is not convex (or of unequal radii) a disc that meets other than its own
  /// two edges and neighbours; in a convex ring of equal radii, that matters only where the disc reaches
  /// across an edge away from its ends. The published condition, 0.1 < edge/diameter < 1, is neither needed
  /// nor enough; longer edges have no lens.
  int doubts = 0;
};
RoughSum rough_sum(const System<2>& system);

/// The fraction of `points` uniform random points that are covered, with its standard error.
struct MonteCarloFraction {
  double value = 0, error = 0;
  std::int64_t points = 0;
};

/// By the definition of the outline alone, to check the others. The same for any number of threads. Throws as
/// body_shapes does, and on points < 1.
MonteCarloFraction monte_carlo_fraction(const System<2>& system, Outline outline, std::int64_t points,
                                        std::uint64_t seed);

}  // namespace supple
