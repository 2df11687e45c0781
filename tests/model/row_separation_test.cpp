#include "supple/model/row_separation.hpp"

#include <gtest/gtest.h>

#include "supple/compat/particleshear/step.hpp"
#include "supple/solve/mover.hpp"

namespace supple {
namespace {

/// Two discs of radius 60 in a cell of 500 x 500, linked, that part at 120 together; without friction or
/// viscosity.
System<2> parting_pair(double x_first) {
  System<2> system;
  system.box.length = {500, 500};
  system.state.resize(2);
  State<2>& s = system.state;
  s.position = {{x_first, 250}, {x_first + 230, 250}};
  s.velocity = {{-60, 0}, {60, 0}};
  s.radius = {60, 60};
  s.mass = {1, 1};
  s.inertia = {1800, 1800};
  set_pair_state(system.pairs, 2, 0, 1, ContactState::permanent);
  return system;
}

Mover<2> linear_springs() {
  const PairStiffness spring{1, 0, 0, 0};
  return Mover(ForceField<2>(DiscContacts(Divergent(0), {spring, spring, Tensile{}, 0, Slip::clamp})));
}

/// A linear spring pulls with k (d - d0), at any distance: also beyond half a cell, where another image is
/// nearer, and where one of its discs has crossed the boundary.
TEST(LinkImage, ALinkLongerThanHalfTheCellPullsOn) {
  for (const double x_first : {10.0, 100.0, 480.0}) {
    System<2> system = parting_pair(x_first);
    Mover dynamics = linear_springs();
    double distance = 230, last = 0, farthest = 0;
    for (int step = 0; step < 400; ++step) {
      const Evaluation<2>& e = dynamics.evaluate(system, {});
      distance = row_separation(system, 0).r[0];
      ASSERT_NEAR(e.force[0][0], distance - 120, 1e-9 * distance) << "from " << x_first << ", step " << step;
      ASSERT_EQ(e.force[0][0], -e.force[1][0]);
      if (step > 0) {
        ASSERT_NEAR(distance, last, 1.0) << "jumped at step " << step;
      }
      last = distance;
      farthest = std::max(farthest, distance);
      dynamics.advance(system, {}, 0.005, 1);
    }
    // x'' = -2 (x - 120) from 230 at 120: amplitude sqrt(110^2 + 120^2/2) about 120.
    EXPECT_NEAR(farthest, 120 + std::sqrt(110 * 110 + 0.5 * 120 * 120), 0.5);
    EXPECT_GT(farthest, 250);
  }
}

/// The published package's stepper keeps images by the same table.
TEST(LinkImage, ThePublishedStepperKeepsThemToo) {
  System<2> system = parting_pair(480);
  ParticleShearConstants constants;
  constants.k = 1;
  ParticleShearStepper stepper(constants);
  double last = 230;
  for (int step = 0; step < 400; ++step) {
    stepper.evaluate(system, {});
    const double distance = row_separation(system, 0).r[0];
    ASSERT_NEAR(distance, last, 1.0) << "jumped at step " << step;
    last = distance;
    stepper.advance(system, {}, 0.005, 1);
  }
}

/// Wherever a disc has gone in a sheared cell, bringing it back into the cell changes no link.
TEST(LinkImage, LinksFollowADiscOverAShearedBoundary) {
  System<2> system = parting_pair(10);
  system.box.strain = 0.37;
  NeighborList<2> list;
  list.update(system);
  ASSERT_EQ(system.pairs.image.size(), 1u);  // 230 is near to half the cell
  for (const int i : {0, 1, 0})
    for (const Vec2& move : {Vec2{0, 500}, Vec2{500, 0}, Vec2{-1000, -500}}) {
      system.state.position[i] += move + Vec2{0.37 * move[1], 0};
      const Vec2 before = row_separation(system, 0).r;
      wrap_site(system, i);
      EXPECT_LT(norm(row_separation(system, 0).r - before), 1e-9);
      list.invalidate();
      list.update(system);
      EXPECT_LT(norm(row_separation(system, 0).r - before), 1e-9);
    }
}

TEST(LinkImage, ShortLinksNeedNoImage) {
  System<2> system = parting_pair(10);
  system.state.position[1] = {130, 250};
  NeighborList<2>().update(system);
  EXPECT_TRUE(system.pairs.image.empty());
  EXPECT_EQ(row_separation(system, 0).r, (Vec2{120, 0}));
}

}  // namespace
}  // namespace supple
