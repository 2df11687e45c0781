/// The lattice of periodic images: the only place that knows strain x length.
#pragma once
#include <cmath>

#include "supple/core/vec.hpp"

namespace supple {

inline constexpr int flow = 0;       ///< direction of the flow
inline constexpr int gradient = 1;   ///< direction of the velocity gradient
inline constexpr int vorticity = 2;  ///< direction of the vorticity, in 3D

/// Images of a rectangular cell at one instant, with all divisions done beforehand, for loops over many
/// pairs. The image in cell n is displaced by n_d length_d in each direction d, and further by n_gradient
/// shift along the flow.
template <int Dim>
struct Lattice {
  Vec<Dim> length, per_length;  ///< per_length: 1/length, 0 where the cell is not periodic
  double shift;                 ///< strain * length[gradient]: of the image one cell up [Lees & Edwards 1972]

  Vec<Dim> vector(const Vec<Dim>& cells) const {
    Vec<Dim> v;
    for (int d = 0; d < Dim; ++d) v[d] = cells[d] * length[d];
    v[flow] += cells[gradient] * shift;
    return v;
  }
  /// Subtracts `cells` from r by the operations of reduce(), so that the bits are the same.
  void subtract(const Vec<Dim>& cells, Vec<Dim>& r) const {
    r[gradient] -= cells[gradient] * length[gradient];
    r[flow] -= cells[gradient] * shift;
    for (int d = 0; d < Dim; ++d)
      if (d != gradient) r[d] -= cells[d] * length[d];
  }
  /// Moves the vector r to its shortest image; returns the cells that were subtracted, by direction. The
  /// shortest is found if it is at most half of the shortest length of the cell. Free of branches.
  Vec<Dim> reduce(Vec<Dim>& r) const {
    Vec<Dim> cells;
    cells[gradient] = std::floor(r[gradient] * per_length[gradient] + 0.5);
    r[gradient] -= cells[gradient] * length[gradient];
    r[flow] -= cells[gradient] * shift;
    for (int d = 0; d < Dim; ++d) {
      if (d == gradient) continue;
      cells[d] = std::floor(r[d] * per_length[d] + 0.5);
      r[d] -= cells[d] * length[d];
    }
    return cells;
  }
  /// Brings x into the cell [0, length); returns the cells that were subtracted, by direction.
  Vec<Dim> wrap(Vec<Dim>& x) const {
    Vec<Dim> cells{};
    const auto outside = [&](int d) { return per_length[d] != 0 && !(0 <= x[d] && x[d] < length[d]); };
    if (outside(gradient)) {
      cells[gradient] = std::floor(x[gradient] / length[gradient]);
      x[gradient] -= cells[gradient] * length[gradient];
      x[flow] -= cells[gradient] * shift;
    }
    for (int d = 0; d < Dim; ++d) {
      if (d == gradient || !outside(d)) continue;
      cells[d] = std::floor(x[d] / length[d]);
      x[d] -= cells[d] * length[d];
    }
    return cells;
  }
  /// The cell that x is in, by direction; 0 is the cell [0, length).
  Vec<Dim> cell_of(Vec<Dim> x) const { return wrap(x); }
};

}  // namespace supple
