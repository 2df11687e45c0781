/// How far sites reach, and how long the periods of a cell must be for them.
#pragma once
#include <optional>
#include <vector>

#include "supple/core/error.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// What may touch: sites each other, or also sites and facets. A facet may be nearer to a site than its ends
/// are.
enum class Meeting { sites, facets };

/// Of each site, the radius within which it may touch something [length]: its own times the range of the law
/// and, with Meeting::facets, the largest facet_covering_radius there. A site that touches a facet is then
/// within the sum of reaches of one of its corners, as the place where they touch is within that radius of
/// it. Sites inside a solid touch nothing: out_of_reach.
inline constexpr double out_of_reach = -1;
template <int Dim>
std::vector<double> reach_of_sites(const System<Dim>& system, Meeting meeting, double range = 1);

/// The shortest period in which every contact is with the nearest image and with no other [length]: the
/// larger of twice the largest sum of reaches of two sites of different bodies, and the extent of the longest
/// body along the period. In a shorter one a site may meet another body on two sides, or a body may meet
/// itself.
template <int Dim>
double least_period(const System<Dim>& system, const std::vector<double>& reach);

/// A period that is too short: its direction, its length and the least allowed [length].
struct ShortPeriod {
  int direction;
  double length, least;
  Error error(ErrorKind kind) const;
};

/// The first periodic direction that is shorter than `least`. Directions with walls have no images and no
/// least length.
template <int Dim>
std::optional<ShortPeriod> short_period(const Box<Dim>& box, double least) {
  for (int d = 0; d < Dim; ++d)
    if (box.periodic[d] && box.length[d] < (1 - 1e-12) * least) return ShortPeriod{d, box.length[d], least};
  return {};
}

}  // namespace supple
