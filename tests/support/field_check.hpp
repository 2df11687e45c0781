/// What must hold for a whole force field of bodies; term_check.hpp is the same for single terms.
#pragma once
#include <gtest/gtest.h>

#include <cmath>

#include "supple/force/force_field.hpp"

namespace supple::testing {

/// Checks forces and Hessian against central differences of energy and forces, the virial against
/// -dU/d(strain) of sites and cell strained together, that there is no net force (in a periodic cell), and
/// that forces are the same with and without energies.
class FieldCheck {
 public:
  FieldCheck(ForceField<2>& field, System<2>& system, double step = 1e-6, double tolerance = 1e-7)
      : field_(field), system_(system), step_(step), tolerance_(tolerance) {}

  void run() {
    field_.evaluate(system_, Detail::energies, at_);
    for (const Vec2& f : at_.force) scale_ = std::max(scale_, norm(f));
    ASSERT_GT(scale_, 0) << "nothing acts";
    check_forces();
    check_hessian();
    check_virial();
    check_balance();
  }

 private:
  double energy() {
    field_.evaluate(system_, Detail::energies, out_);
    return out_.energy.stored();
  }

  void check_forces() {
    Evaluation<2> plain;
    field_.evaluate(system_, Detail::forces, plain);
    EXPECT_EQ(plain.force, at_.force) << "forces with and without energies";
    for (int i = 0; i < system_.state.size(); ++i)
      for (int d = 0; d < 2; ++d) {
        const double slope = difference(system_.state.position[i][d], [&] { return energy(); });
        EXPECT_NEAR(at_.force[i][d], -slope, tolerance_ * scale_ + 1e-10 * std::abs(at_.energy.stored()))
            << "site " << i << " " << d;
      }
  }

  void check_hessian() {
    HessianBlocks<2> blocks;
    field_.add_hessian(system_, blocks);
    const int n = 2 * system_.state.size();
    std::vector<double> h(static_cast<std::size_t>(n) * n);
    const auto at = [&](int row, int column) -> double& {
      return h[static_cast<std::size_t>(row) * n + column];
    };
    double largest = scale_;
    for (const HessianBlock<2>& b : blocks)
      for (int c = 0; c < 2; ++c)
        for (int d = 0; d < 2; ++d) {
          at(2 * b.a + c, 2 * b.b + d) += b.h[c][d];
          if (b.a != b.b) at(2 * b.b + d, 2 * b.a + c) += b.h[c][d];
        }
    for (double value : h) largest = std::max(largest, std::abs(value));
    for (int column = 0; column < n; ++column) {
      double& x = system_.state.position[column / 2][column % 2];
      const double x0 = x;
      x = x0 + step_;
      field_.evaluate(system_, Detail::forces, out_);
      const std::vector<Vec2> above = out_.force;
      x = x0 - step_;
      field_.evaluate(system_, Detail::forces, out_);
      x = x0;
      for (int row = 0; row < n; ++row)
        EXPECT_NEAR(at(row, column), -(above[row / 2][row % 2] - out_.force[row / 2][row % 2]) / (2 * step_),
                    tolerance_ * largest)
            << "Hessian " << row << ", " << column;
    }
  }

  /// Strains the cell with everything in it: x_i += e_ij x_j. A cell has two lengths and a shear along the
  /// flow, so that only these three strains can be made; the fourth component of the virial must equal the
  /// third.
  void check_virial() {
    const std::vector<Vec2> x = system_.state.position;
    const Box<2> box = system_.box;
    const auto strained = [&](int i, int j, double e) {
      system_.state.position = x;
      for (Vec2& p : system_.state.position) p[i] += e * p[j];
      system_.box = box;
      if (i == j) {
        // The tilt is strain times height: it grows with the length that it lies along.
        system_.box.length[i] *= 1 + e;
        system_.box.strain *= i == flow ? 1 + e : 1 / (1 + e);
      } else {
        system_.box.strain += e;
      }
      const double u = energy();
      system_.state.position = x;
      system_.box = box;
      return u;
    };
    for (const auto& [i, j] : {std::pair{0, 0}, {1, 1}, {flow, gradient}}) {
      const double slope = (strained(i, j, step_) - strained(i, j, -step_)) / (2 * step_);
      EXPECT_NEAR(at_.virial[i][j], -slope,
                  tolerance_ * (scale_ + std::abs(at_.virial[i][j])) + 1e-9 * std::abs(at_.energy.stored()))
          << "virial " << i << j;
    }
    EXPECT_NEAR(at_.virial[0][1], at_.virial[1][0], 1e-11 * scale_ * system_.state.size()) << "symmetry";
  }

  void check_balance() {
    Vec2 sum{};
    for (const Vec2& f : at_.force) sum += f;
    EXPECT_LT(norm(sum), 1e-12 * scale_ * system_.state.size()) << "net force";
  }

  template <class F>
  double difference(double& x, F&& f) {
    const double x0 = x;
    x = x0 + step_;
    const double above = f();
    x = x0 - step_;
    const double below = f();
    x = x0;
    return (above - below) / (2 * step_);
  }

  ForceField<2>& field_;
  System<2>& system_;
  double step_, tolerance_, scale_ = 0;
  Evaluation<2> at_, out_;
};

}  // namespace supple::testing
