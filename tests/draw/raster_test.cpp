#include "supple/draw/canvas/raster.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace supple {
namespace {

constexpr std::uint32_t paper = 0xffffff;
const std::vector<double> solid = {};

/// A white page, and how much of each pixel black shapes took.
class RasterTest : public ::testing::Test {
 protected:
  static constexpr int width = 70, height = 50;
  std::vector<std::uint32_t> pixels = std::vector<std::uint32_t>(width * height, paper);
  Raster raster{pixels.data(), width, height, width};

  double share(int x, int y) const { return 1 - (pixels[y * width + x] & 0xff) / 255.0; }
  double area() const {
    double sum = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) sum += share(x, y);
    return sum;
  }
  void line(const std::vector<Vec2>& points, double w, const std::vector<double>& dash = solid) {
    raster.stroke(points, Raster::Ends::open, {w, dash}, black);
  }
};

std::vector<Vec2> circle(const Vec2& centre, double radius, int corners, double sense = 1) {
  std::vector<Vec2> ring;
  for (int k = 0; k < corners; ++k) {
    const double angle = sense * 2 * std::numbers::pi * k / corners;
    ring.push_back(centre + radius * Vec2{std::cos(angle), std::sin(angle)});
  }
  return ring;
}

constexpr double step = 0.5 / 255;  // of shares that are stored in a byte

TEST_F(RasterTest, APixelTakesTheShareThatIsCovered) {
  raster.fill(std::vector<Vec2>{{3.25, 4.5}, {6.75, 4.5}, {6.75, 7.25}, {3.25, 7.25}}, black);
  EXPECT_NEAR(share(3, 4), 0.75 * 0.5, step);
  EXPECT_NEAR(share(4, 4), 0.5, step);
  EXPECT_NEAR(share(6, 7), 0.75 * 0.25, step);
  EXPECT_EQ(share(5, 5), 1);
  EXPECT_EQ(share(2, 5), 0);
  EXPECT_EQ(share(7, 5), 0);
  EXPECT_EQ(share(5, 3), 0);
  EXPECT_EQ(share(5, 8), 0);
}

/// Triangle (10, 10), (14, 10), (10, 12): y < 12 - (x - 10)/2.
TEST_F(RasterTest, SharesOfASlantAreExact) {
  raster.fill(std::vector<Vec2>{{10, 10}, {14, 10}, {10, 12}}, black);
  EXPECT_EQ(share(10, 10), 1);
  EXPECT_EQ(share(11, 10), 1);
  EXPECT_NEAR(share(12, 10), 0.75, step);
  EXPECT_NEAR(share(13, 10), 0.25, step);
  EXPECT_NEAR(share(10, 11), 0.75, step);
  EXPECT_NEAR(share(11, 11), 0.25, step);
}

TEST_F(RasterTest, RingsTakeTheirAreaInBothSenses) {
  for (const double sense : {1, -1}) {
    std::ranges::fill(pixels, paper);
    raster.fill(circle({30.3, 25.7}, 17.2, 60, sense), black);
    const double exact = 0.5 * 60 * 17.2 * 17.2 * std::sin(2 * std::numbers::pi / 60);
    EXPECT_NEAR(area(), exact, 0.05);
  }
}

/// Two turns of a ring go around what one does.
TEST_F(RasterTest, WhatIsGoneAroundTwiceIsFilledOnce) {
  std::vector<Vec2> twice = circle({30, 25}, 10, 40);
  const std::vector<Vec2> once = twice;
  twice.insert(twice.end(), once.begin(), once.end());
  raster.fill(once, black);
  const double exact = area();
  std::ranges::fill(pixels, paper);
  raster.fill(twice, black);
  EXPECT_EQ(share(30, 25), 1);
  EXPECT_GE(area(), exact);
  EXPECT_LT(area(), exact + 2 * std::numbers::pi * 10 * 0.5);  // the pixels of its edge count twice
}

TEST_F(RasterTest, ShapesReachOverThePage) {
  raster.fill(std::vector<Vec2>{{-1e6, -1e6}, {1e6, -1e6}, {1e6, 1e6}, {-1e6, 1e6}}, black);
  EXPECT_EQ(area(), width * height);
  std::ranges::fill(pixels, paper);
  raster.fill(std::vector<Vec2>{{-100, 10}, {35, 10}, {35, 20}, {-100, 20}}, black);
  EXPECT_NEAR(area(), 350, 0.1);
  std::ranges::fill(pixels, paper);
  line({{-1e7, 25}, {1e7, 25}}, 2);
  EXPECT_NEAR(area(), 2 * width, 0.5);
  raster.fill(std::vector<Vec2>{{200, 10}, {210, 10}, {210, 20}}, black);
  EXPECT_NEAR(area(), 2 * width, 0.5);
}

TEST_F(RasterTest, LinesTakeTheirAreaAtEveryAngle) {
  for (const double w : {0.3, 0.8, 1.0, 2.5, 7.0})
    for (double angle = 0; angle < 3.1; angle += 0.37) {
      std::ranges::fill(pixels, paper);
      const Vec2 half = 15 * Vec2{std::cos(angle), std::sin(angle)};
      line({Vec2{35.2, 24.6} - half, Vec2{35.2, 24.6} + half}, w);
      // the half discs at both ends are thicker by the softening of their edge
      EXPECT_NEAR(area(), 30 * w + std::numbers::pi / 4 * w * w, 0.04 * 30 * w + 0.4) << w << " at " << angle;
    }
}

