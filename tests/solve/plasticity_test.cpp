#include "supple/solve/plasticity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "supple/core/error.hpp"
#include "tests/support/moving_bodies.hpp"

namespace supple {
namespace {

constexpr double pi = std::numbers::pi;

/// A square of side 1, stretched by (1 + x) along x and by (1 + y) along y.
System<2> stretched_square(double x, double y, const ShapeStiffness& stiffness = {1, 1, 1, 0}) {
  System<2> system;
  system.box = {.length = {10, 10}, .periodic = {false, false}};
  const Vec2 at{3, 3};
  add_ring(system, {at, at + Vec2{1 + x, 0}, at + Vec2{1 + x, 1 + y}, at + Vec2{0, 1 + y}}, 0.1, stiffness, 1,
           {1, 1, 1, 1}, std::vector<double>(4, pi / 2));
  return system;
}

TEST(Plasticity, LengthHeldFixedIsApproachedAsStated) {
  for (double strain : {0.5, -0.4}) {
    const double yield = 0.1, tau = 2, length = 1 + strain, edge = strain > 0 ? 1.1 : 0.9;
    for (int steps : {1, 7, 1000}) {
      System<2> system = stretched_square(strain, 0);
      for (int k = 0; k < steps; ++k) advance(system, {tau, yield}, 3.0 / steps);
      const double end = length / edge, expected = end + (1 - end) * std::exp(-edge * 3 / tau);
      EXPECT_NEAR(system.shape.rest_facet[0], expected, 1e-13) << strain << " in " << steps << " steps";
      EXPECT_NEAR(system.shape.rest_facet[2], expected, 1e-13);
      EXPECT_EQ(system.shape.rest_facet[1], 1) << "an edge that is not strained";
    }
    // Any step is stable: the end is where it would just not flow.
    System<2> system = stretched_square(strain, 0);
    advance(system, {tau, yield}, 1e9);
    EXPECT_NEAR(length / system.shape.rest_facet[0] - 1, strain > 0 ? yield : -yield, 1e-15);
  }
}

TEST(Plasticity, RateIsTheOneStated) {
  System<2> system = stretched_square(0.3, 0.2);
  const double dt = 1e-6;
  advance(system, {2, 0.1, 0.25}, dt);
  EXPECT_NEAR((system.shape.rest_facet[0] - 1) / dt, (1.3 - 1.1) / 2, 1e-6);
  EXPECT_NEAR((system.shape.rest_facet[1] - 1) / dt, (1.2 - 1.1) / 2, 1e-6);
  EXPECT_NEAR((system.shape.rest_volume[0] - 1) / dt, (1.56 - 1.25) / 2, 1e-6);
}

TEST(Plasticity, BelowYieldNothingFlows) {
  System<2> system = stretched_square(0.3, -0.2);
  for (int i : {1, 2}) system.state.position[i][1] += 0.3;  // angles
  const Shape before = system.shape;
  for (const PlasticLaw& law : {PlasticLaw{1, 0.51, 0.1, 0.4}, PlasticLaw{1}}) {
    advance(system, law, 10);
    EXPECT_EQ(system.shape.rest_facet, before.rest_facet);
    EXPECT_EQ(system.shape.rest_volume, before.rest_volume);
    EXPECT_EQ(system.shape.rest_hinge, before.rest_hinge);
  }
}

TEST(Plasticity, WhatHasNoStiffnessStays) {
  System<2> system = stretched_square(0.3, 0.3, {});
  const Shape before = system.shape;
  system.state.position[1] += Vec2{0.2, 0.4};
  advance(system, {1, 0, 0, 0}, 10);
  EXPECT_EQ(system.shape.rest_facet, before.rest_facet);
  EXPECT_EQ(system.shape.rest_volume, before.rest_volume);
  EXPECT_EQ(system.shape.rest_hinge, before.rest_hinge);
}

TEST(Plasticity, AreaHeldFixedIsApproachedAsStated) {
  for (double strain : {0.5, -0.4}) {
    System<2> system = stretched_square(strain, 0);
    for (Vec2& x : system.state.position) x += Vec2{1e6, -1e6};
    for (int k = 0; k < 10; ++k) advance(system, {2, PlasticLaw::none, 0.2}, 0.3);
    const double edge = strain > 0 ? 1.2 : 0.8, end = (1 + strain) / edge;
    EXPECT_NEAR(system.shape.rest_volume[0], end + (1 - end) * std::exp(-edge * 1.5), 1e-9);
    EXPECT_EQ(system.shape.rest_facet[0], 1);
  }
}

TEST(Plasticity, AreaOfABodyTurnedInsideOutDoesNotFlow) {
  System<2> system = stretched_square(0, 0);
  std::swap(system.state.position[1], system.state.position[3]);
  advance(system, {1, PlasticLaw::none, 0.1}, 10);
  EXPECT_EQ(system.shape.rest_volume[0], 1);
}

/// A parallelogram: its corners turn by pi/2 -+ delta, whose mean is pi/2.
TEST(Plasticity, AnglesHeldFixedAreApproachedAsStated) {
  const double delta = 0.4, yield = 0.1;
  for (double offset : {0.0, -pi / 2}) {  // uniform changes of preferred angles have no effect
    System<2> system = stretched_square(0, 0);
    for (int i : {2, 3}) system.state.position[i] += Vec2{std::tan(delta), 0};
    for (double& angle : system.shape.rest_hinge) angle += offset;
    for (int k = 0; k < 10; ++k) advance(system, {2, PlasticLaw::none, PlasticLaw::none, yield}, 0.3);
    const double flow = (delta - yield) * (1 - std::exp(-1.5));
    for (int h = 0; h < 4; ++h)
      EXPECT_NEAR(system.shape.rest_hinge[h], pi / 2 + offset + (h % 2 ? -flow : flow), 1e-13) << h;
  }
}

TEST(Plasticity, RefusesLawsThatMeanNothing) {
  for (const PlasticLaw& law :
       {PlasticLaw{0}, PlasticLaw{-1}, PlasticLaw{1, -0.1}, PlasticLaw{1, 1}, PlasticLaw{1, 0.1, 1.5},
        PlasticLaw{1, 0.1, 0.1, -1}, PlasticLaw{1, std::nan("")}})
    EXPECT_THROW(check(law), Error);
  EXPECT_NO_THROW(check({1, 0.1, 0.9, 4}));
  EXPECT_NO_THROW(check({1}));
}

/// A shell of 12 vertices, pulled to 1.4 times its width by tethers, held, released, and its width at rest.
struct Pulled {
  System<2> system;
  double width_before = 0, width_held = 0, width_after = 0;

