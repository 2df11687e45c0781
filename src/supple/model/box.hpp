/// The cell: rectangular, periodic or not per direction, sheared by Lees-Edwards boundary conditions.
#pragma once
#include <array>
#include <cmath>

#include "supple/core/vec.hpp"

namespace supple {

inline constexpr int flow = 0;      ///< direction of the flow
inline constexpr int gradient = 1;  ///< direction of the velocity gradient

/// A cell [0, length). `strain` is the accumulated shear strain (never wrapped) and `strain_rate` its rate: the
/// image one cell up (gradient) is displaced by +strain * length[gradient] along the flow [Lees & Edwards 1972].
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

  Separation separation(const Vec<Dim>& a, const Vec<Dim>& b) const {
    Separation s{b - a, 0, false};
    if (periodic[gradient]) {
      const double cells = std::floor(s.r[gradient] / length[gradient] + 0.5);
      s.r[gradient] -= cells * length[gradient];
      s.r[flow] -= cells * (strain * length[gradient]);
      s.up = static_cast<int>(cells);
      s.crosses = s.up != 0;
    }
    for (int d = 0; d < Dim; ++d) {
      if (d == gradient || !periodic[d]) continue;
      const double cells = std::floor(s.r[d] / length[d] + 0.5);
      s.r[d] -= cells * length[d];
      s.crosses = s.crosses || cells != 0;
    }
    return s;
  }

  /// Nearest vector from a to b. Exact for distances up to half of the shortest length (strain is reduced first).
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

  /// Brings x into the cell and changes v by the velocity of the boundary that it crossed.
  void wrap(Vec<Dim>& x, Vec<Dim>& v) const {
    if (periodic[gradient]) {
      const double cells = std::floor(x[gradient] / length[gradient]);
      if (cells != 0) {
        x[gradient] -= cells * length[gradient];
        x[flow] -= cells * (strain * length[gradient]);
        v[flow] -= cells * (strain_rate * length[gradient]);
      }
    }
    for (int d = 0; d < Dim; ++d)
      if (d != gradient && periodic[d]) {
        const double cells = std::floor(x[d] / length[d]);
        if (cells != 0) x[d] -= cells * length[d];
      }
  }

  Vec<Dim> centre() const { return 0.5 * length; }
  /// Area in 2D, volume in 3D.
  double volume() const {
    double v = 1;
    for (int d = 0; d < Dim; ++d) v *= length[d];
    return v;
  }

 private:
  static constexpr std::array<bool, Dim> all_periodic() {
    std::array<bool, Dim> p{};
    for (bool& x : p) x = true;
    return p;
  }
};

}  // namespace supple