/// Lines of many short pieces are no darker than one of a single piece.
TEST_F(RasterTest, JointsDoNotShow) {
  line({{10, 10}, {60, 33}}, 1.2);
  const std::vector<std::uint32_t> whole = pixels;
  std::ranges::fill(pixels, paper);
  std::vector<Vec2> pieces;
  for (int k = 0; k <= 400; ++k) pieces.push_back(Vec2{10, 10} + k / 400.0 * Vec2{50, 23});
  line(pieces, 1.2);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      ASSERT_NEAR(pixels[y * width + x] & 0xff, whole[y * width + x] & 0xff, 2) << x << ", " << y;
}

TEST_F(RasterTest, AJoinedLineHasNoEnds) {
  raster.stroke(std::vector<Vec2>{{10, 10}, {30, 10}, {30, 30}, {10, 30}}, Raster::Ends::joined, {2, {}},
                black);
  EXPECT_EQ(share(10, 20), 1);
  EXPECT_EQ(share(20, 20), 0);
  EXPECT_NEAR(area(), 80 * 2, 1.5);
}

TEST_F(RasterTest, APointIsADot) {
  line({{20, 20}}, 6);
  EXPECT_NEAR(area(), std::numbers::pi * 9, 0.6);
}

/// Dashes of 5 and gaps of 3 along 40: five dashes with flat ends, around the corner as well.
TEST_F(RasterTest, DashesAndGapsGoOnAroundCorners) {
  line({{10, 10.5}, {50, 10.5}}, 1, {5, 3});
  EXPECT_NEAR(area(), 25, 0.1);
  for (const int x : {10, 14, 18, 22}) EXPECT_NEAR(share(x, 10), 1, step) << x;
  for (const int x : {15, 17, 23, 25}) EXPECT_NEAR(share(x, 10), 0, step) << x;
  std::ranges::fill(pixels, paper);
  line({{10, 10.5}, {21.5, 10.5}, {21.5, 39}}, 1, {5, 3});  // the second dash is half around the corner
  EXPECT_NEAR(share(21, 11), 1, 0.1);
  EXPECT_NEAR(share(21, 13), 0, 0.1);
  EXPECT_NEAR(area(), 25, 0.5);
}

TEST_F(RasterTest, ADashEndsFlatBehindACorner) {
  line({{10, 20}, {29.5, 20}, {60, 20.01}}, 8, {20, 100});
  EXPECT_NEAR(area(), 160, 0.5);
  EXPECT_EQ(share(31, 20), 0);
  std::ranges::fill(pixels, paper);
  line({{10, 20}, {30.5, 20}, {60, 20.01}}, 8, {20, 0.2, 20, 100});
  EXPECT_NEAR(area(), 320, 2);
  EXPECT_EQ(share(52, 20), 0);
}

TEST_F(RasterTest, ALongDashedLineFromAfarEndsAndKeepsItsPhase) {
  line({{-8e8, 10.5}, {8e8, 10.5}}, 1, {5, 3});
  EXPECT_NEAR(share(0, 10), 1, 0.01);
  EXPECT_NEAR(share(6, 10), 0, 0.01);
  EXPECT_NEAR(share(8, 10), 1, 0.01);
}

TEST_F(RasterTest, NothingIsDrawnOfWhatIsNotFinite) {
  const double none = std::nan("");
  raster.fill(std::vector<Vec2>{{none, 1}, {10, 1}, {10, 10}}, black);
  line({{1, 1}, {INFINITY, 10}}, 2);
  line({}, 2);
  line({{1, 1}, {10, 10}}, 0);
  EXPECT_EQ(area(), 0);
}

TEST_F(RasterTest, ClipsAddUpAndEnd) {
  const std::vector<Vec2> page{{0, 0}, {70, 0}, {70, 50}, {0, 50}};
  const std::vector<Vec2> left{{0, 0}, {20.5, 0}, {20.5, 50}, {0, 50}},
      hole = {{5, 5}, {15, 5}, {15, 15}, {5, 15}};
  raster.clip(left, Raster::Side::inside);
  raster.clip(hole, Raster::Side::outside);
  raster.fill(page, black);
  EXPECT_NEAR(area(), 20.5 * 50 - 100, 0.2);
  EXPECT_EQ(share(10, 10), 0);
  EXPECT_NEAR(share(20, 10), 0.5, 2 * step);
  raster.unclip();
  raster.fill(page, black);
  EXPECT_NEAR(share(10, 10), 1, step);
  EXPECT_EQ(share(30, 10), 0);
  raster.unclip();
  raster.fill(page, black);
  EXPECT_EQ(area(), width * height);
}

TEST_F(RasterTest, NothingShowsInAClipOfNothing) {
  raster.clip({}, Raster::Side::inside);
  raster.fill(circle({30, 25}, 10, 20), black);
  line({{0, 0}, {70, 50}}, 5);
  EXPECT_EQ(area(), 0);
}

TEST_F(RasterTest, ColoursAreMixedByTheirShares) {
  raster.fill(std::vector<Vec2>{{1, 1}, {2.5, 1}, {2.5, 2}, {1, 2}}, hex(0x204060));
  EXPECT_EQ(pixels[width + 1], 0x204060u);
  EXPECT_EQ(pixels[width + 2], 0x8f9fafu);  // 128/255 of the colour, 127/255 of white
}

}  // namespace
}  // namespace supple
