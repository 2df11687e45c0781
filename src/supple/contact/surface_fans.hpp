/// How the triangles of closed surfaces hang together at their edges and vertices.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "supple/model/topology.hpp"

namespace supple {

/// The neighbours of one triangle. Edge k is that from its corner k to the next one. One triangle at each
/// edge and one at each vertex speaks for it, so that a loop over triangles meets every edge and vertex once.
struct FacetNeighbours {
  std::array<std::int32_t, 3> across{};  ///< the triangle on the other side of edge k
  std::array<bool, 3> speaks_for_edge{}, speaks_for_corner{};
};

/// The neighbours of every triangle, and the ring of vertices round every vertex.
class SurfaceFans {
 public:
  /// Finds them again if the triangles are others than before. Input error where triangles at a vertex do not
  /// form one closed fan: the surface has a hole, or touches itself there.
  void update(const Topology<3>& topology, int sites);

  const FacetNeighbours& of(std::int32_t facet) const { return neighbours_[facet]; }
  /// The vertices at the other ends of the edges at this one, counter-clockwise as seen from outside. Empty
  /// for a sphere.
  std::span<const std::int32_t> round(std::int32_t site) const {
    return std::span(ring_).subspan(static_cast<std::size_t>(begin_[site]),
                                    static_cast<std::size_t>(begin_[site + 1] - begin_[site]));
  }
  /// The triangles there: the first one lies between the first two of round(site).
  std::span<const std::int32_t> facets_round(std::int32_t site) const {
    return std::span(facet_round_)
        .subspan(static_cast<std::size_t>(begin_[site]),
                 static_cast<std::size_t>(begin_[site + 1] - begin_[site]));
  }

 private:
  struct Wedge;

  std::vector<std::array<std::int32_t, 3>> facet_;  ///< what the rest was found for
  int sites_ = 0;
  std::vector<FacetNeighbours> neighbours_;
  std::vector<std::int32_t> begin_{0}, ring_, facet_round_;
};

}  // namespace supple
