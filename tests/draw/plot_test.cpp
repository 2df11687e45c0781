#include "supple/draw/chart/plot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "supple/core/error.hpp"
#include "tests/io/count_of.hpp"
#include "tests/io/temporary_folder.hpp"

namespace supple {
namespace {

using testing::content_of;
using testing::count_of;

/// A viscoelastic answer of G' = 500 Pa, G'' = 200 Pa on an offset of 1000 Pa that drifts.
OscillatoryPlot sample(int steps_per_period) {
  StressEstimate virial{"virial", {}, 500, 200, -1, -1, 1020, 10 * 1000};
  OscillatoryPlot plot;
  plot.protocol = {1000, 0.2, 2, 3, 1};
  for (int i = 0; i <= 6 * steps_per_period; ++i) {
    const double periods = static_cast<double>(i) / steps_per_period,
                 phase = 2 * std::numbers::pi * (periods - 2);
    const bool shear = periods >= 2 && periods <= 5;
    plot.time.push_back(periods / 1000);
    plot.strain.push_back(shear ? 0.2 * std::sin(phase) : 0);
    virial.stress.push_back((shear ? 100 * std::sin(phase) + 40 * std::cos(phase) : 0) + 1000 + 10 * periods);
  }
  plot.stresses = {virial, virial};
  plot.stresses.front().name = "plates";
  return plot;
}

constexpr const char* first_cycle = "stroke:rgb(65.882353%,79.607843%,90.980392%)";
constexpr const char* last_cycle = "stroke:rgb(10.588235%,30.980392%,50.980392%)";

class PlotOscillatoryTest : public testing::TemporaryFolder {};
class PlotDynamicsTest : public testing::TemporaryFolder {};

TEST_F(PlotOscillatoryTest, DrawsEachCycleOnceAndInTheLegend) {
  plot_oscillatory(in_folder("a.svg"), sample(200));
  const std::string svg = content_of(in_folder("a.svg"));
  EXPECT_EQ(count_of(svg, first_cycle), 2);
  EXPECT_EQ(count_of(svg, last_cycle), 2);
  EXPECT_EQ(count_of(svg, "stroke-dasharray:4,2"), 2);  // the ellipse of the second stress
}

/// Coordinates of the longest path of this colour.
std::vector<double> path_numbers(const std::string& svg, const std::string& color) {
  std::vector<double> longest;
  for (std::size_t at = svg.find(color); at != std::string::npos; at = svg.find(color, at + 1)) {
    std::size_t from = svg.find(" d=\"", at) + 4, to = svg.find('"', from);
    std::vector<double> numbers;
    for (const char *c = svg.c_str() + from, *end = svg.c_str() + to; c < end;) {
      char* after = nullptr;
      const double number = std::strtod(c, &after);
      if (after == c) ++c;
      else numbers.push_back(number), c = after;
    }
    if (numbers.size() > longest.size()) longest = numbers;
  }
  return longest;
}

TEST_F(PlotOscillatoryTest, LoopWithoutOffsetAndDriftLiesOnItsEllipse) {
  plot_oscillatory(in_folder("a.svg"), sample(400));
  const std::string svg = content_of(in_folder("a.svg"));
  const auto loop = path_numbers(svg, last_cycle), ellipse = path_numbers(svg, "stroke:rgb(0%,0%,0%)");
  ASSERT_GT(loop.size(), 100u);
  ASSERT_GT(ellipse.size(), 100u);
  for (std::size_t i = 0; i + 1 < loop.size(); i += 2) {
    double nearest = 1e9;
    for (std::size_t k = 0; k + 1 < ellipse.size(); k += 2)
      nearest = std::min(nearest, std::hypot(loop[i] - ellipse[k], loop[i + 1] - ellipse[k + 1]));
    EXPECT_LT(nearest, 3);  // [pt]; the offset alone would be more than ten panels away
  }
}

TEST_F(PlotOscillatoryTest, WritesEveryFormat) {
  for (const char* name : {"a.png", "a.jpg", "a.svg", "a.pdf", "a.ps"}) {
    plot_oscillatory(in_folder(name), sample(50));
    EXPECT_GT(content_of(in_folder(name)).size(), 1000u) << name;
  }
}

TEST(PlotOscillatory, RefusesSeriesThatDoNotBelongTogether) {
  OscillatoryPlot plot = sample(50);
  plot.stresses.back().stress.pop_back();
  try {
    plot_oscillatory("a.png", plot);
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::input);
    EXPECT_THAT(e.what(), ::testing::HasSubstr("virial stress"));
  }
  EXPECT_THROW(plot_oscillatory("a.png", {}), Error);
}

TEST_F(PlotDynamicsTest, LeavesOutWhatIsNotThere) {
  DynamicsPlot plot{{0, 1, 2}, {0, 0, 0}, {{"virial", {1, 2, 3}}}, {}};
  plot_dynamics(in_folder("rest.svg"), plot);
  plot.strain = {0, 0.1, 0.2};
  plot_dynamics(in_folder("shear.svg"), plot);
  const char* first = "stroke:rgb(26.666667%,46.666667%,66.666667%)";
  EXPECT_EQ(count_of(content_of(in_folder("rest.svg")), first), 1 + 1);   // against time, legend
  EXPECT_EQ(count_of(content_of(in_folder("shear.svg")), first), 2 + 2);  // and against strain
}

}  // namespace
}  // namespace supple
