/// Cuts through a crosslinked scaffold: a Voronoi partition into particles, or straight lines.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "supple/model/links.hpp"

namespace supple {

/// Distance from a to the nearest of all periodic images of b, at any strain and distance.
double nearest_distance(const Box<2>& box, const Vec2& a, const Vec2& b);

/// `count` uniform random points of the cell. Each `attempt` has fresh ones; more points leave the first
/// unchanged.
std::vector<Vec2> random_particle_seeds(const Box<2>& box, int count, std::uint64_t seed, int attempt);

/// Nearest point of each disc, where to each distance is added `fuzziness` [length] times a random number in
/// [0, 1) of its own. The published documentation calls this partition a triangulation.
std::vector<std::int32_t> voronoi_cells(const System<2>& system, std::span<const Vec2> points,
                                        double fuzziness, std::uint64_t seed, int attempt);

/// Cuts the links between discs of different cells.
void cut_between_cells(PairTable& pairs, std::span<const TouchingPair> touching,
                       std::span<const std::int32_t> cell);

/// An infinite straight line, not repeated by the boundary; `normal` is a unit vector.
struct CutLine {
  Vec2 point, normal;
};

/// A line through a uniform random point, at least `avoid_horizontal` [radian, below pi/2] from horizontal.
CutLine random_cut_line(const Box<2>& box, double avoid_horizontal, std::uint64_t seed, int attempt,
                        int line);

/// Cuts the links whose two ends (the second at its nearest image) lie on different sides of the line, or on
/// it.
void cut_along_line(System<2>& system, std::span<const TouchingPair> touching, const CutLine& line);

/// Cuts along the two plates, y = 0 and y = Ly.
void cut_along_plates(System<2>& system, std::span<const TouchingPair> touching);

}  // namespace supple
