/// The cell: rectangular, periodic or not per direction, sheared by Lees-Edwards boundary conditions.
#pragma once
#include <array>
#include <cmath>

#include "supple/core/vec.hpp"

namespace supple {

inline constexpr int flow = 0;      ///< direction of the flow
inline constexpr int gradient = 1;  ///< direction of the velocity gradient

/// A cell [0, length). `strain` is the accumulated shear strain (never wrapped) and `strain_rate` its rate:
/// the image one cell up (gradient) is displaced by +strain * length[gradient] along the flow [Lees & Edwards
/// 1972].
template <int Dim>
struct Box {
  Vec<Dim> length{};
  std::array<bool, Dim> periodic = all_periodic();
  double strain = 0, strain_rate = 0;

  /// Vector from a to the nearest image of b; `image` counts the cells that were subtracted.
  struct Separation {
    Vec<Dim> r;
    int up;        ///< cells subtracted along the gradient
    bool crosses;  ///< whether any image but the one in this cell was taken
  };

  /// The rule of nearest images at this instant, divisions done: for loops over many pairs.
  struct Images {
    Vec<Dim> length, per_length;  ///< per_length: 1/length, 0 where the cell is not periodic
    double shift;                 ///< of the image one cell up, along the flow
    /// Moves r to its nearest image; returns the cells that were subtracted, by direction. Free of branches.
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
    /// Subtracts that many cells from r, by the operations of reduce().
    void subtract(const Vec<Dim>& cells, Vec<Dim>& r) const {
      r[gradient] -= cells[gradient] * length[gradient];
      r[flow] -= cells[gradient] * shift;
      for (int d = 0; d < Dim; ++d)
        if (d != gradient) r[d] -= cells[d] * length[d];
    }
  };
  Images images() const {
    Images rule{length, {}, strain * length[gradient]};
    for (int d = 0; d < Dim; ++d) rule.per_length[d] = periodic[d] ? 1 / length[d] : 0;
    return rule;
  }

  Separation separation(const Vec<Dim>& a, const Vec<Dim>& b) const {
    Separation s{b - a, 0, false};
    note(images().reduce(s.r), s);
    return s;
  }
  /// Vector from a to the image of b that many cells away, however far.
  Separation separation(const Vec<Dim>& a, const Vec<Dim>& b, const Vec<Dim>& cells) const {
    Separation s{b - a, 0, false};
    images().subtract(cells, s.r);
    note(cells, s);
    return s;
  }

  /// Nearest vector from a to b. Exact for distances up to half of the shortest length (strain is reduced
  /// first).
  Vec<Dim> displacement(const Vec<Dim>& a, const Vec<Dim>& b) const { return separation(a, b).r; }

  /// Velocity of image `up` cells above, relative to its original: subtract from v_b - v_a of a Separation.
  Vec<Dim> velocity_jump(int up) const {
    Vec<Dim> jump{};
    jump[flow] = up * (strain_rate * length[gradient]);
    return jump;
  }

  /// Velocity of the affine flow at x, zero at mid-height.
  Vec<Dim> flow_velocity(const Vec<Dim>& x) const {
    Vec<Dim> u{};
    u[flow] = (x[gradient] - 0.5 * length[gradient]) * strain_rate;
    return u;
  }

  /// Brings x into the cell and changes v by the velocity of the boundary that it crossed. Returns the cells
  /// that were subtracted, by direction.
  Vec<Dim> wrap(Vec<Dim>& x, Vec<Dim>& v) const {
    Vec<Dim> subtracted{};
    const auto outside = [&](int d) { return periodic[d] && !(0 <= x[d] && x[d] < length[d]); };
    if (outside(gradient)) {
      const double cells = std::floor(x[gradient] / length[gradient]);
      x[gradient] -= cells * length[gradient];
      x[flow] -= cells * (strain * length[gradient]);
      v[flow] -= cells * (strain_rate * length[gradient]);
      subtracted[gradient] = cells;
    }
    for (int d = 0; d < Dim; ++d) {
      if (d == gradient || !outside(d)) continue;
      subtracted[d] = std::floor(x[d] / length[d]);
      x[d] -= subtracted[d] * length[d];
    }
    return subtracted;
  }

  Vec<Dim> centre() const { return 0.5 * length; }
  /// Area in 2D, volume in 3D.
  double volume() const {
    double v = 1;
    for (int d = 0; d < Dim; ++d) v *= length[d];
    return v;
  }

 private:
  static void note(const Vec<Dim>& cells, Separation& s) {
    s.up = static_cast<int>(cells[gradient]);
    for (int d = 0; d < Dim; ++d) s.crosses = s.crosses || cells[d] != 0;
  }
  static constexpr std::array<bool, Dim> all_periodic() {
    std::array<bool, Dim> p{};
    for (bool& x : p) x = true;
    return p;
  }
};

}  // namespace supple
