/// The cell: rectangular, periodic or not per direction, sheared by Lees-Edwards boundary conditions.
#pragma once
#include <array>
#include <cmath>

#include "supple/model/lattice.hpp"

namespace supple {

/// A cell [0, length) in each direction [length]. `strain` is the accumulated shear strain (never wrapped),
/// `strain_rate` its rate [1/time]: the image one cell up along the gradient is displaced by +strain *
/// length[gradient] along the flow [Lees & Edwards 1972].
template <int Dim>
struct Box {
  Vec<Dim> length{};
  std::array<bool, Dim> periodic = all_periodic();
  double strain = 0, strain_rate = 0;

  /// Vector from a to an image of b: b - a less whole cells.
  struct Separation {
    Vec<Dim> r;
    int up;        ///< cells subtracted along the gradient
    bool crosses;  ///< whether the image is another than b itself
  };

  Lattice<Dim> lattice() const {
    Lattice<Dim> images{length, {}, strain * length[gradient]};
    for (int d = 0; d < Dim; ++d) images.per_length[d] = periodic[d] ? 1 / length[d] : 0;
    return images;
  }

  Separation separation(const Vec<Dim>& a, const Vec<Dim>& b) const {
    Separation s{b - a, 0, false};
    note(lattice().reduce(s.r), s);
    return s;
  }
  /// Vector from a to the image of b from which `cells` are subtracted, by direction; it need not be the
  /// nearest.
  Separation separation(const Vec<Dim>& a, const Vec<Dim>& b, const Vec<Dim>& cells) const {
    Separation s{b - a, 0, false};
    lattice().subtract(cells, s.r);
    note(cells, s);
    return s;
  }

  /// Vector from a to the nearest image of b. The nearest is found for distances up to half of the shortest
  /// length.
  Vec<Dim> displacement(const Vec<Dim>& a, const Vec<Dim>& b) const { return separation(a, b).r; }

  /// Velocity of the image `up` cells above relative to its original [length/time]. Subtract it from v_b -
  /// v_a for the relative velocity at a Separation with that `up`.
  Vec<Dim> velocity_jump(double up) const {
    Vec<Dim> jump{};
    jump[flow] = up * (strain_rate * length[gradient]);
    return jump;
  }

  /// Velocity of the affine flow at x, zero at mid-height [length/time].
  Vec<Dim> flow_velocity(const Vec<Dim>& x) const {
    Vec<Dim> u{};
    u[flow] = (x[gradient] - 0.5 * length[gradient]) * strain_rate;
    return u;
  }

  /// Brings x into the cell, and v to the motion of the image there (velocity_jump). Returns the cells that
  /// were subtracted from x, by direction.
  Vec<Dim> wrap(Vec<Dim>& x, Vec<Dim>& v) const {
    const Vec<Dim> cells = lattice().wrap(x);
    v[flow] -= velocity_jump(cells[gradient])[flow];
    return cells;
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
