#include "supple/observe/jump_correction.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace supple {
namespace {

constexpr double side = 100;

/// A column of three discs that touch, carried rigidly to `x`, their contacts loaded by these repulsions.
struct Column {
  System<2> system;
  Evaluation<2> evaluation;

  Column() {
    system.box.length = {side, side};
    system.state.resize(3);
    system.state.mass = system.state.inertia = {1, 1, 1};
    system.pairs.first = {0, 1};
    system.pairs.second = {1, 2};
    system.pairs.state.resize(2);
    evaluation.force.resize(3);
    evaluation.torque.resize(3);
    evaluation.pair.resize(2);
  }

  void place(double x, double y, double lower, double upper) {
    system.state.position = {{x, y}, {x + 6, y + 8}, {x + 2, y + 17}};
    Vec2 v{};
    for (Vec2& r : system.state.position) system.box.wrap(r, v);
    for (int row = 0; row < 2; ++row) {
      const auto s = system.box.separation(system.state.position[row], system.state.position[row + 1]);
      const double d = norm(s.r);
      evaluation.pair[row] = {(1 / d) * s.r, d, row ? upper : lower, 0, 0.5, s.up, s.crosses, true};
    }
  }
  StressTensors tensors() const { return stress_tensors(system, evaluation, 2); }
};

/// Largest step of the published and of the corrected series while the column is carried over the cut and
/// back.
struct Steps {
  double published = 0, corrected = 0, last_removed = 0;
};
Steps carried(Vec2 velocity, double strain, int steps, bool back) {
  Column column;
  column.system.box.strain = strain;
  JumpCorrection correction;
  Steps largest;
  double published = 0, corrected = 0;
  for (int k = 0; k <= steps; ++k) {
    const int at = back && k > steps / 2 ? steps - k : k;
    const double load = back ? 3 : 3 + 0.001 * k;
    column.place(80 + at * velocity[0], 70 + at * velocity[1], load, 2 * load);
    const StressTensors t = column.tensors();
    const double value = correction.corrected(column.system, column.evaluation, t, 2);
    EXPECT_NEAR(value + correction.removed(), t.shear_external(), 1e-15);
    if (k > 0) {
      largest.published = std::max(largest.published, std::abs(t.shear_external() - published));
      largest.corrected = std::max(largest.corrected, std::abs(value - corrected));
    }
    published = t.shear_external();
    corrected = value;
  }
  largest.last_removed = correction.removed();
  return largest;
}

TEST(JumpCorrection, TakesOutTheJumpsAtThePeriodAlongTheFlow) {
  const Steps s = carried({0.5, 0}, 0, 60, false);
  EXPECT_GT(s.published, 1e-3);
  EXPECT_LT(s.corrected, 1e-5);  // what the loads change in a step
}

TEST(JumpCorrection, TakesOutTheJumpsOfAShearedCell) {
  const Steps s = carried({0.1, 0.5}, 0.37, 80, false);
  EXPECT_GT(s.published, 1e-3);
  EXPECT_LT(s.corrected, 3e-5);
}

TEST(JumpCorrection, JumpsThereAndBackCancelUnderConstantForces) {
  EXPECT_NEAR(carried({0.5, 0}, 0, 120, true).last_removed, 0, 1e-15);
  EXPECT_GT(std::abs(carried({0.5, 0}, 0, 38, false).last_removed), 1e-3);  // half-way across
}

TEST(JumpCorrection, LeavesASeriesWithoutCrossingsAlone) {
  EXPECT_EQ(carried({-0.5, -0.5}, 0, 60, false).last_removed, 0);
}

}  // namespace
}  // namespace supple
