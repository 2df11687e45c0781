/// Crosslinked clusters of bodies: permanent links between vertices that touch.
#pragma once
#include <vector>

#include "supple/model/crosslink.hpp"

namespace supple {

/// Two sites of different bodies that touch: x_second - x_first - n for the cells n of the lattice.
struct TouchingSites {
  std::int32_t first, second;
  std::array<std::int32_t, 3> cells{};
  auto operator<=>(const TouchingSites&) const = default;
};

/// Links every pair of `touching` sites, but for those between bodies that the cuts part: bodies are linked,
/// cut and freed of links as discs at their centres (crosslink), so that the same keys mean the same. Each
/// link rests at the present distance of its sites. Earlier links are undone. Throws as crosslink does.
CrosslinkReport link_bodies(System<2>& system, std::vector<TouchingSites> touching, const CrosslinkSpec& spec,
                            std::uint64_t seed);

/// From the first site of a link to the image of the second that it keeps.
Vec2 link_vector(const System<2>& system, const Link& link);

/// Clusters that links hold together: of each body, numbered from 0 in the order of their first bodies.
std::vector<std::int32_t> linked_clusters(const System<2>& system);

}  // namespace supple
