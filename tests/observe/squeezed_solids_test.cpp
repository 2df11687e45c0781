#include "supple/observe/squeezed_solids.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace supple {
namespace {

using std::numbers::pi;

/// The strain along the axis of a disc of radius 1 and plane modulus 1 under two opposite forces, from a
/// contact to the centre: Hertz's stresses below the contact, those of the opposite point force, and the
/// uniform tension P/(pi R) [Johnson (1985), eq. 4.46, 5.55], by the midpoint rule in z = a sinh t.
double half_compression(double load, double poisson_ratio) {
  const double a = std::sqrt(4 * load / pi), last = std::asinh(1 / a);
  constexpr int steps = 20000;
  double sum = 0;
  for (int k = 0; k < steps; ++k) {
    const double t = last * (k + 0.5) / steps, z = a * std::sinh(t), root = std::sqrt(a * a + z * z);
    const double along = -load / pi * (2 / root + 2 / (2 - z) - 1);
    const double aside = load / pi * (1 - 2 * (a * a + 2 * z * z) / (a * a * root) + 4 * z / (a * a));
    sum -= (along - poisson_ratio * aside) * a * std::cosh(t) * last / steps;
  }
  return sum;
}

TEST(CylinderCompression, IsTheStrainAlongTheAxis) {
  for (const double poisson_ratio : {0.0, 1.0 / 3})
    for (const double force : {1e-6, 1e-4, 1e-3}) {
      const double load = 2 * force;  // F = f E' D with E' = 1 and R = 1
      const double whole = 2 * half_compression(load, poisson_ratio) / 2;
      EXPECT_NEAR(cylinder_compression(force), whole, 2 * force * whole) << force;
    }
}

TEST(CylinderCompression, HasAnInverse) {
  for (const double force : {1e-8, 1e-3, 0.1, 0.8})
    EXPECT_NEAR(cylinder_force(cylinder_compression(force)), force, 1e-12 * force);
  EXPECT_EQ(cylinder_force(0), 0);
  EXPECT_EQ(cylinder_compression(0), 0);
  for (const double none : {-1.0, 1.0}) {
    EXPECT_TRUE(std::isnan(cylinder_compression(none)));
    EXPECT_TRUE(std::isnan(cylinder_force(none)));
  }
}

/// d ln F/d ln delta = (ln(2 pi/f) - 1)/(ln(2 pi/f) - 2): a little above 1, and more so the larger the force.
TEST(CylinderCompression, IsNearlyLinear) {
  const auto exponent = [](double x) {
    return std::log(cylinder_force(1.001 * x) / cylinder_force(x)) / std::log(1.001);
  };
  EXPECT_NEAR(exponent(1e-4), 1.09, 0.01);
  EXPECT_NEAR(exponent(1e-2), 1.17, 0.01);
  EXPECT_LT(exponent(1e-3), exponent(1e-2));
}

/// The printed formula bends less, and its cylinder yields 2 (1 + ln(pi/f))/(ln(2 pi/f) - 1) times as much.
TEST(PrintedCylinder, YieldsMoreThanTwiceAsMuch) {
  for (const double f : {1e-5, 1e-3})
    EXPECT_NEAR(printed_cylinder_compression(f) / cylinder_compression(f),
                2 * (1 + std::log(pi / f)) / (std::log(2 * pi / f) - 1), 1e-12);
  EXPECT_NEAR(printed_cylinder_compression(1e-3), 0.0115260, 1e-7);
}

/// Two contacts of Hertz, each F = (4/3) E* sqrt(R) d^1.5 with R = D/2 and d = delta/2.
TEST(BallForce, IsOfTwoContacts) {
  const double diameter = 3, modulus = 5, compression = 0.02;
  const double force =
      4.0 / 3 * modulus * std::sqrt(diameter / 2) * std::pow(compression * diameter / 2, 1.5);
  EXPECT_NEAR(ball_force(compression), force / (modulus * diameter * diameter), 1e-15);
}

}  // namespace
}  // namespace supple
