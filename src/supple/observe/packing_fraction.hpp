/// How much of a cell its bodies cover: exactly or along lines, by the published sum for rough particles in
/// 2D, by Monte Carlo.
#pragma once
#include <cstdint>
#include <vector>

#include "supple/observe/body_images.hpp"

namespace supple {

/// Covered part of a cell. Along a direction that is not periodic, what reaches beyond the cell counts too.
struct PackingFraction {
  double total = 0;  ///< covered area or volume over that of the cell
  double error = 0;  ///< standard error of the total; 0 where all is exact
  /// Covered area [length^2] or volume [length^3] of each body: what n bodies cover together counts 1/n for
  /// each. The sum is total times the area or volume of the cell.
  std::vector<double> volume;
  std::vector<double> volume_error;  ///< standard error of each volume; empty in 2D, where all is exact
};

/// The exact fraction in 2D, by Green's theorem on the outlines, cut where they cross. Overlaps, sizes and
/// shapes may be any, except that rings must not cross themselves and no two bodies may coincide. Throws as
/// body_shapes does.
PackingFraction packing_fraction(const System<2>& system, Outline outline);

/// How exactly a volume is wanted, and where its random numbers come from.
struct VolumeAccuracy {
  double relative_error = 1e-4;       ///< standard error of the total over the total
  std::int64_t most_lines = 1 << 22;  ///< through one body at most
  std::uint64_t seed = 1;
};

/// The fraction in 3D. Exact are spheres of which no three have a point in common, and bodies of smooth
/// outline that are convex [Steiner 1840] and overlap no other. All else is integrated over lines along z,
/// exactly on each line, with a standard error from independent shifts of the lattice of lines; what is not
/// exact of a body is as accurate as is wanted of the total, or as `most_lines` allow. Surfaces must not
/// cross themselves. The result is the same for any number of threads. Throws as body_shapes does, and an
/// input error where accuracy.relative_error is not positive or accuracy.most_lines is below 1.
PackingFraction packing_fraction(const System<3>& system, Outline outline,
                                 const VolumeAccuracy& accuracy = {});

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
MonteCarloFraction monte_carlo_fraction(const System<3>& system, Outline outline, std::int64_t points,
                                        std::uint64_t seed);

}  // namespace supple
