#include "supple/draw/solid/solid_scene.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "supple/core/error.hpp"
#include "supple/draw/scene/drawn_cell.hpp"
#include "supple/draw/solid/cell_planes.hpp"
#include "tests/draw/solid/scenes.hpp"

namespace supple {
namespace {

using namespace testing;

/// A surface that lies two cells away across the upper side of a sheared cell, and a sphere near a corner.
System<3> sample() {
  System<3> system;
  system.box.length = {10, 8, 6};
  system.box.strain = 0.25;  // two units along the flow for a cell up
  system.time = 3;
  TriangleMesh mesh = geodesic_icosahedron(42, 4);
  for (Vec3& x : mesh.vertex) x += Vec3{5 + 20 + 2, 7.9 + 8, 3};
  add_surface(system, mesh, 0.5, ShapeSpec{});
  add_sphere_body(system, {-0.7, 0.2, 5.9}, 0.5);  // the lower side begins at -1
  return system;
}

Vec3 mean(const SolidScene& scene, std::int32_t body) {
  Vec3 sum{};
  int count = 0;
  for (const SolidTriangle& t : scene.triangle)
    for (const std::int32_t v : t.vertex)
      if (t.body == body) sum += scene.vertex[v], ++count;
  return (1.0 / count) * sum;
}

TEST(SolidScene, HoldsEachParticleOnceWithItsMiddleInTheCell) {
  const SolidScene scene = solid_scene_of(sample(), Images::whole);
  EXPECT_EQ(scene.particle, (std::vector<std::int32_t>{0, 1}));
  EXPECT_EQ(scene.triangle.size(), 80u);
  ASSERT_EQ(scene.sphere.size(), 1u);
  EXPECT_NEAR(norm(scene.sphere[0].centre - Vec3{-0.7, 0.2, 5.9}), 0, 1e-12);
  EXPECT_NEAR(norm(mean(scene, 0) - Vec3{5, 7.9, 3}), 0, 1e-9);
  EXPECT_EQ(scene.time, 3);
}

TEST(SolidScene, SkinsReachAsFarAsTheVertices) {
  const System<3> system = sample();
  const double sigma = system.state.radius[0];
  const SolidScene bare = solid_scene_of(system, Images::whole, Skin::bare);
  const SolidScene inflated = solid_scene_of(system, Images::whole, Skin::inflated);
  const SolidScene rough = solid_scene_of(system, Images::whole, Skin::vertices);
  EXPECT_EQ(rough.vertex, bare.vertex);
  EXPECT_EQ(rough.sphere.size(), 43u);
  const Vec3 middle = mean(bare, 0);
  for (int i = 0; i < 42; ++i) {
    EXPECT_EQ(norm(rough.sphere[i].centre - bare.vertex[i]), 0);
    EXPECT_EQ(rough.sphere[i].radius, sigma);
    const Vec3 out = inflated.vertex[i] - bare.vertex[i];
    EXPECT_NEAR(norm(out), sigma, 1e-12);
    EXPECT_GT(dot(out, bare.vertex[i] - middle), 0.99 * sigma * norm(bare.vertex[i] - middle));
  }
}

TEST(SolidScene, ImagesAreThoseThatReachIntoTheCell) {
  const SolidScene scene = solid_scene_of(sample(), Images::cut);
  const auto bodies = [&](std::int32_t p) { return std::ranges::count(scene.particle, p); };
  EXPECT_EQ(bodies(0), 2);  // across the upper side
  EXPECT_EQ(bodies(1), 8);  // in a corner
  EXPECT_EQ(scene.triangle.size(), 160u);
  const auto second = std::ranges::find_if(scene.triangle, [](const SolidTriangle& t) { return t.body > 0; });
  ASSERT_EQ(scene.particle[second->body], 0);
  EXPECT_NEAR(norm(mean(scene, second->body) - (mean(scene, 0) - Vec3{2, 8, 0})), 0, 1e-9);
  for (const SolidSphere& s : scene.sphere) {
    const Vec3 r = s.centre - scene.sphere[0].centre;
    const double up = std::round(r[1] / 8), along = (r[0] - 2 * up) / 10;
    EXPECT_NEAR(r[1], 8 * up, 1e-12);
    EXPECT_NEAR(along, std::round(along), 1e-12);
  }
  System<3> walled = sample();
  walled.box.periodic = {true, false, true};
  EXPECT_EQ(std::ranges::count(solid_scene_of(walled).particle, 1), 4);
}

TEST(SolidScene, SidesGoThroughTheCorners) {
  Box<3> box = sample().box;
  box.strain = 7.1;  // drawn leaning by 7.1 - 6 * 10/8 = -0.4
  const auto corner = cell_corners(box);
  EXPECT_NEAR(corner[2][0] - corner[0][0], -0.4 * 8, 1e-12);
  EXPECT_NEAR(0.5 * (corner[0] + corner[7])[0], 5, 1e-12);
  const std::vector<CellPlane> planes = cell_planes(box);
  ASSERT_EQ(planes.size(), 6u);
  for (int p = 0; p < 6; ++p) {
    EXPECT_EQ(planes[p].direction, p / 2);
    EXPECT_NEAR(norm(planes[p].normal), 1, 1e-14);
    for (int k = 0; k < 8; ++k) {
      const double out = dot(planes[p].normal, corner[k]) - planes[p].level;
      if ((k >> p / 2 & 1) == p % 2) EXPECT_NEAR(out, 0, 1e-12) << p << " " << k;
      else EXPECT_LT(out, -1) << p << " " << k;
    }
  }
}

TEST(SolidScene, NeighboursGetDifferentColours) {
  // Neighbours are 8 numbers apart, so that colours given in turn would clash.
  SolidScene row = empty_cell();
  std::vector<double> place(27);
  for (int k = 0; k < 27; ++k) place[k * 8 % 27] = k;
  for (const double sign : {1., -1.}) {
    row.sphere.clear(), row.particle.clear(), row.particles = 0;
    for (const double x : place) add_ball(row, {sign * 3 * x, 0, 0}, 1.5);
    const std::vector<Color> all = colors_apart(std::span(&row, 1));
    for (int k = 0; k < 26; ++k) EXPECT_NE(all[k * 8 % 27], all[(k + 1) * 8 % 27]) << sign << " " << k;
  }
  SolidScene scene = empty_cell(), later = empty_cell();
  for (int k = 0; k < 9; ++k) {
    add_ball(scene, {3. * k, 0, 0}, 1.5);
    add_ball(later, {3. * k, 0, 0}, 1.0);
  }
  const std::vector<Color> one = colors_apart(std::span(&scene, 1));
  for (int k = 0; k < 8; ++k) EXPECT_NE(one[k], one[k + 1]);
  const auto same = std::ranges::find(one, one[8]) - one.begin();  // there are eight colours
  ASSERT_LT(same, 8);
  later.sphere[8].centre = later.sphere[same].centre + Vec3{0, 1.9, 0};
  const std::vector<Color> both = colors_apart(std::vector{scene, later});
  EXPECT_NE(both[same], both[8]);
}

std::string error_of(const SolidScene& scene) {
  try {
    check_scene(scene, "a.png");
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::input);
    EXPECT_THAT(e.what(), ::testing::StartsWith("cannot draw 'a.png'"));
    return e.what();
  }
  return "no error";
}

TEST(SolidScene, SaysWhatIsWrongWithIt) {
  SolidScene good = empty_cell();
  EXPECT_THAT(error_of(good), ::testing::HasSubstr("no particles"));
  add_mesh(good, geodesic_icosahedron(12), {5, 5, 5});
  add_ball(good, {1, 1, 1}, 1);
  EXPECT_EQ(error_of(good), "no error");
  const auto expect = [&](auto&& spoil, const char* message) {
    SolidScene bad = good;
    spoil(bad);
    EXPECT_THAT(error_of(bad), ::testing::HasSubstr(message));
  };
  expect([](SolidScene& s) { s.vertex[7][1] = NAN; }, "vertex 7 is not finite");
  expect([](SolidScene& s) { s.triangle[3].vertex[2] = 12; }, "triangle 3 names a vertex");
  expect([](SolidScene& s) { s.triangle[3].vertex[0] = -1; }, "triangle 3 names a vertex");
  expect([](SolidScene& s) { s.triangle[4].body = 2; }, "triangle 4 names a vertex or a body");
  expect([](SolidScene& s) { s.particle[1] = 2; }, "a particle that is not there");
  expect([](SolidScene& s) { s.sphere[0].body = -1; }, "sphere 0 is of a body");
  expect([](SolidScene& s) { s.sphere[0].radius = -1; }, "sphere 0 has a centre or radius");
  expect([](SolidScene& s) { s.sphere[0].centre[2] = INFINITY; }, "sphere 0 has a centre or radius");
  expect([](SolidScene& s) { s.box.length[2] = 0; }, "not above 0");
  expect([](SolidScene& s) { s.box.strain = NAN; }, "strain of its cell");
}

TEST(SolidScene, RefusesArraysThatDoNotFit) {
  const System<3> good = sample();
  const auto refuses = [&](auto&& spoil) {
    System<3> bad = good;
    spoil(bad);
    EXPECT_THROW(solid_scene_of(bad), Error);
  };
  refuses([](System<3>& s) { s.state.radius.pop_back(); });
  refuses([](System<3>& s) { s.state.position.pop_back(), s.state.radius.pop_back(); });
  refuses([](System<3>& s) { s.topology.facet_begin.pop_back(); });
  refuses([](System<3>& s) { s.topology.facet.pop_back(); });
  refuses([](System<3>& s) { s.topology.facet[5][1] = 43; });
  refuses([](System<3>& s) { s.topology.begin[0] = 1; });
}

}  // namespace
}  // namespace supple
