#include "supple/solve/line_search.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/objectives.hpp"

namespace supple {
namespace {

using testing::Diagonal;

constexpr double inf = std::numeric_limits<double>::infinity();

struct Search {
  Diagonal objective{{2, 0.5}, {0, 1}};
  std::vector<double> x = {1, 1};
  Descent descent{objective, x};
  Search() { descent.evaluate(); }
};

TEST(LineSearch, FindsItsWayFromAnyFirstStep) {
  for (const double first : {1e-6, 1e-3, 1.0, 30.0, 1e6}) {
    Search s;
    const double energy = s.descent.report.energy, slope = s.descent.gradient[0];
    const std::vector<double> direction = {-0.5, 0};  // the minimum is two of it away
    const double step = line_search(s.descent, direction, first, inf);
    EXPECT_GT(step, 0);
    EXPECT_EQ(s.x[0], 1 - 0.5 * step);
    EXPECT_LE(s.descent.report.energy, energy - 0.1 * step * 0.5 * slope);  // sufficient decrease
    EXPECT_LE(s.descent.gradient[0], 0.9 * slope);                          // and curvature
    EXPECT_EQ(s.descent.gradient[0], 2 * s.x[0]);
    EXPECT_LE(s.descent.report.evaluations, 25);
  }
}

TEST(LineSearch, TakesNoMoreThanItMay) {
  Search s;
  EXPECT_EQ(line_search(s.descent, std::vector<double>{-0.5, 0}, 1.0, 0.01), 0.01);
  EXPECT_EQ(s.x[0], 1 - 0.5 * 0.01);
}

TEST(LineSearch, ComesBackFromADirectionUphill) {
  Search s;
  const double energy = s.descent.report.energy;
  EXPECT_EQ(line_search(s.descent, std::vector<double>{0.5, 0}, 1.0, inf), 0);
  EXPECT_EQ(s.x[0], 1);
  EXPECT_EQ(s.descent.report.energy, energy);
  EXPECT_EQ(s.descent.gradient[0], 2);
}

/// Its slope says that it falls along -x; its energy, that it rises.
class Liar : public Diagonal {
 public:
  using Diagonal::Diagonal;
  double evaluate(std::span<const double> x, std::span<double> g) override {
    return -Diagonal::evaluate(x, g);
  }
};

TEST(LineSearch, ComesBackWhenNoStepIsGood) {
  Liar liar({1}, {0});
  std::vector<double> x = {1};
  Descent descent(liar, x);
  descent.evaluate();
  const double step = line_search(descent, std::vector<double>{-1}, 1.0, inf);
  EXPECT_LT(step, 1e-3);
  EXPECT_EQ(x[0], 1 - step);
  EXPECT_EQ(descent.gradient[0], x[0]);
}

/// 1 + 1e-14 x^2: near its minimum differences of energy are lost.
class Raised : public Diagonal {
 public:
  using Diagonal::Diagonal;
  double evaluate(std::span<const double> x, std::span<double> g) override {
    return 1 + Diagonal::evaluate(x, g);
  }
};

TEST(LineSearch, GradientsDecideBelowRounding) {
  Raised raised({2e-14}, {0});
  std::vector<double> x = {1e-3};
  Descent descent(raised, x);
  descent.evaluate();
  EXPECT_EQ(line_search(descent, std::vector<double>{-1e-3}, 1.0, inf), 1);
  EXPECT_EQ(x[0], 0);
}

}  // namespace
}  // namespace supple
