#include "supple/draw/chart/chart_scale.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace supple {
namespace {

const ChartAxis decades{"P", "Pa", {}, Spacing::logarithmic};

std::vector<std::string> labels(const AxisScale& scale) {
  std::vector<std::string> out;
  for (const AxisTick& tick : scale.ticks)
    if (!tick.label.empty()) out.push_back(tick.label);
  return out;
}

AxisScale with_ticks(const ChartAxis& axis, double low, double high, int count) {
  AxisScale scale = scale_of_axis(axis, {low, high});
  scale.set_ticks(axis, count);
  return scale;
}

TEST(ChartScale, SpacesNumbersByTheirLogarithm) {
  const AxisScale scale = scale_of_axis(decades, {1e-6, 1e2});
  EXPECT_DOUBLE_EQ(scale.share(1e-6), 0);
  EXPECT_DOUBLE_EQ(scale.share(1e-2), 0.5);
  EXPECT_DOUBLE_EQ(scale.share(1e2), 1);
  EXPECT_FALSE(std::isfinite(scale.share(0)));
  EXPECT_FALSE(std::isfinite(scale.share(-1)));
}

TEST(ChartScale, WidensByAShareOfTheLength) {
  AxisScale linear = scale_of_axis({"x", ""}, {2, 4});
  linear.widen(0.5, 0.25);
  EXPECT_DOUBLE_EQ(linear.low, 1);
  EXPECT_DOUBLE_EQ(linear.high, 4.5);
  AxisScale logarithmic = scale_of_axis(decades, {1e-2, 1e2});
  logarithmic.widen(0.5, 0.25);
  EXPECT_NEAR(logarithmic.low, 1e-4, 1e-15);
  EXPECT_NEAR(logarithmic.high, 1e3, 1e-9);
}

TEST(ChartScale, LabelsPowersOfTenWithSmallTicksBetween) {
  const AxisScale scale = with_ticks(decades, 1e-6, 2e-3, 6);
  EXPECT_EQ(scale.title, "P (Pa)");  // without prefix: the powers say it
  const std::vector<std::string> powers{"10\u207b\u2076", "10\u207b\u2075", "10\u207b\u2074",
                                        "10\u207b\u00b3"};
  EXPECT_EQ(labels(scale), powers);
  EXPECT_EQ(scale.ticks.size(), 3 * 9 + 2u);
  EXPECT_EQ(labels(with_ticks(decades, 0.01, 100, 6)),
            (std::vector<std::string>{"0.01", "0.1", "1", "10", "100"}));
}

TEST(ChartScale, LabelsFewerPowersOfALongAxisAndMoreNumbersOfAShortOne) {
  EXPECT_EQ(labels(with_ticks(decades, 1e-12, 1, 4)).size(), 5u);
  EXPECT_EQ(labels(with_ticks(decades, 0.15, 0.9, 4)), (std::vector<std::string>{"0.2", "0.5"}));
  EXPECT_EQ(labels(with_ticks(decades, 0.15, 3, 4)), (std::vector<std::string>{"0.2", "0.5", "1", "2"}));
}

TEST(ChartScale, HasALengthWhateverTheValues) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const Spacing spacing : {Spacing::linear, Spacing::logarithmic})
    for (const auto& [low, high] : {std::pair(infinity, -infinity), {3.0, 3.0}, {0.0, 0.0}, {-2.0, -2.0}}) {
      const AxisScale scale = scale_of_axis({"x", "", {}, spacing}, {low, high});
      EXPECT_LT(scale.low, scale.high);
      EXPECT_TRUE(std::isfinite(scale.share(spacing == Spacing::linear ? 0 : 1)));
    }
}

TEST(ChartScale, TakesItsOwnRangeFirst) {
  const AxisScale scale = scale_of_axis({"x", "", std::pair(-1.0, 5.0)}, {0, 1});
  EXPECT_EQ(scale.low, -1);
  EXPECT_EQ(scale.high, 5);
}

}  // namespace
}  // namespace supple
