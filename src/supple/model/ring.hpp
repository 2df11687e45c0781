/// The vertices of a polygon, in their order.
#pragma once
#include <cstdint>

#include "supple/model/topology.hpp"

namespace supple {

/// Neighbours of a vertex on its ring: the sites [begin, end), the boundary of a body.
struct Ring {
  std::int32_t begin, end;
  std::int32_t after(std::int32_t k) const { return k + 1 < end ? k + 1 : begin; }
  std::int32_t before(std::int32_t k) const { return k > begin ? k - 1 : end - 1; }
  /// A body without edges.
  bool is_disc() const { return end - begin < 3; }
};

/// The ring of a body.
inline Ring ring_of(const Topology<2>& topology, std::int32_t body) {
  return {topology.body_begin(body), topology.body_begin(body) + topology.boundary_size(body)};
}

}  // namespace supple
