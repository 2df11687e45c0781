/// Permanent links (crosslinks) between touching discs, and the particles that they hold together.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "supple/model/system.hpp"

namespace supple {

/// A pair of discs in contact: its row in the pair table, and the vector from `first` to the nearest image of
/// `second`.
struct TouchingPair {
  std::int32_t row, first, second;
  Vec2 separation;
  bool crosses;  ///< whether `separation` leads across a periodic boundary
};

/// Every pair closer than the sum of its radii, in the order of the pair table. The table must be complete
/// (NeighborList::update). Throws an input error where it is of another number of discs.
std::vector<TouchingPair> touching_pairs(const System<2>& system);

/// Makes the pair of this row a permanent link without elongation; its rest distance is the sum of the radii.
void link(PairTable& pairs, std::int32_t row);
/// Turns the link of this row into an ordinary contact without elongation. Its state is slip until the next
/// evaluation decides.
void cut(PairTable& pairs, std::int32_t row);

/// Which links hold a particle together: all, or the physical ones, which do not cross a periodic boundary.
/// The published particles are those of the physical links: a particle ends where the cell does.
enum class LinkKind { all, physical };

/// Rows of the links of this kind, ascending.
std::vector<std::int32_t> link_rows(const System<2>& system, LinkKind kind);

/// Of each disc, the number of its particle: discs joined by links share one. Particles count from 0 in the
/// order of their first discs.
std::vector<std::int32_t> connected_particles(const System<2>& system, LinkKind kind = LinkKind::physical);

/// Height max(y + r) - min(y - r) of each particle [length]; `particle` as of connected_particles().
std::vector<double> particle_heights(const State<2>& state, std::span<const std::int32_t> particle);

}  // namespace supple
