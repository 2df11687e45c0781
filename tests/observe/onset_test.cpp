#include "supple/observe/onset.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace supple {
namespace {

/// P = 0.3 (phi - 0.84) at pressures spaced logarithmically, stiffer above 1e-3.
struct Branch {
  std::vector<double> packing_fraction, pressure;
  Branch() {
    for (double p = 1e-7; p < 2e-2; p *= std::pow(10, 0.25)) {
      pressure.push_back(p);
      packing_fraction.push_back(0.84 + p / 0.3 - (p > 1.01e-3 ? 0.5 * (p - 1e-3) : 0));
    }
  }
};

TEST(Onset, IsThatOfALineWhateverLiesAbove) {
  const Branch b;
  const auto fit = fit_onset(b.packing_fraction, b.pressure, 1.01e-3);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->packing_fraction, 0.84, 1e-13);
  EXPECT_NEAR(fit->slope, 0.3, 1e-11);
  EXPECT_LT(fit->packing_fraction_error, 1e-13);
  EXPECT_EQ(fit->points, 17);
}

TEST(Onset, ErrorsAreThoseOfRegression) {
  // Residuals of phi are +-1e-3 at P = 1, 2, 3, 4 such that the line stays: -1, +1, +1, -1 leave slope and
  // mean.
  const std::vector<double> p{1, 2, 3, 4}, phi{0.899, 1.001, 1.101, 1.199};
  const auto fit = fit_onset(phi, p, 10);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->packing_fraction, 0.8, 1e-14);
  EXPECT_NEAR(fit->slope, 10, 1e-12);
  const double s = std::sqrt(4e-6 / 2);
  EXPECT_NEAR(fit->packing_fraction_error, s * std::sqrt(1.0 / 4 + 2.5 * 2.5 / 5), 1e-12);
  EXPECT_NEAR(fit->slope_error, 100 * s / std::sqrt(5), 1e-10);
}

TEST(Onset, NeedsThreePointsThatRise) {
  const Branch b;
  EXPECT_FALSE(fit_onset(b.packing_fraction, b.pressure, 2e-7));
  EXPECT_FALSE(fit_onset(std::vector{0.9, 0.8, 0.7}, std::vector{1.0, 2.0, 3.0}, 10));
  EXPECT_TRUE(fit_onset(std::vector{0.7, 0.8, 0.9, 0.1}, std::vector{1.0, 2.0, 3.0, 0.0}, 10));
}

/// Above a jump of the packing fraction by 0.004 it is another packing, twice as stiff: of both branches the
/// part at the lowest pressures counts, whichever way it was walked.
TEST(Onset, IsOfThePartBelowTheJump) {
  std::vector<double> p, phi;
  std::vector<std::uint8_t> jumped;
  for (double at = 1e-7; at < 1.01e-3; at *= std::pow(10, 0.25)) {
    jumped.push_back(p.size() == 8);
    phi.push_back(p.size() < 8 ? 0.84 + at / 0.283 : 0.844 + at / 0.566);
    p.push_back(at);
  }
  const auto up = fit_onset(phi, p, jumped, 1.01e-3);
  ASSERT_TRUE(up);
  EXPECT_NEAR(up->packing_fraction, 0.84, 1e-12);
  EXPECT_NEAR(up->slope, 0.283, 1e-9);
  EXPECT_EQ(up->points, 8);
  std::reverse(p.begin(), p.end());
  std::reverse(phi.begin(), phi.end());
  std::fill(jumped.begin(), jumped.end(), 0);
  jumped[p.size() - 8] = 1;
  const auto down = fit_onset(phi, p, jumped, 1.01e-3);
  ASSERT_TRUE(down);
  EXPECT_NEAR(down->slope, 0.283, 1e-9);
  // Two points below a jump make no line: then the part above.
  std::fill(jumped.begin(), jumped.end(), 0);
  jumped[p.size() - 2] = jumped[p.size() - 8] = 1;
  EXPECT_EQ(fit_onset(phi, p, jumped, 1.01e-3)->points, 6);
}

}  // namespace
}  // namespace supple
