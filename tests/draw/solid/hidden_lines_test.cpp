#include "supple/draw/solid/hidden_lines.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/draw/solid/scenes.hpp"

namespace supple {
namespace {

using namespace testing;
using ::testing::ElementsAre;
using ::testing::FieldsAre;
using Parts = std::vector<std::pair<double, double>>;

TEST(HiddenLines, ASphereHidesWhatIsBehindItAndInIt) {
  SolidScene scene = empty_cell();
  add_ball(scene, {5, 5, 5}, 1);
  const ViewAxes axes = axes_of(view_of("z"));
  const auto parts = [&](double z) { return visible_parts(scene, axes, {0, 5, z}, {10, 5, z}); };
  const auto around = ElementsAre(FieldsAre(0, ::testing::DoubleNear(0.4, 1e-12)),
                                  FieldsAre(::testing::DoubleNear(0.6, 1e-12), 1));
  EXPECT_THAT(parts(0), around);
  EXPECT_THAT(parts(5), around);
  EXPECT_EQ(parts(6.01), (Parts{{0, 1}}));
  const double chord = 0.1 * std::sqrt(1 - 0.6 * 0.6);
  EXPECT_THAT(parts(5.6), ElementsAre(FieldsAre(0, ::testing::DoubleNear(0.5 - chord, 1e-12)),
                                      FieldsAre(::testing::DoubleNear(0.5 + chord, 1e-12), 1)));
  EXPECT_THAT(visible_parts(scene, axes, {5, 5, 0}, {5, 5, 10}),
              ElementsAre(FieldsAre(::testing::DoubleNear(0.6, 1e-12), 1)));
}

/// Whether a shape of the scene lies between x and the viewer.
bool is_hidden(const SolidScene& scene, const ViewAxes& axes, const Vec3& x) {
  for (const SolidSphere& s : scene.sphere) {
    const Vec3 r = axes.of(x - s.centre);
    const double square = s.radius * s.radius - r[0] * r[0] - r[1] * r[1];
    if (square > 0 && r[2] < std::sqrt(square)) return true;
  }
  for (const SolidTriangle& t :
       scene.triangle) {  // x + s towards = a + u (b - a) + v (c - a), by Cramer's rule
    const Vec3 &a = scene.vertex[t.vertex[0]], b = scene.vertex[t.vertex[1]] - a,
               c = scene.vertex[t.vertex[2]] - a;
    const Vec3 way = -axes.towards, r = x - a;
    const double all = dot(way, cross(b, c));
    const double s = dot(r, cross(b, c)) / all, u = dot(way, cross(r, c)) / all,
                 v = dot(way, cross(b, r)) / all;
    if (s > 0 && u > 0 && v > 0 && u + v < 1) return true;
  }
  return false;
}

TEST(HiddenLines, AreThoseOfRaysToTheViewer) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(0, 10);
  const auto any = [&] { return Vec3{place(random), place(random), place(random)}; };
  int hidden = 0, visible = 0;
  for (int k = 0; k < 60; ++k) {
    SolidScene scene = empty_cell();
    add_mesh(scene, {{any(), any(), any(), any(), any(), any()}, {{0, 1, 2}, {3, 4, 5}}});
    add_ball(scene, any(), 2);
    add_ball(scene, any(), 1);
    const ViewAxes axes = axes_of({36. * k, 18. * (k % 11) - 90});
    const Vec3 a = any(), b = any();
    const Parts parts = visible_parts(scene, axes, a, b);
    for (double s = 0.0005; s < 1; s += 0.001) {
      bool is_visible = false, is_near_end = false;
      for (const auto& [from, to] : parts) {
        is_visible = is_visible || (from < s && s < to);
        is_near_end = is_near_end || std::abs(s - from) < 1e-9 || std::abs(s - to) < 1e-9;
      }
      if (is_near_end) continue;
      ASSERT_NE(is_visible, is_hidden(scene, axes, a + s * (b - a))) << k << " " << s;
      ++(is_visible ? visible : hidden);
    }
  }
  EXPECT_GT(hidden, 5000);
  EXPECT_GT(visible, 5000);
}

TEST(HiddenLines, ASurfaceLeavesNoGapsBetweenItsTriangles) {
  SolidScene scene = empty_cell();
  add_mesh(scene, geodesic_icosahedron(642, 100), {5, 5, 5});
  EXPECT_EQ(visible_parts(scene, axes_of({12, 34}), {4, 4.3, 4.5}, {6, 5.2, 5}), Parts{});
}

TEST(HiddenLines, OfAnImageAreThePixelsThatAreCovered) {
  SolidImage image{std::vector<std::uint32_t>(20), std::vector<std::uint8_t>(20), 10, 2};
  for (int x = 3; x < 7; ++x) image.covered[10 + x] = 16;
  image.covered[19] = 9;
  EXPECT_THAT(uncovered_parts(image, {0, 1.5}, {10, 1.5}),
              ElementsAre(FieldsAre(0, 0.3), FieldsAre(0.7, 0.9)));
  image.covered[18] = 8;  // leaves one pixel
  EXPECT_THAT(uncovered_parts(image, {0, 1.5}, {10, 1.5}), ElementsAre(FieldsAre(0, 0.3)));
  EXPECT_EQ(uncovered_parts(image, {0, 0.5}, {10, 0.5}), (Parts{{0, 1}}));
  EXPECT_EQ(uncovered_parts(image, {0, -5}, {10, -5}), (Parts{{0, 1}}));
}

}  // namespace
}  // namespace supple
