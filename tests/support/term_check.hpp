/// What must hold for every conservative term, in 2D and 3D.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "supple/core/random.hpp"
#include "supple/force/terms.hpp"

namespace supple::testing {

/// Fills the points and parameters of one trial from the stream.
template <class Term, int Dim>
using TermDraw = std::function<void(RandomStream&, Points<Term, Dim>&, typename Term::Param&)>;

/// Points with coordinates uniform in [-1, 1), for terms that are smooth there.
template <int Dim, std::size_t N>
void draw_points(RandomStream& draw, Vec<Dim> (&x)[N]) {
  for (Vec<Dim>& point : x)
    for (int d = 0; d < Dim; ++d) point[d] = draw.uniform(-1, 1);
}

/// A rotation matrix: turns about each pair of axes in turn.
template <int Dim>
Mat<Dim> random_rotation(RandomStream& draw) {
  Mat<Dim> r;
  for (int d = 0; d < Dim; ++d) r[d][d] = 1;
  for (int a = 0; a < Dim; ++a)
    for (int b = a + 1; b < Dim; ++b) {
      const double angle = draw.uniform(0, 6.3), c = std::cos(angle), s = std::sin(angle);
      for (int row = 0; row < Dim; ++row) {
        const double p = r[row][a], q = r[row][b];
        r[row][a] = c * p - s * q;
        r[row][b] = s * p + c * q;
      }
    }
  return r;
}

template <int Dim>
Vec<Dim> transform(const Mat<Dim>& m, const Vec<Dim>& x) {
  Vec<Dim> y{};
  for (int a = 0; a < Dim; ++a)
    for (int b = 0; b < Dim; ++b) y[a] += m[a][b] * x[b];
  return y;
}

/// Checks one term at random points: gradient and Hessian against central differences; a hand-written
/// gradient against the differentiated energy; no net force or torque; invariance to translation and
/// rotation; and, through StencilBlock, force = -gradient and virial = -dE/d(strain).
template <class Term, int Dim>
class TermCheck {
 public:
  explicit TermCheck(TermDraw<Term, Dim> draw, int trials = 25, double tolerance = 1e-7)
      : draw_(std::move(draw)), trials_(trials), tolerance_(tolerance) {}

  void run() {
    for (int trial = 0; trial < trials_; ++trial) {
      SCOPED_TRACE(::testing::Message() << Term::name << ", " << Dim << "D, trial " << trial);
      RandomStream stream(1, Purpose::test, static_cast<std::uint64_t>(trial));
      draw_(stream, x_, p_);
      energy_ = term_gradient<Term, Dim>(x_, p_, g_);
      scale_ = 1e-300;
      for (const Vec<Dim>& g : g_) scale_ = std::max(scale_, norm(g));
      largest_scale_ = std::max(largest_scale_, scale_);
      check_gradient();
      check_hessian();
      check_balance();
      check_invariance(stream);
      check_driver();
      if (::testing::Test::HasFailure()) return;
    }
    EXPECT_GT(largest_scale_, 1e-6) << "no trial has a force: nothing was checked";
  }

 private:
  static constexpr int n = Term::arity * Dim;
  static constexpr double step = 1e-5;

  double& coordinate(int k) { return x_[k / Dim][k % Dim]; }
  double energy() const { return Term::energy(x_, p_); }

  /// Central difference of f() by coordinate k.
  template <class F>
  auto difference(int k, F&& f) {
    const double x0 = coordinate(k);
    coordinate(k) = x0 + step;
    const auto above = f();
    coordinate(k) = x0 - step;
    const auto below = f();
    coordinate(k) = x0;
    return std::pair(above, below);
  }

  void check_gradient() {
    EXPECT_NEAR(energy_, energy(), 1e-14 * std::abs(energy_));
    for (int k = 0; k < n; ++k) {
      const auto [above, below] = difference(k, [&] { return energy(); });
      EXPECT_NEAR(g_[k / Dim][k % Dim], (above - below) / (2 * step),
                  tolerance_ * (scale_ + std::abs(energy_)))
          << "gradient, coordinate " << k;
    }
    if constexpr (HasGradient<Term, Dim>) {
      Points<Term, Dim> by_jets;
      EXPECT_NEAR((jet_gradient<Term, Dim>(x_, p_, by_jets)), energy_, 1e-13 * std::abs(energy_));
      for (int a = 0; a < Term::arity; ++a)
        EXPECT_LT(norm(g_[a] - by_jets[a]), 1e-12 * scale_) << "hand-written gradient";
    }
  }

