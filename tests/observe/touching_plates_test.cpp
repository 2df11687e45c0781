#include "supple/observe/touching_plates.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "supple/build/surfaces.hpp"
#include "supple/core/error.hpp"
#include "supple/core/rotation.hpp"
#include "supple/model/bodies.hpp"
#include "supple/model/polygons.hpp"
#include "supple/model/rigid.hpp"

namespace supple {
namespace {

using std::numbers::pi;

TEST(PlateForces, AreOfTheLastDirectionAlone) {
  const std::vector<SiteForce<3>> wall{{0, {0, 0, 2}}, {1, {0, 0, 3}}, {5, {0, 0, -4}}, {7, {9, 0, 0}}};
  const PlateForces forces = sum_plate_forces<3>(wall);
  EXPECT_EQ(forces.lower, 5);
  EXPECT_EQ(forces.upper, 4);
  EXPECT_EQ(forces.lower_sites, 2);
  EXPECT_EQ(forces.upper_sites, 1);
  EXPECT_EQ(forces.mean(), 3);
  EXPECT_EQ(sum_plate_forces<2>({}).mean(), 0);
}

TEST(ReachAlong, HoldsTheDiscsOfAllSitesOfOneBody) {
  System<2> s;
  add_disc_body(s, {10, 10}, 3);
  add_polygon(s, {1, 2}, 2, 4, 0, 0.5, {});  // a square on its corner, 2 across
  const double radius = s.state.radius[1];
  const BodyReach across = reach_along(s, 1, 0), up = reach_along(s, 1, 1);
  EXPECT_NEAR(across.low, 0 - radius, 1e-12);
  EXPECT_NEAR(across.high, 2 + radius, 1e-12);
  EXPECT_NEAR(up.low, 1 - radius, 1e-12);
  EXPECT_NEAR(up.length(), 2 + 2 * radius, 1e-12);
  EXPECT_EQ(reach_along(s, 0, 1).high, 13);
}

System<3> ball() {
  System<3> s;
  add_surface(s, geodesic_icosahedron(12), 1, {});
  return s;
}

TEST(TurnedBy, FindsHowFarABodyWasTurned) {
  for (const double angle : {1e-9, 0.3, 2.0, 3.1}) {
    System<2> flat;
    add_polygon(flat, {1, 2}, 1, 7, 0.1, 1, {});
    std::vector<Vec2> before = flat.state.position;
    turn_body(flat, 0, -angle);
    move_body(flat, 0, {5, -3});
    EXPECT_NEAR(turned_by<2>(before, flat.state.position), angle, 1e-14);
    System<3> solid = ball();
    const std::vector<Vec3> start = solid.state.position;
    turn_body(solid, 0, angle * Vec3{0.6, 0, -0.8});
    move_body(solid, 0, {1, 2, 3});
    EXPECT_NEAR(turned_by<3>(start, solid.state.position), angle, 1e-13);
  }
  EXPECT_EQ(turned_by<2>(std::vector<Vec2>{{1, 2}}, std::vector<Vec2>{{3, 4}}), 0);
  EXPECT_THROW(turned_by<2>(std::vector<Vec2>{{1, 2}}, {}), Error);
}

TEST(TurnedBy, SquashingIsNoTurn) {
  System<3> s = ball();
  const std::vector<Vec3> before = s.state.position;
  for (Vec3& x : s.state.position) x[2] *= 0.5;
  EXPECT_NEAR(turned_by<3>(before, s.state.position), 0, 1e-8);
}

/// A quarter turn takes x to y (3D: about z), and the sites of a rigid body follow its angle.
TEST(TurnBody, TurnsCounterClockwise) {
  for (const bool is_rigid : {false, true}) {
    System<2> flat;
    add_polygon(flat, {1, 2}, 2, 4, 0, 1, {});
    if (is_rigid) make_rigid(flat, 0);
    const Vec2 first = flat.state.position[0];  // right of the centre
    turn_body(flat, 0, pi / 2);
    EXPECT_NEAR(norm(flat.state.position[0] - Vec2{1, 2 + (first[0] - 1)}), 0, 1e-14);
    System<3> solid = ball();
    move_body(solid, 0, {1, 2, 3});
    if (is_rigid) make_rigid(solid, 0);
    const Vec3 r = solid.state.position[3] - Vec3{1, 2, 3};
    turn_body(solid, 0, {0, 0, pi / 2});
    EXPECT_NEAR(norm(solid.state.position[3] - Vec3{1 - r[1], 2 + r[0], 3 + r[2]}), 0, 1e-13);
    turn_body(solid, 0, {pi / 2, 0, 0});  // on top of the first turn
    EXPECT_NEAR(norm(solid.state.position[3] - Vec3{1 - r[1], 2 - r[2], 3 + r[0]}), 0, 1e-13);
    if (is_rigid) {
      EXPECT_GT(norm(solid.rigid.angle[0]), 1);
    }
  }
}

}  // namespace
}  // namespace supple
