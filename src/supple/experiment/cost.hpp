/// What runs cost, to be said before they begin.
#pragma once
#include <cstdint>

namespace supple {

/// Wall time of a disc and step: the order of what scripts/bench measures [s].
inline constexpr double seconds_per_disc_step = 150e-9;
/// The same of a vertex and force evaluation in a minimisation, where forces are all there is to do [s].
inline constexpr double seconds_per_site_evaluation = 41e-9;
/// Memory of a vertex in a run, by measurement of shells, 1e5 vertices: 2.0 to 2.7 kB [byte].
inline constexpr double bytes_per_site = 2500;
/// Vertices and discs of a case at most: jamming more takes months.
inline constexpr std::int64_t most_sites = 1'000'000;

/// Force evaluations of a whole search for the jammed state: 145 to 360 per site, by measurement on 16 discs
/// and 32 and 64 shells.
inline double evaluations_to_jam(double sites) { return 180.0 * sites; }

/// Wall time of one [s].
inline double seconds_to_jam(double sites) {
  return evaluations_to_jam(sites) * sites * seconds_per_site_evaluation;
}

}  // namespace supple
