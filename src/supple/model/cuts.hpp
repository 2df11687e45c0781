/// Cuts through a crosslinked scaffold: a Voronoi partition into particles, or straight lines.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "supple/model/links.hpp"

namespace supple {

/// Distance from a to the nearest of all periodic images of b, at any strain and distance.
double nearest_distance(const Box<2>& box, const Vec2& a, const Vec2& b);

/// `count` uniform random points of the cell. Each `attempt` draws other points; a larger `count` keeps the
/// first ones.
std::vector<Vec2> random_particle_seeds(const Box<2>& box, int count, std::uint64_t seed, int attempt);

/// Of each disc, the index of the nearest point. To each distance is added `fuzziness` [length] times a
/// random number in [0, 1), drawn for each disc and point. The published documentation calls this partition a
/// triangulation.
std::vector<std::int32_t> voronoi_cells(const System<2>& system, std::span<const Vec2> points,
                                        double fuzziness, std::uint64_t seed, int attempt);

/// Cuts the links between discs of different cells; `cell` is that of each disc (voronoi_cells).
void cut_between_cells(PairTable& pairs, std::span<const TouchingPair> touching,
                       std::span<const std::int32_t> cell);

/// An infinite straight line, of which there are no periodic images; `normal` is a unit vector.
struct CutLine {
  Vec2 point, normal;
};

/// A line through a uniform random point of the cell, at an angle of at least `avoid_horizontal` [radian,
/// below pi/2] to the horizontal.
CutLine random_cut_line(const Box<2>& box, double avoid_horizontal, std::uint64_t seed, int attempt,
                        int line);

/// Cuts the links whose two ends lie on different sides of the line, or on it; the second end is the image
/// nearest to the first.
void cut_along_line(System<2>& system, std::span<const TouchingPair> touching, const CutLine& line);

/// Cuts along the two plates, y = 0 and y = Ly.
void cut_along_plates(System<2>& system, std::span<const TouchingPair> touching);

}  // namespace supple
