#include "supple/draw/chart/pressure_plot.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "supple/core/error.hpp"
#include "supple/core/vec.hpp"
#include "tests/io/count_of.hpp"
#include "tests/io/temporary_folder.hpp"

namespace supple {
namespace {

using testing::content_of;
using testing::count_of;

constexpr const char* first_color = "26.666667%,46.666667%,66.666667%";
constexpr const char* second_color = "93.333333%,40%,46.666667%";

/// P = 0.3 (phi - 0.8), and nothing below.
PressureSeries linear_law() {
  return {"discs", {0.79, 0.8001, 0.801, 0.81, 0.9}, {0, 3e-5, 3e-4, 3e-3, 3e-2}, PressureFit{0.8, 0.3}};
}

class PressurePlot : public testing::TemporaryFolder {
 protected:
  std::string svg(const std::vector<PressureSeries>& series, PressureAxes axes = PressureAxes::linear) {
    draw_pressure_plot(in_folder("a.svg"), series, {axes});
    return content_of(in_folder("a.svg"));
  }
  /// Where the shapes with this colour begin, without the first, which stands in the legend.
  static std::vector<Vec2> points(const std::string& svg, const std::string& color) {
    std::vector<Vec2> found;
    for (std::size_t at = 0; (at = svg.find("fill:rgb(" + color, at + 1)) != std::string::npos;) {
      Vec2 x{};
      std::sscanf(svg.c_str() + svg.find("d=\"M", at), "d=\"M %lf %lf", &x[0], &x[1]);
      found.push_back(x);
    }
    if (!found.empty()) found.erase(found.begin());
    return found;
  }
};

TEST_F(PressurePlot, PutsPointsWhereTheyBelong) {
  const std::vector<Vec2> at = points(svg({linear_law()}), first_color);
  ASSERT_EQ(at.size(), 5u);
  const Vec2 whole = at[4] - at[3];
  EXPECT_NEAR((at[3][0] - at[0][0]) / whole[0], 0.02 / 0.09, 1e-3);
  EXPECT_NEAR((at[3][1] - at[0][1]) / whole[1], 3e-3 / 27e-3, 1e-3);
}

TEST_F(PressurePlot, MakesALinearLawStraightOverDecades) {
  const std::vector<Vec2> at = points(svg({linear_law()}, PressureAxes::log_excess), first_color);
  ASSERT_EQ(at.size(), 4u);  // below the onset there is no logarithm
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(norm((at[k + 1] - at[k]) - (at[1] - at[0])), 0, 0.01) << k;  // a decade along both axes
    EXPECT_GT(at[k + 1][0], at[k][0] + 20);
  }
}

TEST_F(PressurePlot, LeavesOutWhatHasNoLogarithm) {
  const std::vector<Vec2> at = points(svg({linear_law()}, PressureAxes::log_pressure), first_color);
  ASSERT_EQ(at.size(), 4u);
  EXPECT_GT(at[0][1] - at[3][1], 100);  // the axis goes over the others
}

TEST_F(PressurePlot, DrawsTheFitOfEachSeriesThatHasOne) {
  PressureSeries plain = linear_law();
  plain.fit.reset();
  for (const PressureAxes axes : {PressureAxes::linear, PressureAxes::log_pressure}) {
    const std::string picture = svg({linear_law(), plain}, axes);
    EXPECT_EQ(count_of(picture, "stroke-dasharray"), 1);
    EXPECT_FALSE(points(picture, second_color).empty());
  }
}

TEST_F(PressurePlot, RefusesWhatItCannotDraw) {
  PressureSeries bad = linear_law();
  bad.pressure.pop_back();
  EXPECT_THROW(svg({bad}), Error);
  EXPECT_THROW(svg({}), Error);
  PressureSeries plain = linear_law();
  plain.fit.reset();
  EXPECT_THROW(svg({plain}, PressureAxes::log_excess), Error);
  EXPECT_EQ(files(), 0u);
}

TEST_F(PressurePlot, DrawsWhatIsNowhereAboveZero) {
  PressureSeries none{"none", {0.7, 0.8}, {0, 0}, PressureFit{0.9, 1}};
  for (const PressureAxes axes : {PressureAxes::linear, PressureAxes::log_pressure, PressureAxes::log_excess})
    EXPECT_NO_THROW(svg({none}, axes));
}

}  // namespace
}  // namespace supple
