#include "supple/draw/canvas/ticks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace supple {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::Pointwise;

TEST(Ticks, AreRoundNumbersWithinTheRange) {
  EXPECT_THAT(nice_ticks(-0.21, 0.21, 4).at, Pointwise(DoubleNear(1e-12), {-0.2, -0.1, 0.0, 0.1, 0.2}));
  EXPECT_THAT(nice_ticks(0, 97, 5).at, ElementsAre(0, 20, 40, 60, 80));
  EXPECT_THAT(nice_ticks(3, 9.6, 3).at, ElementsAre(4, 6, 8));
  EXPECT_THAT(nice_ticks(0, 10, 4).at, ElementsAre(0, 2.5, 5, 7.5, 10));
}

TEST(Ticks, KeepAnEndThatIsATickUpToRounding) {
  EXPECT_EQ(nice_ticks(0.1 + 0.2 - 0.6, 0.3, 6).at.size(), 7u);  // -0.3 ... 0.3
}

TEST(Ticks, ComeOnceForARangeWithoutWidthOrThatIsNotFinite) {
  EXPECT_EQ(nice_ticks(2, 2, 5).at.size(), 1u);
  EXPECT_EQ(nice_ticks(0, INFINITY, 5).at.size(), 1u);
}

TEST(Ticks, AreLabelledWithTheDecimalsOfTheirStep) {
  EXPECT_EQ(tick_label(0.5, 0.25), "0.50");
  EXPECT_EQ(tick_label(-20, 10), "\u221220");
  EXPECT_EQ(tick_label(-1e-17, 0.1), "0.0");
  EXPECT_EQ(tick_label(3e7, 1e7), "3e+07");
  EXPECT_EQ(tick_label(1.040002, 2e-6), "1.040002");
}

TEST(RoundBelow, IsOneTwoOrFiveTimesAPowerOfTen) {
  EXPECT_DOUBLE_EQ(round_below(125e-6), 100e-6);
  EXPECT_DOUBLE_EQ(round_below(4.99), 2);
  EXPECT_DOUBLE_EQ(round_below(5), 5);
  EXPECT_DOUBLE_EQ(round_below(1000), 1000);
}

TEST(Prefix, BringsTheLargestBetweenOneAndAThousand) {
  EXPECT_EQ(si_prefix(1170).symbol, "k");
  EXPECT_EQ(si_prefix(999).symbol, "");
  EXPECT_EQ(si_prefix(1e-3).symbol, "m");
  EXPECT_EQ(si_prefix(2.3e-5).symbol, "\u00b5");
  EXPECT_EQ(si_prefix(0).factor, 1);
}

TEST(WithUnit, HasThreeDigitsAndCarriesOver) {
  EXPECT_EQ(with_unit(1.2e-3, "s"), "1.20\u00a0ms");
  EXPECT_EQ(with_unit(999.6, "Pa"), "1.00\u00a0kPa");
  EXPECT_EQ(with_unit(-0.0123, "Pa"), "\u221212.3\u00a0mPa");
  EXPECT_EQ(with_unit(0, "s"), "0\u00a0s");
  EXPECT_EQ(with_unit(50e-6, "m", Digits::fewest), "50\u00a0\u00b5m");
}

}  // namespace
}  // namespace supple
