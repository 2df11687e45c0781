#include "supple/core/jet.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace supple {
namespace {

/// Every operation at once; smooth and well inside the domain of each for x, y > 0.
template <class S>
S everything(const S& x, const S& y) {
  using std::abs, std::atan2, std::cos, std::exp, std::log, std::pow, std::sin, std::sqrt;
  S z = 2.0 * x + y * 3.0 - x / y + 1.0 / (1.0 + x * x) - (y - 0.3) * (2.0 - x) / 4.0;
  z = z + sqrt(x * y) + exp(-x) * log(y + 1.0) + sin(x) * cos(y) + pow(x, 2.5) + atan2(y, -x) +
      abs(x - 10.0 * y);
  z *= x;
  z /= y;
  z -= x;
  z += y;
  return z;
}

TEST(Jet, DerivativesOfEveryOperationAgreeWithDifferences) {
  using First = Jet<double, 2>;
  using Second = Jet<First, 2>;
  const double x0 = 0.8, y0 = 1.7, h = 1e-4;
  Second x = x0, y = y0;
  x.value.slope[0] = 1;
  x.slope[0] = 1.0;
  y.value.slope[1] = 1;
  y.slope[1] = 1.0;
  const Second f = everything(x, y);

  const auto at = [&](double i, double j) { return everything(x0 + i * h, y0 + j * h); };
  EXPECT_NEAR(value_of(f), at(0, 0), 1e-14 * std::abs(at(0, 0)));
  EXPECT_NEAR(f.value.slope[0], (at(1, 0) - at(-1, 0)) / (2 * h), 1e-6);
  EXPECT_NEAR(f.value.slope[1], (at(0, 1) - at(0, -1)) / (2 * h), 1e-6);
  EXPECT_NEAR(f.slope[0].slope[0], (at(1, 0) - 2 * at(0, 0) + at(-1, 0)) / (h * h), 1e-5);
  EXPECT_NEAR(f.slope[1].slope[1], (at(0, 1) - 2 * at(0, 0) + at(0, -1)) / (h * h), 1e-5);
  EXPECT_NEAR(f.slope[0].slope[1], (at(1, 1) - at(1, -1) - at(-1, 1) + at(-1, -1)) / (4 * h * h), 1e-5);
  EXPECT_EQ(f.slope[0].value, f.value.slope[0]);
  EXPECT_NEAR(f.slope[0].slope[1], f.slope[1].slope[0], 1e-13);
}

TEST(Jet, ComparesByValueAndConstantsHaveNoSlope) {
  const Jet<double, 3> a(2.0), b(3.0);
  EXPECT_TRUE(a < b);
  EXPECT_TRUE(b > a);
  EXPECT_EQ((a * b).slope, (std::array<double, 3>{}));
}

}  // namespace
}  // namespace supple
