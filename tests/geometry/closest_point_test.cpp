#include "supple/geometry/closest_point.hpp"

#include <gtest/gtest.h>

#include <map>

#include "supple/core/random.hpp"

namespace supple {
namespace {

Vec3 draw_point(RandomStream& draw, double most) {
  return {draw.uniform(-most, most), draw.uniform(-most, most), draw.uniform(-most, most)};
}

/// The point with these weights, and the one that the answer means.
Vec3 point_of(const Vec3 (&x)[3], const double (&w)[3]) { return w[0] * x[0] + w[1] * x[1] + w[2] * x[2]; }

/// No other point of the triangle is nearer: for a convex set that is (x_k - nearest).(p - nearest) <= 0 for
/// every corner, and sufficient.
TEST(ClosestOnTriangle, IsTheNearestPointInEveryPart) {
  RandomStream draw(4, Purpose::test);
  std::map<TrianglePart, int> parts;
  for (int k = 0; k < 20000; ++k) {
    const Vec3 x[3] = {draw_point(draw, 1), draw_point(draw, 1), draw_point(draw, 1)};
    const Vec3 p = draw_point(draw, 2);
    const ClosestOnTriangle at = closest_on_triangle(p, x);
    ++parts[at.part];
    const Vec3 nearest = point_of(x, at.weight);
    ASSERT_LT(norm(p - nearest - at.from), 1e-12);
    ASSERT_NEAR(at.weight[0] + at.weight[1] + at.weight[2], 1, 1e-14);
    int used = 0;
    for (int c = 0; c < 3; ++c) {
      ASSERT_GE(at.weight[c], 0);
      used += at.weight[c] > 0;
      ASSERT_LT(dot(x[c] - nearest, at.from), 1e-12);
    }
    const int corners = at.part == TrianglePart::face ? 3 : at.part < TrianglePart::corner_0 ? 2 : 1;
    ASSERT_EQ(used, corners);
    for (int c = 0; c < 3; ++c) {
      ASSERT_EQ(at.part == edge_part(c), corners == 2 && at.weight[(c + 2) % 3] == 0);
      ASSERT_EQ(at.part == corner_part(c), at.weight[c] == 1);
    }
  }
  ASSERT_EQ(parts.size(), 7u);
  for (const auto& [part, times] : parts) EXPECT_GT(times, 300);
}

TEST(ClosestOnTriangle, IsNeverNearerThanTheBoxAboutTheTriangle) {
  RandomStream draw(6, Purpose::test);
  int far = 0, near = 0;
  for (int k = 0; k < 10000; ++k) {
    const Vec3 x[3] = {draw_point(draw, 1), draw_point(draw, 1), draw_point(draw, 1)};
    const Vec3 p = draw_point(draw, 2), from = closest_on_triangle(p, x).from;
    ASSERT_TRUE(may_be_nearer(p, x, 1.0001 * dot(from, from)));
    (may_be_nearer(p, x, 0.5 * dot(from, from)) ? near : far) += 1;
  }
  EXPECT_GT(far, 3000) << "it says nothing";
  EXPECT_GT(near, 1000);
}

TEST(ClosestOnTriangle, OverAnObtuseTriangle) {
  const Vec3 x[3] = {{0, 0, 0}, {10, 0, 0}, {1, 0.5, 0}};
  EXPECT_EQ(closest_on_triangle({0.5, 0.6, 0.3}, x).part, TrianglePart::edge_2);
  EXPECT_EQ(closest_on_triangle({1, 2, 0.3}, x).part, TrianglePart::corner_2);
  EXPECT_EQ(closest_on_triangle({5, 2, 0.3}, x).part, TrianglePart::edge_1);
  const ClosestOnTriangle over = closest_on_triangle({1, 0.25, -3}, x);
  EXPECT_EQ(over.part, TrianglePart::face);
  EXPECT_EQ(over.from[2], -3);
  EXPECT_EQ(over.normal[2], 5);
}

TEST(ClosestOnTriangle, AtItsCornersAndWhereItHasNoArea) {
  const Vec3 x[3] = {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}};
  for (int k = 0; k < 3; ++k) {
    const ClosestOnTriangle at = closest_on_triangle(x[k], x);
    EXPECT_EQ(at.part, corner_part(k));
    EXPECT_EQ(norm(at.from), 0);
  }
  const Vec3 line[3] = {{0, 0, 0}, {2, 0, 0}, {1, 0, 0}};
  const ClosestOnTriangle at = closest_on_triangle({0.5, 1, 0}, line);
  EXPECT_NEAR(norm(at.from), 1, 1e-15);
}

TEST(ClosestOnSegment, IsTheSameInThePlaneAndInSpace) {
  RandomStream draw(5, Purpose::test);
  int inner = 0;
  for (int k = 0; k < 1000; ++k) {
    Vec2 flat[3];
    Vec3 high[3];
    for (int c = 0; c < 3; ++c) {
      flat[c] = {draw.uniform(-1, 1), draw.uniform(-1, 1)};
      high[c] = {flat[c][0], flat[c][1], 0};
    }
    const auto in_plane = closest_on_segment(flat[0], flat[1], flat[2]);
    const auto in_space = closest_on_segment(high[0], high[1], high[2]);
    ASSERT_EQ(in_plane.along, in_space.along);
    ASSERT_EQ(norm(in_plane.from), norm(in_space.from));
    if (0 < in_space.along && in_space.along < 1) {
      ASSERT_NEAR(dot(in_space.from, high[2] - high[1]), 0, 1e-14);
      ++inner;
    }
    high[0][2] = 3;
    ASSERT_EQ(closest_on_segment(high[0], high[1], high[2]).from[2], 3);
  }
  EXPECT_GT(inner, 200);
}

}  // namespace
}  // namespace supple
