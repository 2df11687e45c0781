#include "supple/model/rigid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "supple/core/error.hpp"
#include "supple/solve/mover.hpp"
#include "tests/support/moving_bodies.hpp"

namespace supple {
namespace {

TEST(RigidBodies, OfRegularPolygonsHaveTheInertiaOfARingOfPoints) {
  System<2> system;
  system.box.length = {10, 10};
  add_polygon(system, {1e6 + 3, 4}, 2, 7, 0.4, 1, {});
  const std::vector<Vec2> before = system.state.position;
  make_rigid(system, 0);
  const RigidBodies& rigid = system.rigid;
  const double square = 2 * 2 / (7 * std::sin(2 * std::numbers::pi / 7));  // circumradius squared
  EXPECT_NEAR(rigid.centre[0][0] - 1e6, 3, 1e-9);
  EXPECT_NEAR(rigid.centre[0][1], 4, 1e-14);
  EXPECT_EQ(rigid.mass[0], 7);
  EXPECT_NEAR(rigid.inertia[0], 7 * square, 1e-8);
  EXPECT_NEAR(gyration_radius(rigid, 0), std::sqrt(square), 1e-9);
  EXPECT_LT(testing::largest(before, system.state.position), 1e-9);
  EXPECT_EQ(system.shape.stiffness[0].volume, 0);
  EXPECT_EQ(system.shape.stiffness[0].facet, 0);
}

TEST(RigidBodies, PlaceTheirSitesByCentreAndAngle) {
  System<2> system;
  system.box.length = {10, 10};
  add_polygon(system, {3, 4}, 2, 5, 0.4, 1, {});
  make_rigid(system, 0);
  system.rigid.centre[0] = {-7, 22};
  system.rigid.angle[0] = 100;
  system.rigid.velocity[0] = {1, -2};
  system.rigid.spin[0] = 0.5;
  place_sites(system);
  const double radius = gyration_radius(system.rigid, 0);
  for (int k = 0; k < 5; ++k) {
    const double angle = 0.4 + 100 + 2 * std::numbers::pi * k / 5;
    const Vec2 arm = radius * Vec2{std::cos(angle), std::sin(angle)};
    EXPECT_LT(norm(system.state.position[k] - Vec2{-7, 22} - arm), 1e-13);
    EXPECT_LT(norm(system.state.velocity[k] - Vec2{1, -2} - 0.5 * turned_left(arm)), 1e-13);
  }
}

TEST(RigidBodies, KeepMomentumAndAngularMomentumOfTheirSites) {
  System<2> system = testing::random_polygons({.bodies = 9});
  for (double& m : system.state.mass) m = 0.5 + 0.1 * static_cast<double>(&m - system.state.mass.data());
  testing::heat(system, 1);
  const Vec2 before = momenta(system).linear;
  const double turning = testing::angular_momentum(system);
  for (int b : {4, 8, 0, 3}) make_rigid(system, b);
  EXPECT_EQ(system.rigid.body, (std::vector<std::int32_t>{0, 3, 4, 8}));
  EXPECT_LT(norm(momenta(system).linear - before), 1e-11 * norm(before));
  EXPECT_NEAR(testing::angular_momentum(system), turning, 1e-12 * std::abs(turning));
}

TEST(RigidBodies, AddUpTheForcesOnTheirSites) {
  System<2> system = testing::random_polygons({.bodies = 2});
  make_rigid(system, 1);
  const int first = system.topology.begin[1];
  std::vector<Vec2> force(system.state.position.size());
  force[0] = {5, 5};
  force[first] = {1, 2};
  force[first + 3] = {-4, 0.5};
  const RigidForce sum = force_on_rigid(system, force, 0);
  const Vec2 a = system.state.position[first] - system.rigid.centre[0];
  const Vec2 b = system.state.position[first + 3] - system.rigid.centre[0];
  EXPECT_EQ(sum.force, (Vec2{-3, 2.5}));
  EXPECT_NEAR(sum.torque, a[0] * 2 - a[1] * 1 + b[0] * 0.5 + b[1] * 4, 1e-13);
}

TEST(RigidBodies, RefuseWhatCannotBeOne) {
  System<2> system = testing::random_polygons({.bodies = 2});
  add_disc_body(system, {1, 1}, 0.5);
  make_rigid(system, 1);
  for (int b : {-1, 1, 2, 3}) EXPECT_THROW(make_rigid(system, b), Error) << b;
  EXPECT_EQ(system.rigid.size(), 1);
  EXPECT_EQ(system.rigid.begin.size(), 2U);
}

}  // namespace
}  // namespace supple
