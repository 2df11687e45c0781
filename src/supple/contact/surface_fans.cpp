#include "supple/contact/surface_fans.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "supple/core/error.hpp"

namespace supple {

/// What a triangle is at one of its corners: it lies between the edges to two vertices.
struct SurfaceFans::Wedge {
  std::int32_t from, to, facet;
};

void SurfaceFans::update(const Topology<3>& topology, int sites) {
  if (sites == sites_ && topology.facet == facet_) return;
  const auto facets = static_cast<std::int32_t>(topology.facet.size());
  std::vector<std::int32_t> begin(static_cast<std::size_t>(sites) + 1);
  for (const auto& facet : topology.facet)
    for (const std::int32_t site : facet) ++begin[site + 1];
  for (int i = 0; i < sites; ++i) begin[i + 1] += begin[i];
  std::vector<Wedge> wedges(static_cast<std::size_t>(begin.back()));
  std::vector<FacetNeighbours> neighbours(topology.facet.size());
  std::vector<std::int32_t> end(begin.begin(), begin.end() - 1);
  for (std::int32_t f = 0; f < facets; ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& corners = topology.facet[f];
      const std::int32_t at = end[corners[k]]++;
      wedges[at] = {corners[(k + 1) % 3], corners[(k + 2) % 3], f};
      neighbours[f].speaks_for_corner[k] = at == begin[corners[k]];
    }

  std::vector<std::int32_t> ring, facet_round;
  for (std::int32_t i = 0; i < sites; ++i) {
    const auto first = wedges.begin() + begin[i], last = wedges.begin() + end[i];
    // Puts the wedges in order, each behind the one that ends where it begins.
    for (auto wedge = first; wedge != last; ++wedge) {
      const bool closes = wedge + 1 == last;
      const auto next =
          closes ? first : std::find_if(wedge + 1, last, [&](const Wedge& w) { return w.from == wedge->to; });
      if (next == last || next->from != wedge->to)
        throw input_error(fmt::format("the triangles at vertex {} are no closed fan", i),
                          "the surface has a hole there, or touches itself",
                          "give every vertex triangles that surround it once, all counter-clockwise as seen "
                          "from outside");
      if (!closes) std::iter_swap(wedge + 1, next);
      ring.push_back(wedge->from);
      facet_round.push_back(wedge->facet);
    }
  }
  for (std::int32_t f = 0; f < facets; ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t a = topology.facet[f][k], b = topology.facet[f][(k + 1) % 3];
      const auto across = std::find_if(wedges.begin() + begin[b], wedges.begin() + end[b],
                                       [&](const Wedge& w) { return w.from == a; });
      neighbours[f].across[k] = across->facet;
      neighbours[f].speaks_for_edge[k] = f < across->facet;
    }

  facet_ = topology.facet;
  sites_ = sites;
  neighbours_.swap(neighbours);
  begin_.swap(begin);
  ring_.swap(ring);
  facet_round_.swap(facet_round);
}

}  // namespace supple
