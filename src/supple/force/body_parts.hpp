/// Which bodies one thread takes at a time.
#pragma once
#include <vector>

#include "supple/model/system.hpp"

namespace supple {

/// The bodies with a shape at which the parts begin that threads share, and their end: `most_bodies` bodies a
/// part, or fewer that have `most_facets` facets (of edges in 2D a polygon has as many as vertices) or a
/// single larger one.
template <int Dim>
std::vector<int> parts_of_bodies(const System<Dim>& system, int most_bodies, int most_facets) {
  const auto bodies = static_cast<int>(system.shape.stiffness.size());
  const std::vector<std::int32_t>& facet_begin = system.topology.facet_begin;
  std::vector<int> begin{0};
  int facets = 0;
  for (int b = 0; b < bodies; ++b) {
    const int more = facet_begin[b + 1] - facet_begin[b];
    if (b - begin.back() >= most_bodies || (facets > 0 && facets + more > most_facets)) {
      begin.push_back(b);
      facets = 0;
    }
    facets += more;
  }
  begin.push_back(bodies);
  return begin;
}

}  // namespace supple
