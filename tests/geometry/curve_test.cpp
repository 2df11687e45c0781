#include "supple/geometry/curve.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "supple/geometry/inside.hpp"
#include "supple/geometry/polygon.hpp"

namespace supple {
namespace {

using std::numbers::pi;

/// Crossings of `a` with `b`, each of which must be a point of both (of the circle of an arc `b`).
std::vector<double> crossings(const Curve& a, const Curve& b) {
  std::vector<double> t;
  append_crossings(a, b, t);
  for (const double u : t) {
    const Vec2 x = a.at(u);
    const double off =
        b.straight() ? distance_to_segment(x, b.from, b.from + b.along) : norm(x - b.centre) - b.radius;
    EXPECT_NEAR(off, 0, 1e-12);
  }
  return t;
}

TEST(Curve, CrossingsOfEveryKind) {
  const Curve across = Curve::segment({-2, 0.5}, {2, 0.5}), up = Curve::segment({0.5, -1}, {0.5, 3});
  const Curve circle = Curve::circle({}, 1), arc = Curve::arc({}, 1, 0, pi / 2),
              other = Curve::circle({1, 0.2}, 0.7);
  ASSERT_EQ(crossings(across, up).size(), 1u);
  EXPECT_NEAR(crossings(across, up)[0], 0.625, 1e-15);
  EXPECT_EQ(crossings(across, circle).size(), 2u);
  EXPECT_EQ(crossings(circle, across).size(), 2u);
  EXPECT_EQ(crossings(circle, other).size(), 2u);
  ASSERT_EQ(crossings(arc, up).size(), 1u);
  EXPECT_NEAR(crossings(arc, up)[0], 2.0 / 3, 1e-15);  // at 60 degrees
  EXPECT_EQ(crossings(across, Curve::segment({0.5, 0.6}, {0.5, 3})).size(), 0u);
  EXPECT_EQ(crossings(circle, Curve::circle({}, 0.5)).size(), 0u);
  EXPECT_EQ(crossings(circle, Curve::circle({3, 0}, 0.5)).size(), 0u);
}

TEST(Curve, MissesNoTouch) {
  const Curve circle = Curve::circle({}, 1);
  EXPECT_FALSE(crossings(circle, Curve::segment({-1, 1}, {1, 1})).empty());
  EXPECT_FALSE(crossings(Curve::segment({-1, 1}, {1, 1}), circle).empty());
  EXPECT_FALSE(crossings(circle, Curve::circle({0.3 + 0.1 + 1.6, 0}, 1)).empty());
  EXPECT_FALSE(crossings(Curve::segment({0, 0}, {1, 0}), Curve::segment({1, 0}, {1, 1})).empty());
  // On one line: where the other begins and ends.
  EXPECT_EQ(crossings(Curve::segment({0, 0}, {4, 0}), Curve::segment({3, 0}, {1, 0})),
            (std::vector{0.75, 0.25}));
}

TEST(Curve, SweptAreaOfAClosedOutlineDoesNotDependOnTheOrigin) {
  // Half a disc on a square.
  const std::vector<Curve> outline = {Curve::segment({0, 0}, {2, 0}), Curve::segment({2, 0}, {2, 2}),
                                      Curve::arc({1, 2}, 1, 0, pi), Curve::segment({0, 2}, {0, 0})};
  for (const Vec2 origin : {Vec2{}, Vec2{5, -3}}) {
    double area = 0;
    for (const Curve& c : outline) area += c.swept_area(origin, 0, 0.3) + c.swept_area(origin, 0.3, 1);
    EXPECT_NEAR(area, 4 + pi / 2, 1e-13);
  }
}

TEST(Polygon, AreaAndInside) {
  const std::vector<Vec2> arrow = {{0, 0}, {4, 0}, {4, 4}, {3, 1}};
  EXPECT_DOUBLE_EQ(polygon_area(arrow), 4);
  EXPECT_TRUE(is_inside({3.5, 1}, arrow));
  EXPECT_FALSE(is_inside({2, 1}, arrow));  // in the notch
  EXPECT_FALSE(is_inside({5, 1}, arrow));
  EXPECT_FALSE(is_inside({-1, 0}, arrow));
  EXPECT_DOUBLE_EQ(distance_to_segment({3, 4}, {0, 0}, {6, 0}), 4);
  EXPECT_DOUBLE_EQ(distance_to_segment({9, 4}, {0, 0}, {6, 0}), 5);
  EXPECT_DOUBLE_EQ(distance_to_segment({3, 4}, {0, 0}, {0, 0}), 5);
}

}  // namespace
}  // namespace supple
