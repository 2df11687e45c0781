#include "supple/draw/solid/solid_image.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "supple/core/error.hpp"
#include "supple/core/parallel.hpp"
#include "supple/draw/solid/light.hpp"
#include "tests/draw/solid/scenes.hpp"

namespace supple {
namespace {

using namespace testing;
constexpr SolidStyle plain{Shading::flat, 0, 0};

TEST(SolidImage, ASphereCoversItsDisc) {
  SolidScene scene = empty_cell();
  add_ball(scene, {5.03, 4.98, 5.01}, 3);
  for (const char* view : {"x", "corner"}) {
    const SolidImage image = draw_solid(scene, std::vector{red}, window_on(scene, view_of(view), 240), plain);
    const double disc = std::numbers::pi * 60 * 60;
    EXPECT_NEAR(covered_pixels(image), disc, 0.002 * disc) << view;
  }
}

TEST(SolidImage, NearerHidesFartherInBothOrders) {
  const View view = view_of("y");  // from -y
  SolidScene one = empty_cell(), other = empty_cell();
  add_ball(one, {5, 3, 5}, 1);
  add_ball(one, {5, 7, 5}, 2);
  add_ball(other, {5, 7, 5}, 2);
  add_ball(other, {5, 3, 5}, 1);
  const SolidWindow window = window_on(one, view, 120);
  const SolidImage a = draw_solid(one, std::vector{red, blue}, window, {});
  const SolidImage b = draw_solid(other, std::vector{blue, red}, window, {});
  EXPECT_EQ(a.pixel, b.pixel);
  EXPECT_TRUE(is_red(pixel_at(a, window, {5, 0, 5})));
  EXPECT_TRUE(is_blue(pixel_at(a, window, {6.5, 0, 5})));
  const SolidWindow behind = window_on(one, {90, 0}, 120);
  EXPECT_TRUE(is_blue(pixel_at(draw_solid(one, std::vector{red, blue}, behind, {}), behind, {5, 0, 5})));
}

TriangleMesh tetrahedron(const std::array<Vec3, 4>& at) {
  TriangleMesh mesh{{at.begin(), at.end()}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  EXPECT_GT(enclosed_volume(mesh), 0);
  return mesh;
}

/// Height of the plane through three points above (x, y).
double height(const std::array<Vec3, 3>& p, double x, double y) {
  const Vec3 n = cross(p[1] - p[0], p[2] - p[0]);
  return p[0][2] - (n[0] * (x - p[0][0]) + n[1] * (y - p[0][1])) / n[2];
}

TEST(SolidImage, TetrahedraThatGoThroughEachOtherMeetInALine) {
  // The uppermost face of each is 0 1 3, and is wide enough to cover all that is looked at.
  const std::array<Vec3, 4> a{{{-9, -9, 4.1}, {19, -9, 6.3}, {5, 5, -20}, {5, 25, 5.2}}};
  const std::array<Vec3, 4> b{{{-9, -9, 6.4}, {19, -9, 3.7}, {5, 5, -20}, {5, 25, 5.9}}};
  SolidScene scene = empty_cell();
  add_mesh(scene, tetrahedron(a));
  add_mesh(scene, tetrahedron(b));
  const SolidWindow window = window_on(scene, view_of("z"), 240);
  const SolidImage image = draw_solid(scene, std::vector{red, green}, window, plain);
  int reds = 0, greens = 0;
  for (double y = 0.1; y < 10; y += 0.3) {
    const auto above = [&](double x) {
      return height({a[0], a[1], a[3]}, x, y) - height({b[0], b[1], b[3]}, x, y);
    };
    const double line = -above(0) / (above(1) - above(0));  // where both have the same height
    ASSERT_TRUE(0 < line && line < 10);
    for (double x = 0.05; x < 10; x += 0.1) {
      if (std::abs(x - line) < 0.051) continue;  // a pixel
      const std::uint32_t p = pixel_at(image, window, {x, y, 0});
      EXPECT_EQ(is_red(p), above(x) > 0) << x << " " << y;
      EXPECT_EQ(is_green(p), above(x) < 0) << x << " " << y;
      (above(x) > 0 ? reds : greens)++;
    }
  }
  EXPECT_GT(reds, 300);
  EXPECT_GT(greens, 300);
}

TEST(SolidImage, LightComesFromTheUpperLeft) {
  SolidScene ball = empty_cell(), mesh = empty_cell();
  add_ball(ball, {5, 5, 5}, 4);
  add_mesh(mesh, geodesic_icosahedron(642, 4 * std::numbers::pi / 3 * 64), {5, 5, 5});
  const SolidWindow window = window_on(ball, view_of("y"), 240);  // x to the right, z up
  for (const Shading shading : {Shading::flat, Shading::smooth}) {
    const SolidStyle style{shading, 0, 0};
    const SolidImage exact = draw_solid(ball, std::vector{white}, window, style);
    const SolidImage faceted = draw_solid(mesh, std::vector{white}, window, style);
    const auto at = [&](const SolidImage& image, double right, double up) {
      return level(pixel_at(image, window, {5 + right, 5, 5 + up}));
    };
    for (const SolidImage* image : {&exact, &faceted}) {
      EXPECT_GT(at(*image, -2, 2), at(*image, 2, -2) + 100);
      EXPECT_GT(at(*image, -2, 2), at(*image, 2, 2) + 20);
      EXPECT_GT(at(*image, -2, 2), at(*image, -2, -2) + 20);
    }
    for (const double right : {-2., 0., 2.}) {
      const double bright = 3 * 255 * brightness({right, 1, std::sqrt(16 - right * right - 1)});
      EXPECT_NEAR(at(exact, right, 1), bright, 4);
      EXPECT_NEAR(at(faceted, right, 1), bright, shading == Shading::flat ? 40 : 8);
    }
  }
}

TEST(SolidImage, DoesNotShowTheTilesItIsMadeOf) {
  SolidScene scene = empty_cell();
  for (int k = 0; k < 12; ++k)
    add_mesh(scene, geodesic_icosahedron(42, 8), {0.75 * k, 3 + 0.25 * (k * 7 % 12), 0.5 * k});
  const std::vector<Color> color(12, green);
  SolidWindow window = window_on(scene, view_of("z"), 192);  // 16 pixels for a length of 1
  const SolidStyle style{Shading::smooth, 0.5, 2};
  const SolidImage image = draw_solid(scene, color, window, style);
  window.left += 1;
  window.top -= 1;
  const SolidImage moved = draw_solid(scene, color, window, style);
  for (int j = 0; j < 176; ++j)
    for (int i = 0; i < 176; ++i)
      ASSERT_EQ(moved.pixel[j * 192 + i], image.pixel[(j + 16) * 192 + i + 16]) << i << " " << j;
}

TEST(SolidImage, SmoothShadingKeepsTheEdgesOfACube) {
  SolidScene scene = empty_cell();
  TriangleMesh cube;
  for (int k = 0; k < 8; ++k)
    cube.vertex.push_back({3. + 4 * (k & 1), 3. + 4 * (k >> 1 & 1), 3. + 4 * (k >> 2)});
  cube.face = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
               {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  add_mesh(scene, cube);
  const SolidWindow window = window_on(scene, view_of("corner"), 200);
  EXPECT_EQ(draw_solid(scene, std::vector{red}, window, {Shading::smooth, 0, 0}).pixel,
            draw_solid(scene, std::vector{red}, window, {Shading::flat, 0, 0}).pixel);
}

TEST(SolidImage, LinesLieOnEdgesAndAroundParticles) {
  SolidScene scene = empty_cell();
  add_mesh(scene, geodesic_icosahedron(12, 200), {5, 5, 5});
  const SolidWindow window = window_on(scene, view_of("z"), 240);
  const auto draw = [&](double edge, double outline) {
    return draw_solid(scene, std::vector{white}, window, {Shading::flat, edge, outline});
  };
  const SolidImage bare = draw(0, 0), edges = draw(2, 0), outline = draw(0, 3);
  const auto corner = [&](const SolidTriangle& t, int k) { return scene.vertex[t.vertex[k]]; };
  const auto height = [&](const SolidTriangle& t) { return (corner(t, 0) + corner(t, 1) + corner(t, 2))[2]; };
  const SolidTriangle top = *std::ranges::max_element(scene.triangle, {}, height);
  const Vec3 a = corner(top, 0), b = corner(top, 1), centre = (1.0 / 3) * (a + b + corner(top, 2));
  EXPECT_LT(level(pixel_at(edges, window, 0.5 * (a + b))),
            level(pixel_at(bare, window, 0.5 * (a + b))) - 100);
  EXPECT_EQ(pixel_at(edges, window, centre), pixel_at(bare, window, centre));
  double marked = 0, rim = 0;  // pixels that an outline of 3 pixels darkens lie within 3 pixels of white ones
  for (int j = 4; j < 236; ++j)
    for (int i = 4; i < 236; ++i) {
      const int p = j * 240 + i;
      if (outline.pixel[p] == bare.pixel[p]) continue;
      ++marked;
      bool is_near = false;
      for (int y = -3; y <= 3; ++y)
        for (int x = -3; x <= 3; ++x) is_near = is_near || bare.covered[p + 240 * y + x] < 16;
      rim += is_near;
    }
  EXPECT_GT(marked, 1000);
  EXPECT_EQ(marked, rim);
}

TEST(SolidImage, HasTheSameBitsForAnyNumberOfThreads) {
  SolidScene scene = empty_cell();
  scene.images = Images::cut;
  for (int k = 0; k < 20; ++k)
    add_mesh(scene, geodesic_icosahedron(42, 8), {0.5 * k, std::fmod(3.7 * k, 10), std::fmod(2.3 * k, 10)});
  const std::vector<Color> color(20, green);
  const SolidWindow window = window_on(scene, view_of("corner"), 333);
  const SolidImage one = draw_solid(scene, color, window, {Shading::smooth, 0.7, 1.3});
  for (const int threads : {2, 5}) {
    const WithThreads these(threads);
    EXPECT_EQ(draw_solid(scene, color, window, {Shading::smooth, 0.7, 1.3}).pixel, one.pixel);
  }
}

TEST(SolidImage, WhatLiesWithinTheCellIsNotCut) {
  SolidScene scene = empty_cell();
  add_mesh(scene, geodesic_icosahedron(642, 150), {5, 5, 5});
  add_ball(scene, {8.5, 5, 5}, 1.2);
  for (const char* view : {"x", "y", "z", "corner", "33,-71"}) {
    const SolidWindow window = window_on(scene, view_of(view), 200);
    scene.images = Images::whole;
    const SolidImage whole = draw_solid(scene, std::vector{red, blue}, window, {});
    scene.images = Images::cut;
    EXPECT_EQ(draw_solid(scene, std::vector{red, blue}, window, {}).pixel, whole.pixel) << view;
  }
}

TEST(SolidImage, WhatIsCutShowsItsInside) {
  SolidScene scene = empty_cell();
  scene.images = Images::cut;
  scene.box.strain = 0.2;  // leans along x: the upper side stays where it is
  add_ball(scene, {5, 5, 9}, 3);
  const SolidWindow window = window_on(scene, view_of("z"), 240);
  const SolidImage image = draw_solid(scene, std::vector{white}, window, plain);
  const double disc = std::sqrt(8.0);  // of the sphere at the side z = 10
  const std::uint32_t cut = pixel_at(image, window, {5, 5, 10});
  for (const double share : {-0.95, -0.5, 0.5, 0.95})
    EXPECT_EQ(pixel_at(image, window, {5 + share * disc, 5, 10}), cut);
  EXPECT_NE(pixel_at(image, window, {5 + 1.02 * disc, 5, 10}), cut);
  const double area = std::numbers::pi * 9 * 400;
  EXPECT_NEAR(covered_pixels(image), area, 0.003 * area);  // seen from above nothing else is missing
  scene.box.periodic[2] = false;
  const SolidImage open = draw_solid(scene, std::vector{white}, window, plain);
  EXPECT_NE(pixel_at(open, window, {5 + 0.95 * disc, 5, 10}), pixel_at(open, window, {5, 5, 10}));
}

TEST(SolidImage, ABodyLargerThanTheCellFillsItsOutline) {
  SolidScene scene = empty_cell();
  scene.images = Images::cut;
  add_mesh(scene, geodesic_icosahedron(162, 1e5), {5, 5, 5});
  const SolidImage image = draw_solid(scene, std::vector{red}, window_on(scene, view_of("y"), 240), plain);
  EXPECT_NEAR(covered_pixels(image), 200 * 200, 1);
}

TEST(SolidImage, RefusesPicturesWithoutPixels) {
  SolidScene scene = empty_cell();
  add_ball(scene, {5, 5, 5}, 1);
  const auto error = [&](int width, int height, double scale) -> std::string {
    SolidWindow window = window_on(scene, {}, 10);
    window.width = width;
    window.height = height;
    window.pixels_per_length = scale;
    try {
      draw_solid(scene, std::vector{red}, window, {});
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::input);
      return e.what();
    }
    return "";
  };
  EXPECT_THAT(error(0, 10, 1), ::testing::HasSubstr("larger"));
  EXPECT_THAT(error(10, -1, 1), ::testing::HasSubstr("larger"));
  EXPECT_THAT(error(30000, 30000, 1), ::testing::HasSubstr("smaller"));
  EXPECT_THAT(error(10, 10, 0), ::testing::HasSubstr("0 of them"));
  EXPECT_THAT(error(10, 10, NAN), ::testing::HasSubstr("nan"));
}

}  // namespace
}  // namespace supple
