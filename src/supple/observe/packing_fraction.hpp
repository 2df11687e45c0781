/// How much of a cell its bodies cover: exactly, by the published sum for rough particles, by Monte Carlo.
#pragma once
#include <cstdint>
#include <vector>

#include "supple/observe/body_images.hpp"

namespace supple {

/// Covered part of a cell. Along a direction that is not periodic, what reaches beyond the cell counts too.
struct PackingFraction {
  double total = 0;  ///< covered area / area of the cell
  /// Covered area of each body [length^2]: what n bodies cover together counts 1/n for each. The sum is total
  /// times the area of the cell.
  std::vector<double> area;
};

/// The exact fraction, by Green's theorem on the outlines, cut where they cross. Overlaps, sizes and shapes
/// may be any, except that rings must not cross themselves and no two bodies may coincide. Throws as
/// body_shapes does.
PackingFraction packing_fraction(const System<2>& system, Outline outline);

/// The published sum for rough particles, total = polygons + vertices - sectors - pairs [MacKeith 2025, eq.
/// 9.18-9.22], every part as a fraction of the cell.
struct RoughSum {
  double total = 0, polygons = 0, vertices = 0, sectors = 0, pairs = 0;
  /// Covered area of each body [length^2], with overlaps parted along the line through the crossings of the
  /// circles (9.21). The sum is total times the area of the cell.
  std::vector<double> area;
  /// Number of sites whose disc takes part in an overlap that the sum may count wrongly; where it is 0 the
  /// sum is exact. The sum is blind to three overlaps: of a disc with the polygon of another body; of three
  /// discs that are not all of one ring; and, in a ring that is not convex or of unequal radii, of a disc
  /// with more of its ring than its two edges and neighbours. In a convex ring of equal radii the last one
  /// matters only where a disc reaches across an edge away from the ends of that edge. The published
  /// condition, 0.1 < edge/diameter < 1, is neither necessary nor sufficient; above 1 neighbours on a ring do
  /// not overlap.
  int doubts = 0;
};
RoughSum rough_sum(const System<2>& system);

/// The fraction of `points` uniform random points that are covered, with its standard error.
struct MonteCarloFraction {
  double value = 0, error = 0;
  std::int64_t points = 0;
};

/// The fraction by the definition of Outline alone, a check of the other two. The result is the same for any
/// number of threads. Throws as body_shapes does, and an input error for points < 1.
MonteCarloFraction monte_carlo_fraction(const System<2>& system, Outline outline, std::int64_t points,
                                        std::uint64_t seed);

}  // namespace supple
