#include "supple/draw/canvas/color_scale.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>

#include "tests/io/temporary_folder.hpp"

namespace supple {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(ColorScale, GoesOverTheFiniteValues) {
  const ColorScale scale = scale_over(std::vector<double>{3, nan, -1, INFINITY, 2});
  EXPECT_EQ(scale.low, -1);
  EXPECT_EQ(scale.high, 3);
  EXPECT_EQ(scale.color(-1), sequential_color(0));
  EXPECT_EQ(scale.color(1), sequential_color(0.5));
  EXPECT_EQ(scale.color(7), sequential_color(1));
  EXPECT_EQ(scale.color(nan), pale_gray);
}

TEST(ColorScale, HasAWidthWhereAllValuesAreTheSame) {
  for (const double value : {0.0, 5.0, -1e-9}) {
    const ColorScale scale = scale_over(std::vector<double>{value, value});
    EXPECT_LT(scale.low, value);
    EXPECT_GT(scale.high, value);
  }
  EXPECT_LT(scale_over({}).low, scale_over({}).high);
}

TEST(ColorScale, DarkensSteadily) {
  const auto luminance = [](Color c) { return 0.2126 * c.red + 0.7152 * c.green + 0.0722 * c.blue; };
  for (int k = 0; k < 100; ++k)
    EXPECT_GT(luminance(sequential_color(k / 100.0)), luminance(sequential_color((k + 1) / 100.0))) << k;
}

class ColorBar : public testing::TemporaryFolder {};

TEST_F(ColorBar, HasItsLargestNumberOnTop) {
  Canvas canvas(in_folder("a.svg"), 100, 200);
  EXPECT_GT(draw_color_bar(canvas, {10, 20}, 100, {0, 3e-8}, "pressure", ""), 120);
  canvas.finish();
  const std::string svg = testing::content_of(in_folder("a.svg"));
  const auto height_of = [&](double share) {
    const Color c = sequential_color(share);
    const std::size_t at =
        svg.find(fmt::format("fill:rgb({:.8g}%,{:.8g}%,{:.8g}%)", 100 * c.red, 100 * c.green, 100 * c.blue));
    double x = NAN, y = NAN;
    if (at != std::string::npos) std::sscanf(svg.c_str() + svg.find("d=\"M", at), "d=\"M %lf %lf", &x, &y);
    return y;
  };
  EXPECT_LT(height_of(1 - 0.5 / 128), height_of(0.5 / 128) - 90);
}

}  // namespace
}  // namespace supple
