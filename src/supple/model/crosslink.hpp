/// Crosslinked particles: link every touching pair of a relaxed suspension, then cut the scaffold into
/// particles.
#pragma once
#include <cstdint>
#include <vector>

#include "supple/model/links.hpp"

namespace supple {

/// How the scaffold is cut: into the Voronoi cells of random points, or by random straight lines.
enum class CutKind { voronoi, lines };

/// When isolated discs are joined to a neighbour. Joining makes particles taller, so it comes before their
/// heights are checked; the published package joins last, and a particle may end up taller than allowed.
enum class IsolatedJoin { before_height_check, last };

/// The keys of a case that make crosslinked particles (documentation, Table S2-1).
struct CrosslinkSpec {
  CutKind cut = CutKind::voronoi;
  int cut_lines = 5;                  ///< Voronoi points, or lines; 0 (or 1 point) leaves the bulk scaffold
  double edge_fuzziness = 0;          ///< roughness of the Voronoi edges [largest radius]
  double avoid_horizontal = 0;        ///< least angle of a line to the horizontal [radian]
  bool avoid_height_spanning = true;  ///< cut again while a particle is taller than 0.9 of the cell
  int max_tries = 1000;
  bool cut_top_bottom = false;      ///< also cut along the two plates
  double remove_link_fraction = 0;  ///< of the physical links; particles stay connected
  IsolatedJoin join = IsolatedJoin::before_height_check;

  bool is_bulk() const { return cut_lines == 0 || (cut == CutKind::voronoi && cut_lines == 1); }
};

/// A particle may not be taller than this share of the cell (avoid_height_spanning).
inline constexpr double tallest_share = 0.9;

/// What crosslinking did.
struct CrosslinkReport {
  int tries = 0;                ///< cuts made until no particle was too tall
  int links = 0;                ///< links left, those across the boundary included
  int joined = 0;               ///< isolated discs that were joined to a neighbour
  int removed = 0;              ///< links removed by remove_link_fraction
  double removed_fraction = 0;  ///< of the physical links; below the wish where all others were essential
  std::vector<std::int32_t> particle;  ///< of each disc, by physical links (connected_particles)
  std::vector<double> height;          ///< of each particle [length]
};

/// Links and cuts the discs of a system whose pair table is complete (NeighborList::update); earlier links
/// are undone. The same seed gives the same particles, and the draws of a disc do not depend on how many
/// discs there are. Throws an input error where each of max_tries cuts left a particle that is too tall, or
/// where a number of `spec` is out of range.
CrosslinkReport crosslink(System<2>& system, const CrosslinkSpec& spec, std::uint64_t seed);

/// Joins each disc that has no physical link to one of its touching neighbours, chosen at random. Returns how
/// many were joined.
int join_isolated_discs(System<2>& system, const std::vector<TouchingPair>& touching, std::uint64_t seed,
                        int attempt);

/// Removes this fraction of the physical links, rounded to whole links, at random, or fewer where every
/// particle would not stay connected. Returns how many were removed.
int remove_links(System<2>& system, double fraction, std::uint64_t seed);

}  // namespace supple
