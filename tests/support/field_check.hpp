/// What must hold for a whole force field of bodies; term_check.hpp is the same for single terms.
#pragma once
#include <gtest/gtest.h>

#include <cmath>

#include "supple/force/force_field.hpp"

namespace supple::testing {

/// Checks forces and Hessian against central differences of energy and forces, the virial against
/// -dU/d(strain) of sites and cell strained together, that there is no net force (in a periodic cell), and
/// that forces are the same with and without energies.
template <int Dim>
class FieldCheck {
 public:
  FieldCheck(ForceField<Dim>& field, System<Dim>& system, double step = 1e-6, double tolerance = 1e-7)
      : field_(field), system_(system), step_(step), tolerance_(tolerance) {}

  void run() {
    field_.evaluate(system_, Detail::energies, at_);
    for (const Vec<Dim>& f : at_.force) scale_ = std::max(scale_, norm(f));
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
    Evaluation<Dim> plain;
    field_.evaluate(system_, Detail::forces, plain);
    EXPECT_EQ(plain.force, at_.force) << "forces with and without energies";
    for (int i = 0; i < system_.state.size(); ++i)
      for (int d = 0; d < Dim; ++d) {
        const double slope = difference(system_.state.position[i][d], [&] { return energy(); });
        EXPECT_NEAR(at_.force[i][d], -slope, tolerance_ * scale_ + 1e-10 * std::abs(at_.energy.stored()))
            << "site " << i << " " << d;
      }
  }

  void check_hessian() {
    HessianBlocks<Dim> blocks;
    field_.add_hessian(system_, blocks);
    const int n = Dim * system_.state.size();
    std::vector<double> h(static_cast<std::size_t>(n) * n);
    const auto at = [&](int row, int column) -> double& {
      return h[static_cast<std::size_t>(row) * n + column];
    };
    double largest = scale_;
    for (const HessianBlock<Dim>& b : blocks)
      for (int c = 0; c < Dim; ++c)
        for (int d = 0; d < Dim; ++d) {
          at(Dim * b.a + c, Dim * b.b + d) += b.h[c][d];
          if (b.a != b.b) at(Dim * b.b + d, Dim * b.a + c) += b.h[c][d];
        }
    for (double value : h) largest = std::max(largest, std::abs(value));
    for (int column = 0; column < n; ++column) {
      double& x = system_.state.position[column / Dim][column % Dim];
      const double x0 = x;
      x = x0 + step_;
      field_.evaluate(system_, Detail::forces, out_);
      const std::vector<Vec<Dim>> above = out_.force;
      x = x0 - step_;
      field_.evaluate(system_, Detail::forces, out_);
      x = x0;
      for (int row = 0; row < n; ++row)
        EXPECT_NEAR(at(row, column),
                    -(above[row / Dim][row % Dim] - out_.force[row / Dim][row % Dim]) / (2 * step_),
                    tolerance_ * largest)
            << "Hessian " << row << ", " << column;
    }
  }

  /// Strains the cell with everything in it: x_i += e_ij x_j. A cell has its lengths and a shear along the
  /// flow, so that only these strains can be made; the virial must be symmetric.
  void check_virial() {
    const std::vector<Vec<Dim>> x = system_.state.position;
    const Box<Dim> box = system_.box;
    const auto strained = [&](int i, int j, double e) {
      system_.state.position = x;
      for (Vec<Dim>& p : system_.state.position) p[i] += e * p[j];
      system_.box = box;
      if (i == j) {
        // The tilt is strain times height: it grows with the length that it lies along.
        system_.box.length[i] *= 1 + e;
        if (i == flow) system_.box.strain *= 1 + e;
        if (i == gradient) system_.box.strain /= 1 + e;
      } else {
        system_.box.strain += e;
      }
      const double u = energy();
      system_.state.position = x;
      system_.box = box;
      return u;
    };
    for (int k = 0; k <= Dim; ++k) {
      const int i = k < Dim ? k : flow, j = k < Dim ? k : gradient;
      const double slope = (strained(i, j, step_) - strained(i, j, -step_)) / (2 * step_);
      EXPECT_NEAR(at_.virial[i][j], -slope,
                  tolerance_ * (scale_ + std::abs(at_.virial[i][j])) + 1e-9 * std::abs(at_.energy.stored()))
          << "virial " << i << j;
    }
    for (int i = 0; i < Dim; ++i)
      for (int j = 0; j < i; ++j)
        EXPECT_NEAR(at_.virial[i][j], at_.virial[j][i], 1e-11 * scale_ * system_.state.size()) << "symmetry";
  }

  void check_balance() {
    Vec<Dim> sum{};
    for (const Vec<Dim>& f : at_.force) sum += f;
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

  ForceField<Dim>& field_;
  System<Dim>& system_;
  double step_, tolerance_, scale_ = 0;
  Evaluation<Dim> at_, out_;
};

}  // namespace supple::testing
