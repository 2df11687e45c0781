#include "supple/geometry/turning_angle.hpp"

#include <gtest/gtest.h>

namespace supple {
namespace {

double worst_error(double from, double to) {
  double worst = 0;
  for (int k = 0; k <= 20000; ++k) {
    const double angle = from + (to - from) * k / 20000, sine = 0.91 * std::sin(angle),
                 cosine = 0.91 * std::cos(angle);
    const double product = std::sqrt(sine * sine + cosine * cosine);
    worst = std::max(worst, std::abs(turning_angle(sine, cosine, product) - std::atan2(sine, cosine)));
    worst = std::max(worst, std::abs(turning_angle(-sine, cosine, product) + std::atan2(sine, cosine)));
  }
  return worst;
}

TEST(TurningAngle, IsWithinItsStatedErrorOfLibm) {
  EXPECT_LT(worst_error(0, 1.6), 5e-16);
  EXPECT_LT(worst_error(1.6, 3.1), 5e-15);
}

TEST(TurningAngle, IsWithinItsStatedErrorWhereItIsBlunt) {
  double worst = 0;
  for (int k = -20000; k <= 20000; ++k) {
    const double angle = std::acos(least_blunt_cosine) * k / 20000, sine = std::sin(angle),
                 cosine = std::cos(angle);
    worst = std::max(worst, std::abs(blunt_turning_angle(sine, cosine) - std::atan2(sine, cosine)));
  }
  EXPECT_LT(worst, 5e-16);
}

}  // namespace
}  // namespace supple
