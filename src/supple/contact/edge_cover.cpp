#include "supple/contact/edge_cover.hpp"

#include <fmt/format.h>

#include "supple/core/error.hpp"

namespace supple {

void require_covered_edges(const System<3>& system, double least) {
  const State<3>& state = system.state;
  for (const auto& facet : system.topology.facet)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t a = facet[k], b = facet[(k + 1) % 3];
      const double length = norm(state.position[b] - state.position[a]);
      const double ratio = (state.radius[a] + state.radius[b]) / length;
      if (!(ratio < (1 - 1e-12) * least)) continue;
      throw input_error(
          fmt::format("vertices {} and {} of a surface have a diameter of {:.3g} of the edge between them", a,
                      b, ratio),
          "edges of two particles could pass through each other unseen, as contacts are of vertices",
          fmt::format("take at least {:.3g} of the longest edge, or more vertices; contact.unsound = "
                      "\"mark\" goes on as it is",
                      least));
    }
}

}  // namespace supple
