#include "supple/observe/plain_area.hpp"

#include <gtest/gtest.h>

#include "supple/geometry/polygon.hpp"
#include "supple/observe/packing_fraction.hpp"
#include "tests/support/shapes.hpp"

namespace supple {
namespace {

using std::numbers::pi;
using namespace testing;

/// By crossings of all parts of the outline.
double area_by_crossings(const Ring& ring, double radius, Outline outline) {
  System<2> system = empty_cell(40, 40);
  add_outline(system, ring, radius);
  return packing_fraction(system, outline).total * 1600;
}

/// A regular polygon whose vertices are pushed along their radii by up to `push` of an edge.
Ring buckled(int n, double push, std::uint64_t seed) {
  RandomStream draw(seed, Purpose::test);
  Ring ring = regular_polygon(n, 1, {}, draw.uniform(0, 7));
  for (Vec2& x : ring) x *= 1 + push * 2 * std::sin(pi / n) * draw.uniform(-1, 1);
  for (Vec2& x : ring) x += Vec2{20, 20};
  return ring;
}

TEST(PlainArea, IsThatByCrossingsForEveryRingThatItTakes) {
  int taken = 0, left = 0;
  for (const Outline outline : {Outline::rough, Outline::smooth})
    for (const int n : {3, 4, 5, 7, 12, 40, 200})
      for (const double push : {0.0, 0.1, 0.25, 0.6, 2.0})
        for (const double ratio : {0.2, 0.9, 1.0, 1.02, 1.5, 2.0, 3.0, 8.0})  // width over an edge
          for (std::uint64_t seed = 0; seed < (n < 100 ? 6 : 1); ++seed) {
            const Ring ring = buckled(n, n < 5 ? 0.3 * push : push, seed);
            const double radius = ratio * std::sin(pi / n);
            const auto area = plain_area(ring, radius, outline);
            (area ? taken : left) += 1;
            if (!area) continue;
            EXPECT_NEAR(*area, area_by_crossings(ring, radius, outline), 1e-11)
                << n << " vertices pushed by " << push << ", width " << ratio << ", seed " << seed
                << (outline == Outline::rough ? ", rough" : ", smooth");
          }
  EXPECT_GT(taken, 700);
  EXPECT_GT(left, 700) << "wide vertices meet more than neighbours";
}

/// What a case draws: vertices as wide as the edge that they would have, pushed by a quarter of an edge.
TEST(PlainArea, TakesEveryRingThatACaseDrawsUnlessItsVerticesAreMuchWiderThanEdges) {
  for (const Outline outline : {Outline::rough, Outline::smooth})
    for (const int n : {3, 4, 5, 6, 12, 60, 157, 158, 500})
      for (const double ratio : {0.1, 1.0, 1.02, n < 5 ? 1.1 : 1.3})
        EXPECT_TRUE(plain_area(buckled(n, std::min(0.25, 0.005 / std::sin(pi / n)), 3),
                               ratio * std::sin(pi / n), outline))
            << n << ' ' << ratio;
}

TEST(PlainArea, IsThatOfARegularPolygonInClosedForm) {
  for (const int n : {3, 6, 30}) {
    const Ring ring = regular_polygon(n, 2, {5, 5}, 0.4);
    const double edge = 4 * std::sin(pi / n), r = 0.5 * edge, a = polygon_area(ring);
    ASSERT_TRUE(plain_area(ring, r, Outline::smooth));
    EXPECT_NEAR(*plain_area(ring, r, Outline::smooth), a + n * edge * r + pi * r * r, 1e-12);
    ASSERT_TRUE(plain_area(ring, r, Outline::rough));
    EXPECT_NEAR(*plain_area(ring, r, Outline::rough), a + (0.5 * n + 1) * pi * r * r, 1e-12);
  }
}

TEST(PlainArea, LeavesRingsThatDoNotFollowTheirAngles) {
  Ring ring = regular_polygon(8, 1);
  std::swap(ring[2], ring[3]);  // crosses itself
  EXPECT_FALSE(plain_area(ring, 0.1, Outline::rough));
  Ring twice;
  for (int k = 0; k < 10; ++k) twice.push_back({std::cos(4 * pi * k / 10), std::sin(4 * pi * k / 10)});
  EXPECT_FALSE(plain_area(twice, 0.1, Outline::rough)) << "goes round twice";
  const Ring bar{{0, 0}, {9, 0}, {9, 1}, {1, 1}, {1, 9}, {0, 9}};  // its mean lies outside of it
  EXPECT_FALSE(plain_area(bar, 0.1, Outline::smooth));
  EXPECT_FALSE(plain_area(regular_polygon(2, 1), 0.1, Outline::rough));
}

}  // namespace
}  // namespace supple
