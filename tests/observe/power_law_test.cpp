#include "supple/observe/power_law.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "supple/core/error.hpp"

namespace supple {
namespace {

std::vector<double> powers_of_ten(double from, double to, int per_decade) {
  std::vector<double> all;
  const int steps = static_cast<int>(std::lround(per_decade * std::log10(to / from)));
  for (int k = 0; k <= steps; ++k) all.push_back(from * std::pow(10, 1.0 * k / per_decade));
  return all;
}

TEST(PowerLaw, FindsExponentAndFactorWithoutError) {
  const std::vector<double> x = powers_of_ten(1e-4, 1e-1, 10);
  std::vector<double> y;
  for (const double v : x) y.push_back(7 * std::pow(v, 1.5));
  const auto law = fit_power_law(x, y, 1e-3, 1e-2);
  ASSERT_TRUE(law);
  EXPECT_NEAR(law->exponent, 1.5, 1e-12);
  EXPECT_NEAR(law->factor, 7, 1e-10);
  EXPECT_LT(law->error, 1e-12);
  EXPECT_EQ(law->points, 11);  // both ends, which powers meet to rounding only
  EXPECT_NEAR(law->from, 1e-3, 1e-15);
  EXPECT_NEAR(law->to, 1e-2, 1e-14);
}

/// By hand: ln x = 0, 1, 2, ln y = 0, 1.3, 2 gives the slope 1, the line 0.1 + ln x, residuals -0.1, 0.2,
/// -0.1, and the error sqrt(0.06/1/2).
TEST(PowerLaw, TheErrorIsThatOfTheScatter) {
  const std::vector<double> x{1, std::exp(1.0), std::exp(2.0)}, y{1, std::exp(1.3), std::exp(2.0)};
  const auto law = fit_power_law(x, y, 0.5, 10);
  ASSERT_TRUE(law);
  EXPECT_NEAR(law->exponent, 1, 1e-14);
  EXPECT_NEAR(law->factor, std::exp(0.1), 1e-14);
  EXPECT_NEAR(law->error, std::sqrt(0.03), 1e-14);
}

TEST(PowerLaw, LeavesOutWhatHasNoLogarithm) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> x{0, 1, 2, 3, 4, 5}, y{1, 1, 2, nan, 0, 5};
  const auto law = fit_power_law(x, y, 0, 10);
  ASSERT_TRUE(law);
  EXPECT_EQ(law->points, 3);
  EXPECT_NEAR(law->exponent, 1, 1e-12);
  EXPECT_FALSE(fit_power_law(x, y, 1.5, 10));  // two points
  EXPECT_FALSE(fit_power_law(std::vector<double>{2, 2, 2}, std::vector<double>{1, 2, 3}, 1, 3));
  EXPECT_THROW(fit_power_law(x, std::vector<double>{1}, 0, 1), Error);
}

TEST(LocalPowerLaws, FollowACrossover) {
  const std::vector<double> x = powers_of_ten(1e-4, 1, 20);
  std::vector<double> y;
  for (const double v : x) y.push_back(v < 1e-2 ? v : 10 * std::pow(v, 1.5));
  const auto laws = local_power_laws(x, y, 0.5);
  ASSERT_EQ(laws.size(), x.size());
  for (std::size_t k = 0; k < x.size(); ++k) {
    ASSERT_TRUE(laws[k]) << x[k];
    EXPECT_NEAR(laws[k]->to / laws[k]->from, std::sqrt(10), 1e-9) << x[k];  // whole windows at the ends too
    EXPECT_EQ(laws[k]->points, 11) << x[k];
    EXPECT_LE(laws[k]->from, x[k] * (1 + 1e-9));
    EXPECT_GE(laws[k]->to, x[k] * (1 - 1e-9));
    if (x[k] < 5e-3 || x[k] > 2e-2) {
      EXPECT_NEAR(laws[k]->exponent, x[k] < 1e-2 ? 1 : 1.5, 1e-9) << x[k];
    }
  }
  EXPECT_NEAR(laws[40]->exponent, 1.25, 0.01);  // at the corner
  for (const auto& law : local_power_laws(x, y, 4.5)) EXPECT_FALSE(law);
}

}  // namespace
}  // namespace supple
