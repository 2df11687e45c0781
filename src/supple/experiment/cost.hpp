/// How long runs take and how much memory they need, to be said before they begin.
#pragma once
#include <cmath>
#include <cstdint>

namespace supple {

/// Wall time of one step of one disc [s], to order of magnitude as scripts/bench measures it.
inline constexpr double seconds_per_disc_step = 150e-9;
/// Wall time of one force evaluation of one vertex in a minimisation [s].
inline constexpr double seconds_per_site_evaluation = 41e-9;
/// Memory of a vertex in a run [byte]; 2.0 to 2.7 kB were measured with 1e5 vertices of shells.
inline constexpr double bytes_per_site = 2500;
/// Most vertices and discs that a case may have: jamming more takes months.
inline constexpr std::int64_t most_sites = 1'000'000;

/// Force evaluations of a whole search for the jammed state from above: 11 000, 46 000 and 137 000 were
/// measured with 64 discs, 64 shells and 256 shells of 20 vertices.
inline double evaluations_to_jam(double sites) { return 1300 * std::sqrt(sites); }

/// Wall time of such a search [s].
inline double seconds_to_jam(double sites) {
  return evaluations_to_jam(sites) * sites * seconds_per_site_evaluation;
}

}  // namespace supple