  void check_hessian() {
    const TermHessian<Term, Dim> h = term_hessian<Term, Dim>(x_, p_);
    double largest = scale_;
    for (const auto& row : h)
      for (const double value : row) largest = std::max(largest, std::abs(value));
    for (int k = 0; k < n; ++k) {
      const auto [above, below] = difference(k, [&] {
        std::array<Vec<Dim>, Term::arity> gradient;
        Points<Term, Dim> g;
        term_gradient<Term, Dim>(x_, p_, g);
        std::copy(std::begin(g), std::end(g), gradient.begin());
        return gradient;
      });
      for (int l = 0; l < n; ++l) {
        EXPECT_NEAR(h[l][k], (above[l / Dim][l % Dim] - below[l / Dim][l % Dim]) / (2 * step),
                    tolerance_ * largest)
            << "Hessian " << l << ", " << k;
        EXPECT_NEAR(h[l][k], h[k][l], 1e-12 * largest) << "symmetry of the Hessian";
      }
    }
  }

  void check_balance() const {
    Vec<Dim> force{};
    Angular<Dim> torque{};
    for (int a = 0; a < Term::arity; ++a) {
      force -= g_[a];
      torque -= cross(x_[a], g_[a]);
    }
    EXPECT_LT(norm(force), 1e-12 * scale_) << "net force";
    if constexpr (Dim == 2) EXPECT_LT(std::abs(torque), 1e-12 * scale_) << "net torque";
    else EXPECT_LT(norm(torque), 1e-12 * scale_) << "net torque";
  }

  void check_invariance(RandomStream& stream) const {
    const Mat<Dim> rotation = random_rotation<Dim>(stream);
    Vec<Dim> shift;
    for (int d = 0; d < Dim; ++d) shift[d] = stream.uniform(-3, 3);
    Points<Term, Dim> moved;
    for (int a = 0; a < Term::arity; ++a) moved[a] = transform(rotation, x_[a]) + shift;
    EXPECT_NEAR(Term::energy(moved, p_), energy_, 1e-11 * (std::abs(energy_) + scale_)) << "rigid motion";
  }

  void check_driver() const {
    System<Dim> system;
    std::array<std::int32_t, Term::arity> stencil;
    system.state.resize(Term::arity + 1);  // the sites in reverse, and one that takes no part
    for (int a = 0; a < Term::arity; ++a) {
      stencil[a] = Term::arity - a;
      system.state.position[stencil[a]] = x_[a];
    }
    TermSet<Dim> terms;
    terms.add(Term{}, {stencil}, {p_});
    Evaluation<Dim> out;
    out.force.resize(system.state.size());
    terms.evaluate(system, Detail::energies, out);
    EXPECT_EQ(out.energy.terms, energy_);
    EXPECT_EQ(out.force[0], Vec<Dim>{});
    for (int a = 0; a < Term::arity; ++a) EXPECT_EQ(out.force[stencil[a]], -g_[a]);
    for (int i = 0; i < Dim; ++i)
      for (int j = 0; j < Dim; ++j) {
        const auto strained = [&](double strain) {  // x_i -> x_i + strain x_j
          Points<Term, Dim> x;
          for (int a = 0; a < Term::arity; ++a) {
            x[a] = x_[a];
            x[a][i] += strain * x_[a][j];
          }
          return Term::energy(x, p_);
        };
        EXPECT_NEAR(out.virial[i][j], -(strained(step) - strained(-step)) / (2 * step),
                    tolerance_ * (scale_ + std::abs(energy_)))
            << "virial " << i << ", " << j;
      }
  }

  TermDraw<Term, Dim> draw_;
  int trials_;
  double tolerance_;
  Points<Term, Dim> x_, g_;
  typename Term::Param p_;
  double energy_ = 0, scale_ = 0, largest_scale_ = 0;
};

/// Runs TermCheck on `Term` with points and parameters from `draw`.
template <class Term, int Dim>
void check_term(TermDraw<Term, Dim> draw) {
  TermCheck<Term, Dim>(std::move(draw)).run();
}

}  // namespace supple::testing
