#include "supple/core/rounded_to_float.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "supple/core/vec.hpp"

namespace supple {
namespace {

TEST(RoundedToFloat, IsTheDoubleOfTheNearestFloat) {
  EXPECT_EQ(rounded_to_float(0.1), 0.100000001490116119384765625);
  EXPECT_EQ(rounded_to_float(1 + 0x1p-24), 1);  // halfway: to the even one
  EXPECT_EQ(rounded_to_float(1 + 0x1.8p-24), 1 + 0x1p-23);
  EXPECT_EQ(rounded_to_float(-0x1p-150), 0);
  EXPECT_EQ(rounded_to_float(1e39), std::numeric_limits<double>::infinity());
}

/// Of every coordinate of a list of points, too, where a compiler rounds several at once.
TEST(RoundedToFloat, RoundsEveryNumberOfALoop) {
  std::vector<Vec3> points;
  for (int k = 0; k < 100; ++k) points.push_back({1 + 0.01 * k + 1e-9, 2 + 0.01 * k + 1e-9, 3 + 1e-9});
  std::vector<Vec3> rounded = points;
  for (Vec3& x : rounded)
    for (int d = 0; d < 3; ++d) x[d] = rounded_to_float(x[d]);
  for (std::size_t k = 0; k < points.size(); ++k)
    for (int d = 0; d < 3; ++d) EXPECT_LT(1e-11, std::abs(rounded[k][d] - points[k][d]));
}

}  // namespace
}  // namespace supple
