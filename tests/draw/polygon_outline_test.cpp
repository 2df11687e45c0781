#include "supple/draw/scene/polygon_outline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace supple {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double step = 1e-3;  // chords of arcs: lengths and areas within about step^2

using Pieces = std::vector<std::vector<Vec2>>;

double length(const Pieces& pieces) {
  double sum = 0;
  for (const auto& piece : pieces)
    for (std::size_t k = 0; k + 1 < piece.size(); ++k) sum += norm(piece[k + 1] - piece[k]);
  return sum;
}

/// By Green's theorem: every piece goes anticlockwise round the body.
double area(const Pieces& pieces) {
  double sum = 0;
  for (const auto& piece : pieces)
    for (std::size_t k = 0; k + 1 < piece.size(); ++k) sum += 0.5 * cross(piece[k], piece[k + 1]);
  return sum;
}

Pieces outline(const std::vector<Vec2>& ring, double radius) {
  return body_outline(ring, std::vector<double>(ring.size(), radius), step);
}

const std::vector<Vec2> square{{2, 1}, {3, 1}, {3, 2}, {2, 2}};

TEST(PolygonOutline, OfOneSiteIsItsCircle) {
  const Pieces circle = outline({{4, 5}}, 0.7);
  ASSERT_EQ(circle.size(), 1u);
  EXPECT_NEAR(length(circle), 2 * pi * 0.7, 1e-5);
  EXPECT_NEAR(area(circle), pi * 0.49, 1e-5);
}

TEST(PolygonOutline, OfSmallVerticesHasThreeQuartersOfEachCircleAndTheEdgesBetween) {
  const Pieces pieces = outline(square, 0.25);
  EXPECT_EQ(pieces.size(), 8u);
  EXPECT_NEAR(length(pieces), 4 * 0.5 + 4 * 1.5 * pi * 0.25, 1e-5);
  EXPECT_NEAR(area(pieces), 1 + 4 * 0.75 * pi * 0.0625, 1e-5);
}

TEST(PolygonOutline, OfOverlappingVerticesHasArcsAlone) {
  const double r = 0.6, half = std::acos(0.5 / r);
  const Pieces pieces = outline(square, r);
  EXPECT_EQ(pieces.size(), 4u);
  EXPECT_NEAR(length(pieces), 4 * r * (1.5 * pi - 2 * half), 1e-5);
  const double lens = 2 * r * r * half - 0.5 * std::sqrt(4 * r * r - 1);  // of neighbours, half of it outside
  EXPECT_NEAR(area(pieces), 1 + 3 * pi * r * r - 4 * lens / 2, 1e-5);
}

TEST(PolygonOutline, KeepsTheNotchOfAConcaveBody) {
  const std::vector<Vec2> dart{{0, 0}, {3, 1}, {0, 2}, {1, 1}};
  const double r = 0.1;
  // Inner angles of a quadrilateral sum to 2 pi, so its discs keep 3/4 of their area outside together.
  EXPECT_NEAR(area(outline(dart, r)), 2 + 3 * pi * r * r, 1e-5);
}

TEST(PolygonOutline, HidesAVertexWithinAnother) {
  const std::vector<Vec2> triangle{{0, 0}, {0.1, 0}, {0, 0.1}};
  const Pieces pieces = body_outline(triangle, std::vector<double>{1, 0.2, 0.2}, step);
  EXPECT_EQ(pieces.size(), 1u);
  EXPECT_NEAR(length(pieces), 2 * pi, 1e-5);
}

TEST(PolygonOutline, TakesNoLongerStepThanAsked) {
  for (const auto& piece : body_outline(square, std::vector<double>(4, 0.6), 0.05))
    for (std::size_t k = 0; k + 1 < piece.size(); ++k) EXPECT_LE(norm(piece[k + 1] - piece[k]), 0.05);
}

}  // namespace
}  // namespace supple
