/// Rigid bodies in the leapfrog: they turn without winding contacts up, keep what is conserved, and go on
/// from a state.
#include <gtest/gtest.h>

#include <numbers>

#include "supple/contact/link_forces.hpp"
#include "supple/core/parallel.hpp"
#include "supple/observe/summary.hpp"
#include "supple/solve/mover.hpp"
#include "tests/support/polygons.hpp"
#include "tests/support/touching.hpp"

namespace supple {
namespace {

using namespace testing;

void make_polygons_rigid(System<2>& system, int every = 1) {
  for (int b = 0; b < system.topology.body_count(system.state.size()); b += every)
    if (system.topology.body_size(b) > 1) make_rigid(system, b);
}

TEST(RigidLeapfrog, SitesMoveByTheStraightStepsThatTheyMade) {
  System<2> system = random_polygons({.bodies = 2});
  make_rigid(system, 1);
  system.rigid.velocity[0] = {0.3, -1};
  system.rigid.spin[0] = 4;
  place_sites(system);
  const System<2> before = system;
  const double dt = 0.1;
  system.rigid.centre[0] += dt * system.rigid.velocity[0];
  system.rigid.angle[0] += dt * system.rigid.spin[0];
  system.lag = dt;
  place_sites(system);
  const Instant then{system.state, 0.5 * dt};
  for (int i = system.topology.begin[1]; i < system.topology.begin[2]; ++i) {
    EXPECT_LT(norm(system.state.position[i] - dt * system.state.velocity[i] - before.state.position[i]),
              1e-14);
    const Vec2 arm = then.position(i) - system.rigid.centre[0] + 0.5 * dt * system.rigid.velocity[0];
    EXPECT_LT(norm(system.state.velocity[i] - system.rigid.velocity[0] - cross(std::tan(0.2) / 0.05, arm)),
              1e-13);
  }
}

/// A touching pair that turns as a whole, each body about its own centre.
TEST(RigidLeapfrog, RigidTurnOfATouchingOrLinkedPairWindsUpNothing) {
  for (Touching& t : all_touchings())
    for (const bool linked : {false, true}) {
      SCOPED_TRACE(t.name);
      System<2> system = t.system;
      make_polygons_rigid(system);
      ForceField<2> field = t.field({.friction = 1e9, .k_t = 40, .eta = 3, .eta_t = 2});
      if (linked) {
        system.links = {{0, system.topology.begin[1], {}, 1, 0}};
        field.add(LinkForces(LinkLaw{100, 3, 40, 2}));
      }
      Evaluation<2> out;
      const int steps = 40;
      const double angle = 2 * std::numbers::pi / steps, dt = 0.01;
      RigidBodies& rigid = system.rigid;
      int seen = 0;
      for (int k = 0; k < steps; ++k) {
        turn(system, {49, 52}, angle, dt);  // discs, and where the others will be
        for (int r = 0; r < rigid.size(); ++r) {
          const Vec2 arm = rigid.centre[r] - Vec2{49, 52};
          const Vec2 to = Vec2{49, 52} + std::cos(angle) * arm + std::sin(angle) * turned_left(arm);
          rigid.velocity[r] = (1 / dt) * (to - rigid.centre[r]);
          rigid.centre[r] = to;
          rigid.angle[r] += angle;
          rigid.spin[r] = angle / dt;
        }
        const std::vector<Vec2> expected = system.state.position;
        place_sites(system);
        for (std::size_t i = 0; i < expected.size(); ++i)
          ASSERT_LT(norm(system.state.position[i] - expected[i]), 1e-12);
        field.evaluate(system, Detail::energies, out);
        field.commit(system, out);
        EXPECT_LT(out.energy.viscous_power + out.energy.tangential_viscous_power, 1e-18);
        for (const Touch& touch : system.touches.rows) EXPECT_LT(std::abs(touch.elongation), 1e-12);
        for (const Link& link : system.links) EXPECT_LT(std::abs(link.elongation), 1e-12);
        seen += static_cast<int>(system.touches.rows.size() + system.links.size());
      }
      EXPECT_GE(seen, steps);
    }
}

/// Rigid and deformable polygons and a disc that rub and are linked, in an open cell.
System<2> cluster() {
  System<2> system = random_polygons({.bodies = 9, .seed = 5});
  system.box.periodic = {false, false};
  system.box.strain = 0;
  add_disc_body(system, {1.1, 1.2}, 0.3);
  make_polygons_rigid(system, 2);
  stir(system, 3);
  for (int r = 0; r < system.rigid.size(); ++r) {
    system.rigid.velocity[r] = {0.1 * r, -0.2};
    system.rigid.spin[r] = 0.3 - 0.1 * r;
  }
  system.state.spin.assign(system.state.spin.size(), 0);
  system.links = {{3, system.topology.begin[1], {}, 1, 0}, {4, system.topology.begin[3] + 2, {}, 1, 0}};
  place_sites(system);
  return system;
}

Mover<2> rubbing(bool smooth) {
  std::shared_ptr<BodyContacts<2>> contacts;
  if (smooth) contacts = std::make_shared<SmoothContacts>(Harmonic{5});
  else contacts = std::make_shared<RoughContacts<2>>(Harmonic{5});
  ForceField<2> field = polygon_field(*contacts);
  field.add(TouchFriction(TouchLaw{0.4, 3, 0.5, 0.3}));
  field.add(LinkForces(LinkLaw{3, 0.2, 2, 0.1}));
  return Mover(std::move(field));
}

void run(System<2>& s, Mover<2>& d, int steps, double rate = 0, double damping = 1) {
  for (int i = 0; i < steps; ++i) {
    d.evaluate(s, {rate, rate});
    d.advance(s, {rate, rate}, 0.01, damping);
  }
}

/// Each step takes the angular momentum about positions of the step from one to the next, with what is half a
/// step behind.
TEST(RigidLeapfrog, FreeClustersKeepMomentumAndAngularMomentum) {
  for (const bool smooth : {false, true}) {
    System<2> system = cluster();
    Mover dynamics = rubbing(smooth);
    run(system, dynamics, 1);
    const Momenta before = momenta(system, dynamics.evaluate(system, {}));
    const double spin = system.rigid.spin[0];
    run(system, dynamics, 1000);
    const Momenta after = momenta(system, dynamics.evaluate(system, {}));
    EXPECT_LT(norm(after.linear - before.linear), 1e-12 * system.state.size());
    EXPECT_NEAR(after.angular, before.angular, 1e-12 * system.state.size());
    EXPECT_GT(std::abs(system.rigid.spin[0] - spin), 1e-2);
    EXPECT_GT(system.touches.rows.size(), 3u);
  }
}

System<2> sheared_cluster() {
  System<2> system = cluster();
  system.box.periodic = {true, true};
  system.box.length = 1.3 * system.box.length;
  return system;
}

void expect_same_bits(const System<2>& a, const System<2>& b) {
  EXPECT_EQ(a.state.position, b.state.position);
  EXPECT_EQ(a.state.velocity, b.state.velocity);
  EXPECT_EQ(a.state.spin, b.state.spin);
  EXPECT_EQ(a.rigid.centre, b.rigid.centre);
  EXPECT_EQ(a.rigid.angle, b.rigid.angle);
  EXPECT_EQ(a.rigid.velocity, b.rigid.velocity);
  EXPECT_EQ(a.rigid.spin, b.rigid.spin);
}

TEST(RigidLeapfrog, GoesOnFromItsStateBitForBitForAnyNumberOfThreads) {
  for (const bool smooth : {false, true}) {
    System<2> whole = sheared_cluster(), split = whole;
    Mover a = rubbing(smooth), b = rubbing(smooth), c = rubbing(smooth);
    run(whole, a, 500, 0.3, 0.999);
    run(split, b, 217, 0.3, 0.999);
    thread_count() = 2;
    run(split, c, 283, 0.3, 0.999);  // a fresh list, built at another instant
    thread_count() = 1;
    expect_same_bits(whole, split);
    for (const Vec2& centre : whole.rigid.centre)
      for (int d = 0; d < 2; ++d) EXPECT_TRUE(0 <= centre[d] && centre[d] < whole.box.length[d]);
  }
}

/// In a flow without contacts a rigid body moves with the flow at its centre and turns with its vorticity.
TEST(RigidLeapfrog, AlonePolygonsFollowTheFlowAndAreDampedTowardsIt) {
  System<2> system;
  system.box.length = {40, 40};
  add_polygon(system, {10, 30}, 3, 7, 0.2, 1, {});
  make_rigid(system, 0);
  Mover dynamics = rubbing(false);
  run(system, dynamics, 100, 0.3);
  EXPECT_NEAR(system.rigid.velocity[0][0], 0.3 * 10, 1e-13);
  EXPECT_NEAR(system.rigid.spin[0], -0.15, 1e-15);
  EXPECT_NEAR(system.rigid.centre[0][0], 10 + 3, 1e-12);
  EXPECT_NEAR(system.rigid.angle[0], -0.15, 1e-13);
  system.rigid.velocity[0] = {1, 0.5};
  system.rigid.spin[0] = 0.6;
  place_sites(system);
  damp(system, 0.25, Drag::bodies);
  EXPECT_NEAR(system.rigid.velocity[0][0], 3 + 0.25 * (1 - 3), 1e-12);
  EXPECT_NEAR(system.rigid.velocity[0][1], 0.125, 1e-15);
  EXPECT_NEAR(system.rigid.spin[0], -0.15 + 0.25 * 0.75, 1e-15);
}

/// A rigid body that leaves the sheared cell comes back with the velocity of its image.
TEST(RigidLeapfrog, CrossesTheShearedBoundaryInOnePiece) {
  System<2> system = sheared_cluster();
  system.box.strain = 1.37;
  system.box.strain_rate = 0.3;
  for (int b = 0; b < 9; b += 2) system.rigid.centre[b / 2] += Vec2{0, 0.55 * system.box.length[1]};
  place_sites(system);
  const System<2> before = system;
  ASSERT_TRUE(wrap_bodies(system));
  EXPECT_FALSE(wrap_bodies(system));
  int moved = 0;
  for (int r = 0; r < system.rigid.size(); ++r) {
    const Vec2 by = system.rigid.centre[r] - before.rigid.centre[r],
               gained = system.rigid.velocity[r] - before.rigid.velocity[r];
    EXPECT_NEAR(gained[flow], 0.3 * by[gradient], 1e-12);
    EXPECT_EQ(system.rigid.angle[r], before.rigid.angle[r]);
    EXPECT_EQ(system.rigid.spin[r], before.rigid.spin[r]);
    moved += by[gradient] != 0;
    const int b = system.rigid.body[r];
    for (int i = system.topology.begin[b]; i < system.topology.begin[b + 1]; ++i) {
      EXPECT_LT(norm(system.state.position[i] - before.state.position[i] - by), 1e-13);
      EXPECT_LT(norm(system.state.velocity[i] - before.state.velocity[i] - gained), 1e-13);
    }
  }
  EXPECT_GT(moved, 1);
}

}  // namespace
}  // namespace supple
