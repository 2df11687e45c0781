/// How sites are grouped into bodies, and the facets and hinges of a body's boundary.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace supple {

/// Sites [begin[b], begin[b+1]) form body b; where `begin` is empty every site is a body of its own (discs).
/// A facet has Dim sites (an edge, a triangle), a hinge joins two facets (Dim + 1 sites). Facets of body b:
/// [facet_begin[b], facet_begin[b+1]); hinges likewise. In 2D facet k of a polygon is the edge from its
/// vertex k to the next one, counter-clockwise, and hinge k is the corner (previous, k, next).
template <int Dim>
struct Topology {
  std::vector<std::int32_t> begin, facet_begin, hinge_begin;
  std::vector<std::array<std::int32_t, Dim>> facet;
  std::vector<std::array<std::int32_t, Dim + 1>> hinge;

  int body_count(int sites) const { return begin.empty() ? sites : static_cast<int>(begin.size()) - 1; }
  int body_begin(int b) const { return begin.empty() ? b : begin[b]; }
  int body_end(int b) const { return begin.empty() ? b + 1 : begin[b + 1]; }
  int body_size(int b) const { return body_end(b) - body_begin(b); }
  /// The sites of body b on its boundary come first, those inside a solid after them: how many the first are,
  /// which in 2D is the number of edges. All of them for bodies without facets.
  int boundary_size(int b) const {
    if (facet_begin.empty() || facet_begin[b] == facet_begin[b + 1]) return body_size(b);
    if constexpr (Dim == 2) return facet_begin[b + 1] - facet_begin[b];
    std::int32_t last = body_begin(b);
    for (std::int32_t f = facet_begin[b]; f < facet_begin[b + 1]; ++f)
      for (const std::int32_t site : facet[f]) last = std::max(last, site);
    return last + 1 - body_begin(b);
  }
};

/// The body that each of the `sites` sites belongs to.
template <int Dim>
std::vector<std::int32_t> bodies_of_sites(const Topology<Dim>& topology, int sites) {
  std::vector<std::int32_t> body(static_cast<std::size_t>(sites));
  for (int b = 0; b < topology.body_count(sites); ++b)
    for (int i = topology.body_begin(b); i < topology.body_end(b); ++i) body[i] = b;
  return body;
}

}  // namespace supple
