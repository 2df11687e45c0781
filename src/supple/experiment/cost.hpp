/// How long runs take and how much memory they need, to be said before they begin.
#pragma once
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

/// Force evaluations of a whole search for the jammed state; 145 to 360 per site were measured with 16 discs
/// and with 32 and 64 shells.
inline double evaluations_to_jam(double sites) { return 180.0 * sites; }

/// Wall time of such a search [s].
inline double seconds_to_jam(double sites) {
  return evaluations_to_jam(sites) * sites * seconds_per_site_evaluation;
}

}  // namespace supple
