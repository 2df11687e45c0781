#include "supple/core/rounded_to_float.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace supple {
namespace {

TEST(RoundedToFloat, IsTheDoubleOfTheNearestFloat) {
  EXPECT_EQ(rounded_to_float(0.1), 0.100000001490116119384765625);
  EXPECT_EQ(rounded_to_float(1 + 0x1p-24), 1);  // halfway: to the even one
  EXPECT_EQ(rounded_to_float(1 + 0x1.8p-24), 1 + 0x1p-23);
  EXPECT_EQ(rounded_to_float(-0x1p-150), 0);
  EXPECT_EQ(rounded_to_float(1e39), std::numeric_limits<double>::infinity());
}

/// In a loop, too, where a compiler rounds several at once.
TEST(RoundedToFloat, RoundsEveryNumberOfALoop) {
  std::vector<double> xs;
  for (int k = 0; k < 100; ++k) xs.push_back(1 + 0.01 * k + 1e-9);
  std::vector<double> rounded = xs;
  for (double& x : rounded) x = rounded_to_float(x);
  for (std::size_t k = 0; k < xs.size(); ++k) {
    EXPECT_NE(rounded[k], xs[k]);
    EXPECT_EQ(static_cast<float>(rounded[k]), static_cast<float>(xs[k]));
  }
}

}  // namespace
}  // namespace supple
