/// A scaffold to link and cut: a lattice of touching discs.
#pragma once
#include "supple/model/discs.hpp"
#include "supple/model/links.hpp"
#include "tests/support/all_pairs.hpp"

namespace supple::testing {

/// A triangular lattice of touching discs in a periodic cell: every disc has six neighbours.
inline System<2> lattice(int columns = 12, int rows = 14) {
  System<2> system = hexagonal_discs(columns, rows, 1.0, 0.52, 1.0);
  fill_all_pairs(system);
  return system;
}

inline void link_everything(System<2>& system) {
  for (const TouchingPair& pair : touching_pairs(system)) link(system.pairs, pair.row);
}

}  // namespace supple::testing
