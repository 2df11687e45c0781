#include "supple/geometry/inverse_root.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace supple {
namespace {

TEST(InverseRoot, IsWithinItsStatedError) {
  double worst = 0;
  for (int k = 0; k < 400000; ++k) {
    const double x = std::exp2(-40 + k * 2e-4);
    worst = std::max(worst, std::abs(inverse_root(x) * std::sqrt(x) - 1));
  }
  EXPECT_LT(worst, 6e-16);
}

TEST(InverseRoot, TimesZeroIsZeroAtZero) { EXPECT_EQ(0 * inverse_root(0), 0); }

}  // namespace
}  // namespace supple
