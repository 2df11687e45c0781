#include "supple/draw/chart/chart.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "supple/core/error.hpp"
#include "tests/io/count_of.hpp"
#include "tests/io/temporary_folder.hpp"

namespace supple {
namespace {

using testing::content_of;
using testing::count_of;

class ChartTest : public testing::TemporaryFolder {};

TEST(Thin, KeepsEveryPeakOfALongSeries) {
  std::vector<Vec2> curve;
  for (int i = 0; i < 100000; ++i) curve.push_back({i * 1e-3, std::sin(1e-4 * i)});
  curve[40000][1] = 7;
  curve[70001][1] = -5;
  const std::vector<Vec2> few = thin(curve, 0.25);
  EXPECT_LT(few.size(), 4000u);
  EXPECT_EQ(few.front(), curve.front());
  EXPECT_EQ(few.back(), curve.back());
  EXPECT_NE(std::find(few.begin(), few.end(), curve[40000]), few.end());
  EXPECT_NE(std::find(few.begin(), few.end(), curve[70001]), few.end());
}

TEST(Thin, LeavesALevelStretchLevelUpToAStep) {
  std::vector<Vec2> curve;
  for (int i = 0; i < 100; ++i) curve.push_back({i * 1.0, i < 60 ? 0.0 : 10.0});
  EXPECT_EQ(thin(curve, 0.25), (std::vector<Vec2>{{0, 0}, {59, 0}, {60, 10}, {99, 10}}));
}

TEST(Thin, FollowsALoopWithinTheResolution) {
  std::vector<Vec2> loop;
  for (int i = 0; i <= 20000; ++i) loop.push_back({100 * std::cos(i * 1e-3), 80 * std::sin(i * 1e-3)});
  const std::vector<Vec2> few = thin(loop, 0.25);
  EXPECT_LT(few.size(), loop.size() / 2);
  std::size_t next = 0;  // every point of the loop is near the stretch that replaces it
  for (const Vec2& x : loop) {
    while (next + 1 < few.size() && norm(few[next + 1] - x) < norm(few[next] - x)) ++next;
    EXPECT_LT(norm(few[next] - x), 5);
  }
}

TEST(Thin, KeepsGaps) {
  const std::vector<Vec2> few = thin(std::vector<Vec2>{{0, 0}, {1, NAN}, {2, 0}}, 10);
  ASSERT_EQ(few.size(), 3u);
  EXPECT_TRUE(std::isnan(few[1][1]));
}

Chart sample() {
  ChartSeries line{"line", {0, 1, 2, 3}, {0, 1, 4, 9}, {}, hex(0x112233)};
  ChartSeries points{
      "points", {0, 1, 2, 3}, {0, 1, NAN, 9}, {0.5, 0.5, 0.5, 0.5}, hex(0x445566), Marks::points, 2};
  ChartPanel panel{{"Time", "s"}, {"Stress", "Pa"}, {line, points}, {{0, 1, "rest", pale_gray}}, {"heading"}};
  return {{{{panel, panel}, 1}, {{panel}, 2}}};
}

TEST_F(ChartTest, DrawsEachSeriesInEachPanelAndInItsLegend) {
  draw_chart(in_folder("a.svg"), sample());
  const std::string svg = content_of(in_folder("a.svg"));
  EXPECT_EQ(count_of(svg, "stroke:rgb(6.666667%,13.333333%,20%)"), 3 * 2);
  EXPECT_EQ(count_of(svg, "fill:rgb(26.666667%,33.333333%,40%)"), 3 * (3 + 1));  // a value is missing
  EXPECT_EQ(count_of(svg, "stroke:rgb(26.666667%,33.333333%,40%)"),
            3 * 3 * 3);  // error bars: stem and two ends
}

/// Where the last glyph of the page begins [pt], and how wide the page is.
std::pair<double, double> reach_and_width(const std::string& svg) {
  double reach = 0;
  const auto number_after = [&](std::size_t at, const std::string& key) {
    return std::stod(svg.substr(svg.find(key, at) + key.size(), 20));
  };
  for (std::size_t at = svg.find("<use "); at != std::string::npos; at = svg.find("<use ", at + 1))
    reach = std::max(reach, number_after(at, " x=\""));
  return {reach, number_after(svg.find("<svg"), " width=\"")};
}

TEST_F(ChartTest, WritesALongLabelSmallerThanCutOff) {
  Chart chart = sample();
  chart.columns.back().panels.front().series.front().label = std::string(120, 'W');
  draw_chart(in_folder("a.svg"), chart);
  const auto [reach, width] = reach_and_width(content_of(in_folder("a.svg")));
  EXPECT_GT(reach, 0.5 * width);
  EXPECT_LT(reach, width);
}

TEST_F(ChartTest, WritesEveryFormatAndRefusesOthers) {
  for (const char* name : {"a.png", "a.jpg", "a.svg", "a.pdf", "a.ps"}) {
    draw_chart(in_folder(name), sample());
    EXPECT_GT(content_of(in_folder(name)).size(), 1000u) << name;
  }
  EXPECT_THROW(draw_chart(in_folder("a.bmp"), sample()), Error);
  EXPECT_THROW(draw_chart(in_folder("missing/a.png"), sample()), Error);
}

TEST_F(ChartTest, DrawsConstantEmptyAndMissingData) {
  for (const std::vector<double>& y : {std::vector<double>{}, {5, 5}, {0, 0}, {NAN, NAN}}) {
    const ChartPanel panel{{"x", ""}, {"y", "Pa"}, {{"", {0, 1}, y}}};
    EXPECT_NO_THROW(draw_chart(in_folder("a.svg"), {{{{panel}, 1}}}));
  }
  EXPECT_THROW(draw_chart(in_folder("a.svg"), {{ChartColumn{}}}), Error);
}

}  // namespace
}  // namespace supple
