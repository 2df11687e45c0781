#include "supple/solve/newton.hpp"

#include <gtest/gtest.h>

#include "supple/solve/fire.hpp"
#include "tests/support/objectives.hpp"

namespace supple {
namespace {

using testing::Diagonal;
using testing::Rosenbrock;
using testing::SoftDiscs;
using testing::Springs;

MinimiseReport newton_alone(Objective& objective, std::vector<double>& x, int memory) {
  Descent descent(objective, x);
  descent.evaluate();
  NewtonSpec spec;
  spec.memory = memory;
  EXPECT_TRUE(Newton(spec).run(descent, 2000)) << memory;
  EXPECT_TRUE(descent.report.converged) << memory << " " << descent.report.residual;
  return descent.report;
}

TEST(Newton, MemorySavesFactorisations) {
  long factorisations[2];
  for (const int memory : {0, 12}) {
    Springs springs(150, 0.2, 0.05, 2);
    std::vector<double> x = springs.start(0.01);
    factorisations[memory / 12] = newton_alone(springs, x, memory).factorisations;
  }
  EXPECT_LT(factorisations[1], factorisations[0]);
}

TEST(Newton, LeavesAMaximum) {
  for (const int memory : {0, 12}) {
    Diagonal objective({-2, 1, -2}, {4, 0, 4});
    std::vector<double> x = {1e-9, 1, -1e-9};
    newton_alone(objective, x, memory);
    EXPECT_NEAR(x[0], std::sqrt(0.5), 1e-9);
    EXPECT_NEAR(x[2], -std::sqrt(0.5), 1e-9);
  }
}

TEST(Newton, FlatAndQuarticDirections) {
  for (const int memory : {0, 12}) {
    Diagonal objective({1, 0, 0, 1e-6}, {0, 1, 0, 1});
    std::vector<double> x = {1, 1, 1, 1};
    newton_alone(objective, x, memory);
    EXPECT_EQ(x[2], 1);
    EXPECT_LT(std::abs(x[1]), 1.01e-4);
  }
}

TEST(Newton, RosenbrockValley) {
  for (const int memory : {0, 12}) {
    Rosenbrock valley(100);
    std::vector<double> x(100, 0.2);
    newton_alone(valley, x, memory);
    for (const double c : x) ASSERT_NEAR(c, 1, 1e-8);
  }
}

/// The same springs in blocks of three: as good a minimum, after about as many steps.
TEST(Newton, ChoosesTheBlocksThatTheObjectiveAsksFor) {
  struct InThrees : Springs {
    using Springs::Springs;
    int block_size() const override { return 3; }
  };
  Springs in_twos(149, 0.2, 0.05, 2);
  InThrees in_threes(149, 0.2, 0.05, 2);
  std::vector<double> x = in_twos.start(0.01), y = x;
  const MinimiseReport a = newton_alone(in_twos, x, 0), b = newton_alone(in_threes, y, 0);
  EXPECT_NE(x, y);  // rounding tells one from the other
  EXPECT_NEAR(a.energy, b.energy, 1e-10 * a.energy);
  EXPECT_NEAR(static_cast<double>(a.iterations), static_cast<double>(b.iterations), 3);

  // One minimiser may be given one after the other.
  Newton newton({.memory = 0});
  for (Objective* objective : {static_cast<Objective*>(&in_twos), static_cast<Objective*>(&in_threes)}) {
    std::vector<double> z = in_twos.start(0.01);
    Descent descent(*objective, z);
    descent.evaluate();
    EXPECT_TRUE(newton.run(descent, 2000));
    EXPECT_TRUE(descent.report.converged);
    EXPECT_NEAR(descent.report.energy, a.energy, 1e-10 * a.energy);
  }
}

// After FIRE has found the contacts, the rest is a few steps.
TEST(Newton, EndsAPackingInFewSteps) {
  for (const int memory : {0, 12}) {
    SoftDiscs discs(100, 0.9);
    discs.absolute = 1e-6;
    std::vector<double> x = discs.start(1);
    Descent descent(discs, x);
    descent.evaluate();
    Fire().run(descent, 1, 100000);
    discs.absolute = 1e-13;
    EXPECT_LE(newton_alone(discs, x, memory).factorisations, 4);
  }
}

}  // namespace
}  // namespace supple