  explicit Pulled(const PlasticLaw* law) {
    system.box = {.length = {20, 20}, .periodic = {false, false}};
    add_polygon(system, {10, 10}, pi, 12, 0, 0.5, {1, 1, 0.5});
    width_before = width();
    ForceField<2> field = testing::shell_field();
    for (int i : {0, 6})
      field.external().tethers.push_back(
          {i, Vec2{10, 10} + 1.4 * (system.state.position[i] - Vec2{10, 10}), 100});
    Mover dynamics(std::move(field), 2);
    if (law) dynamics.set_plasticity(*law);
    const double dt = default_step(system, dynamics.forces(), 0.3);
    run(dynamics, dt, 40);
    width_held = width();
    dynamics.forces().external().tethers.clear();
    run(dynamics, dt, 100);
    width_after = width();
  }
  double width() const { return system.state.position[0][0] - system.state.position[6][0]; }
  void run(Mover<2>& dynamics, double dt, double time) {
    const double end = system.time + time;
    while (system.time < end) dynamics.advance(system, dt);
  }
};

TEST(Plasticity, PulledParticleKeepsItsNewShapeAndReturnsWithoutIt) {
  const PlasticLaw law{2, 0.05, 0.02, 0.05};
  const Pulled elastic(nullptr), plastic(&law);
  EXPECT_GT(elastic.width_held, 1.3 * elastic.width_before);
  EXPECT_NEAR(elastic.width_after, elastic.width_before, 1e-9);
  EXPECT_GT(plastic.width_after, elastic.width_before + 0.7 * (plastic.width_held - plastic.width_before));
  // It rests within the yield of its new preferred shape, to the end of an exponential approach.
  for (int f = 0; f < 12; ++f) {
    const double length =
        norm(plastic.system.state.position[(f + 1) % 12] - plastic.system.state.position[f]);
    EXPECT_LE(std::abs(length / plastic.system.shape.rest_facet[f] - 1), 0.05 + 1e-6);
  }
}

/// Held at every vertex the lengths follow the closed form, through Mover; released, every edge takes
/// its new length.
TEST(Plasticity, ReleasedEdgesHaveTheLengthsOfTheLaw) {
  System<2> system = stretched_square(0.5, 0, {0, 1, 0, 0});
  const double yield = 0.3, tau = 2;
  system.state.mobility.assign(4, Mobility::fixed);
  Mover dynamics(testing::shell_field(), 2);
  dynamics.set_plasticity(PlasticLaw{tau, yield});
  for (int k = 0; k < 300; ++k) dynamics.advance(system, 0.01);
  const double end = 1.5 / (1 + yield), expected = end + (1 - end) * std::exp(-(1 + yield) * 3 / tau);
  EXPECT_NEAR(system.shape.rest_facet[0], expected, 1e-13);
  system.state.mobility.assign(4, Mobility::free);
  dynamics.invalidate();
  for (int k = 0; k < 3000; ++k) dynamics.advance(system, 0.02);
  EXPECT_NEAR(norm(system.state.position[1] - system.state.position[0]), system.shape.rest_facet[0], 1e-9);
  EXPECT_NEAR(system.shape.rest_facet[0], expected, 0.05 * (expected - 1))
      << "it flows a little while it is being released";
  EXPECT_EQ(system.shape.rest_facet[1], 1);
}

/// Forces after a step are those of the shape after it: a run goes on from the state alone.
TEST(Plasticity, RunsGoOnFromTheStateBitForBit) {
  const PlasticLaw law{1, 0.01, 0.01, 0.01};
  System<2> system = testing::warm_shells(4);
  Mover dynamics(testing::shell_field());
  dynamics.set_plasticity(law);
  for (int k = 0; k < 100; ++k) dynamics.advance(system, 0.01);
  System<2> copy = system;
  Mover again(testing::shell_field());
  again.set_plasticity(law);
  for (int k = 0; k < 100; ++k) {
    dynamics.advance(system, 0.01);
    again.advance(copy, 0.01);
  }
  EXPECT_EQ(system.state.position, copy.state.position);
  EXPECT_EQ(system.shape.rest_facet, copy.shape.rest_facet);
  EXPECT_EQ(system.shape.rest_hinge, copy.shape.rest_hinge);
}

}  // namespace
}  // namespace supple
