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
