/// Crosslinked clusters of bodies: permanent links between vertices that touch.
#pragma once
#include <vector>

#include "supple/model/crosslink.hpp"

namespace supple {

/// Two sites of different bodies that touch. The vector from first to second is x_second - x_first - n, n the
/// lattice vector of `cells`.
struct TouchingSites {
  std::int32_t first, second;
  std::array<std::int32_t, 3> cells{};
  auto operator<=>(const TouchingSites&) const = default;
};

/// Links every pair of `touching` sites whose bodies stay together. Which bodies do is decided by crosslink()
/// on discs in their places, as large as the bodies (outer_radius): keys mean the same for discs and bodies.
/// The rest length of a link is the present distance of its sites. Earlier links are undone. Throws as
/// crosslink does.
CrosslinkReport link_bodies(System<2>& system, std::vector<TouchingSites> touching, const CrosslinkSpec& spec,
                            std::uint64_t seed);

/// Vector from the first site of a link to the image of the second that it is about [length].
Vec2 link_vector(const System<2>& system, const Link& link);

/// Of each body, the number of the cluster of linked bodies that it belongs to; clusters count from 0 in the
/// order of their first bodies.
std::vector<std::int32_t> linked_clusters(const System<2>& system);

}  // namespace supple
