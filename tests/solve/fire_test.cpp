#include "supple/solve/fire.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "tests/support/dense.hpp"
#include "tests/support/objectives.hpp"

namespace supple {
namespace {

using testing::Diagonal;
using testing::SoftDiscs;
using testing::StiffChain;

TEST(Sums, AreThoseOfTheNumbers) {
  for (const int n : {0, 1, 7, 8, 9, 31}) {
    std::vector<double> a(n), b(n);
    double sum = 0;
    for (int i = 0; i < n; ++i) {
      a[i] = i % 2 ? i : -i;
      b[i] = i + 1;
      sum += a[i] * b[i];
    }
    EXPECT_EQ(dot(a, b), sum);
    EXPECT_EQ(largest(a), std::max(0, n - 1));
    add_scaled(-1, a, b);
    for (int i = 0; i < n; ++i) EXPECT_EQ(b[i], i + 1 - a[i]);
  }
}

TEST(Sums, LargestSquareOfPairs) {
  EXPECT_EQ(largest_square_of_pairs({}), 0);
  for (const int n : {2, 6, 8, 10, 16, 22})
    for (int at = 0; at < n; at += 2) {
      std::vector<double> a(n, 1.0);
      a[at] = -3;
      a[at + 1] = 4;
      EXPECT_EQ(largest_square_of_pairs(a), 25) << n << ' ' << at;
    }
}

/// An objective whose gradient alone is cheaper: energies are asked for where someone looks at them, and at
/// the end.
TEST(Fire, ReportsTheEnergyOfTheLastPoint) {
  struct Cheap : StiffChain {
    using StiffChain::StiffChain;
    double evaluate(std::span<const double> x, std::span<double> g) override {
      return ++with_energy, StiffChain::evaluate(x, g);
    }
    void evaluate_slope(std::span<const double> x, std::span<double> g) override {
      StiffChain::evaluate(x, g);
    }
    double tolerance() const override { return 1e-3; }
    int with_energy = 0;
  } chain(40, 1e3, 0.5);
  std::vector<double> x(40, 3.0), unused(40);
  Descent descent(chain, x);
  descent.evaluate();
  Fire().run(descent, 1, 10000);
  EXPECT_TRUE(descent.finished());
  EXPECT_EQ(descent.report.energy, chain.evaluate(x, unused));
  EXPECT_LT(chain.with_energy, descent.report.evaluations / 4);
}

TEST(LargestEigenvalue, IsThatOfTheHessianAndMovesNothing) {
  SoftDiscs discs(60, 0.95);
  std::vector<double> x = discs.start(1), direction;
  Descent descent(discs, x);
  descent.evaluate();
  SparseMatrix lower;
  discs.hessian(x, lower);
  const Eigen::MatrixXd full = testing::dense(lower);
  const auto values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(full).eigenvalues();
  const double expected = std::max(values[119], -values[0]);
  const auto gradient = descent.gradient;
  const auto origin = x;
  const double rough = largest_eigenvalue(descent, direction, 10);
  EXPECT_GT(rough, 0.85 * expected);
  EXPECT_LT(rough, 1.001 * expected);
  EXPECT_NEAR(largest_eigenvalue(descent, direction, 60) / expected, 1, 0.01);  // goes on where it was
  EXPECT_EQ(descent.report.evaluations, 71);
  EXPECT_EQ(x, origin);
  EXPECT_EQ(descent.gradient, gradient);
}

TEST(LargestEigenvalue, IsZeroWithoutForces) {
  Diagonal flat({0, 0}, {0, 0});
  std::vector<double> x = {1, 2}, direction;
  Descent descent(flat, x);
  descent.evaluate();
  EXPECT_EQ(largest_eigenvalue(descent, direction, 5), 0);
}

// The stiffest direction decides how long the softest takes: a condition of 1e4 costs some 10^2 x a few
// steps.
TEST(Fire, NeedsAboutAsManyStepsAsTheRootOfTheCondition) {
  StiffChain chain(50, 1e4, 0);
  chain.goal = 1e-8;
  std::vector<double> x(50, 20.0);
  Descent descent(chain, x);
  descent.evaluate();
  Fire().run(descent, 1, 100000);
  EXPECT_TRUE(descent.report.converged);
  EXPECT_LT(descent.report.evaluations, 1500);
  EXPECT_GT(descent.report.evaluations, 100);
}

TEST(Fire, NeverMovesFasterThanAllowed) {
  struct Slow : SoftDiscs {
    using SoftDiscs::SoftDiscs;
    double largest_move() const override { return 1e-3; }
    double evaluate(std::span<const double> x, std::span<double> g) override {
      if (!last.empty())
        for (std::size_t i = 0; i < x.size(); ++i) furthest = std::max(furthest, std::abs(x[i] - last[i]));
      last.assign(x.begin(), x.end());
      return SoftDiscs::evaluate(x, g);
    }
    std::vector<double> last;
    double furthest = 0;
  } discs(60, 0.9);
  std::vector<double> x = discs.start(1);
  Descent descent(discs, x);
  descent.evaluate();
  Fire().run(descent, 1, 200);
  EXPECT_LT(discs.furthest, 1.51e-3);  // turning back adds half a step
  EXPECT_GT(discs.furthest, 0.9e-3);
}

// Steps at the limit of stability are cut rather than blown up.
TEST(Fire, StepsThatAreTooLongAreCut) {
  for (const double step : {1.0, 1.3, 3.0}) {
    SoftDiscs discs(60, 0.9);
    discs.absolute = 1e-9;
    std::vector<double> x = discs.start(1);
    Descent descent(discs, x);
    descent.max_evaluations = 50000;
    descent.evaluate();
    Fire({.step = step}).run(descent, 1, 50000);
    EXPECT_TRUE(descent.report.converged) << step;
  }
}

}  // namespace
}  // namespace supple
