/// Lines along z through bodies: at every height as the outline is defined, and their integrals in closed
/// form.
#include "supple/observe/body_chords.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "supple/geometry/closest_point.hpp"
#include "supple/geometry/inside.hpp"
#include "supple/observe/line_integral.hpp"
#include "tests/support/surfaces.hpp"

namespace supple {
namespace {

using namespace testing;
using std::numbers::pi;

BodySurface shape_of(const TriangleMesh& mesh, double radius) {
  System<3> system;
  system.box.length = {100, 100, 100};
  add_mesh(system, mesh, radius, {50, 50, 50});
  return lay_out_bodies(system)[0];
}

/// Distance to the outline, negative inside.
double outside_by(const BodySurface& s, Outline outline, const Vec3& x) {
  double boundary = INFINITY, spheres = INFINITY;
  for (const auto& face : s.face) {
    const auto [a, b, c] = s.corners(face);
    boundary = std::min(boundary, norm(closest_on_triangle(x, {a, b, c}).from));
  }
  for (int k = 0; k < s.size(); ++k) spheres = std::min(spheres, norm(x - s.vertex[k]) - s.radius[k]);
  if (is_inside(x, s.vertex, s.face)) boundary = -boundary;
  return outline == Outline::smooth ? boundary - s.radius[0] : std::min(boundary, spheres);
}

bool hold(const std::vector<Interval>& chords, double z) {
  return std::any_of(chords.begin(), chords.end(),
                     [z](const Interval& i) { return i.low < z && z < i.high; });
}

TEST(BodyChords, AreInsideWhereTheOutlineSays) {
  RandomStream draw(8, Purpose::test);
  const TriangleMesh meshes[] = {box_mesh({1, 2, 1.5}),
                                 ell_mesh(),
                                 geodesic_icosahedron(42, 4),
                                 dented_sphere(162, 0.8, 0.9),
                                 star_mesh(42, 0.5, 2),
                                 saddle_mesh(3, 0.8),
                                 turned(box_mesh({1, 2, 1.5}), draw)};
  std::vector<Interval> chords;
  int inside = 0, all = 0;
  for (const TriangleMesh& mesh : meshes)
    for (const double radius : {0.0, 0.25, 0.7})
      for (const Outline outline : {Outline::rough, Outline::smooth}) {
        const BodySurface s = shape_of(mesh, radius);
        const BodyChords body(s, outline);
        const BoundsOf<3> region = s.bounds.grown(0.1);
        for (int k = 0; k < 300; ++k) {
          const Vec3 x{draw.uniform(region.low[0], region.high[0]),
                       draw.uniform(region.low[1], region.high[1]),
                       draw.uniform(region.low[2], region.high[2])};
          body.find({x[0], x[1]}, chords);
          const double outside = outside_by(s, outline, x);
          ASSERT_EQ(hold(chords, x[2]), outside < 0) << outside;
          for (std::size_t c = 1; c < chords.size(); ++c) ASSERT_LT(chords[c - 1].high, chords[c].low);
          inside += outside < 0;
          ++all;
        }
      }
  EXPECT_GT(inside, all / 5);
  EXPECT_LT(inside, all - all / 5);
}

/// Lines exactly through vertices and along edges of triangles meet the body once.
TEST(BodyChords, ThroughVerticesAndEdgesToo) {
  const BodySurface s = shape_of(box_mesh({2, 2, 2}), 0);
  const BodyChords body(s, Outline::rough);
  std::vector<Interval> chords;
  for (double x = -0.75; x < 1; x += 0.25)
    for (const double y : {x, -x, 0.0}) {
      body.find({s.vertex[0][0] + 1 + x, s.vertex[0][1] + 1 + y}, chords);
      ASSERT_EQ(chords.size(), 1u) << x << ' ' << y;
      EXPECT_NEAR(chords[0].high - chords[0].low, 2, 1e-14);
    }
}

TEST(BodyChords, IntegrateToTheVolumeOfSteiner) {
  RandomStream draw(1, Purpose::test);
  const double r = 0.3, exact = 6 + 22 * r + pi * (1 + 2 + 3) * r * r + 4 * pi / 3 * r * r * r;
  for (const TriangleMesh& mesh : {box_mesh({1, 2, 3}), turned(box_mesh({1, 2, 3}), draw)}) {
    const BodySurface s = shape_of(mesh, r);
    const BodyChords body(s, Outline::smooth);
    std::vector<Interval> chords;
    const auto length = [&](const LineAlongZ& line) {
      body.find(line, chords);
      double sum = 0;
      for (const Interval& i : chords) sum += i.high - i.low;
      return sum;
    };
    const Bounds base{{s.bounds.low[0], s.bounds.low[1]}, {s.bounds.high[0], s.bounds.high[1]}};
    const LineIntegral found = integrate_over_lines(base, 1e-4 * exact, 1 << 22, draw, length);
    EXPECT_NEAR(found.value, exact, 4 * found.error);
    EXPECT_LT(found.error, 3e-4 * exact);
    EXPECT_GT(found.error, 1e-7 * exact);
  }
}

TEST(Intervals, AreUnitedAndIntersected) {
  std::vector<Interval> a{{5, 6}, {1, 2}, {3, 3}, {1.5, 4}, {9, 8}, {4, 4.5}}, both;
  unite(a);
  ASSERT_EQ(a.size(), 2u);
  EXPECT_EQ(a[0].low, 1);
  EXPECT_EQ(a[0].high, 4.5);
  intersect(a, {{0, 1}, {2, 3}, {4, 5.5}, {5.75, 9}}, both);
  ASSERT_EQ(both.size(), 4u);
  EXPECT_EQ(both[1].low, 4);
  EXPECT_EQ(both[1].high, 4.5);
  EXPECT_EQ(both[2].low, 5);
  EXPECT_EQ(both[3].high, 6);
}

}  // namespace
}  // namespace supple
