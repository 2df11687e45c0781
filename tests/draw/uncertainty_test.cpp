#include "supple/draw/chart/uncertainty.hpp"

#include <gtest/gtest.h>

namespace supple {
namespace {

TEST(Uncertainty, DecimalsFitTheError) {
  EXPECT_EQ(value_with_error(956.5432, 3.66), "956.5 ± 3.7");
  EXPECT_EQ(value_with_error(956.5432, 37.2), "957 ± 37");
  EXPECT_EQ(value_with_error(135.4, 193), "140 ± 190");
  EXPECT_EQ(value_with_error(-2137.21, 0.0123), "-2137.210 ± 0.012");
  EXPECT_EQ(value_with_error(565, 9.96), "565 ± 10");
}

TEST(Uncertainty, AnErrorIsNeverRoundedToNothing) {
  EXPECT_EQ(value_with_error(31.2, 0.0004), "31.20000 ± 0.00040");
  EXPECT_EQ(value_with_error(1e-7, 1.23e-9), "1.000e-07 ± 1.2e-09");
}

TEST(Uncertainty, WithoutAnErrorFiveDigits) {
  EXPECT_EQ(value_with_error(956.5432, -1), "956.54");
  EXPECT_EQ(value_with_error(0.5, 0), "0.5 ± 0");
}

}  // namespace
}  // namespace supple
