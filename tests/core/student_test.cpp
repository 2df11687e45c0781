/// Against printed tables of Student's distribution.
#include "supple/core/student.hpp"

#include <gtest/gtest.h>

namespace supple {
namespace {

TEST(Student, TwoSidedQuantilesOfTheTables) {
  EXPECT_NEAR(student_probability(12.7062, 1), 0.95, 1e-6);
  EXPECT_NEAR(student_probability(4.30265, 2), 0.95, 1e-6);
  EXPECT_NEAR(student_probability(3.18245, 3), 0.95, 1e-6);
  EXPECT_NEAR(student_probability(2.77645, 4), 0.95, 1e-6);
  EXPECT_NEAR(student_probability(9.92484, 2), 0.99, 1e-6);
  EXPECT_NEAR(student_probability(2.04227, 30), 0.95, 1e-6);
  EXPECT_NEAR(student_probability(2.03951, 31), 0.95, 1e-6);
}

TEST(Student, FactorFallsTowardsOne) {
  // GUM, table G.2, for 95.45 %: t = 13.97, 4.53, 3.31, 2.87, 2.28 (10), 2.05 (50).
  EXPECT_NEAR(2 * student_factor(1), 13.97, 0.005);
  EXPECT_NEAR(2 * student_factor(2), 4.53, 0.005);
  EXPECT_NEAR(2 * student_factor(3), 3.31, 0.005);
  EXPECT_NEAR(2 * student_factor(4), 2.87, 0.005);
  EXPECT_NEAR(2 * student_factor(10), 2.28, 0.005);
  EXPECT_NEAR(2 * student_factor(50), 2.05, 0.006);
  EXPECT_NEAR(student_factor(1000000), 1, 0.002);
}

}  // namespace
}  // namespace supple
