#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "supple/solve/mover.hpp"
#include "supple/solve/time_step.hpp"
#include "tests/support/moving_bodies.hpp"

namespace supple {
namespace {

using testing::angular_momentum;
using testing::heat;
using testing::shell_field;
using testing::total_energy;
using testing::warm_shells;

/// Two rigid rough octagons (the second one deformable on request) that meet off centre, in the open.
System<2> colliding_octagons(int rigid = 2) {
  System<2> system;
  system.box = {.length = {20, 20}, .periodic = {false, false}};
  add_polygon(system, {8, 10}, 3, 8, 0.1, 1, {1, 1, 0.1});
  add_polygon(system, {12, 11.3}, 3, 8, 0.3, 1, {1, 1, 0.1});
  for (int i = 0; i < 16; ++i) system.state.velocity[i] = i < 8 ? Vec2{0.1, 0} : Vec2{-0.05, 0.003};
  for (int b = 0; b < rigid; ++b) make_rigid(system, b);
  return system;
}

TEST(RigidDynamics, FreeRotorKeepsItsSpin) {
  System<2> system = colliding_octagons(1);
  system.rigid.spin[0] = 1.3;
  system.rigid.velocity[0] = {-0.5, 0.25};
  const Vec2 centre = system.rigid.centre[0];
  Mover dynamics(shell_field());
  for (int k = 0; k < 10000; ++k) dynamics.advance(system, 0.01);
  EXPECT_EQ(system.rigid.spin[0], 1.3);
  EXPECT_NEAR(system.rigid.angle[0], 130, 1e-10);
  EXPECT_LT(norm(system.rigid.centre[0] - centre - Vec2{-50, 25}), 1e-10);
  const double radius = gyration_radius(system.rigid, 0), angle = 0.1 + system.rigid.angle[0];
  EXPECT_LT(norm(system.state.position[0] - system.rigid.centre[0] -
                 radius * Vec2{std::cos(angle), std::sin(angle)}),
            1e-13)
      << "its shape is what it was";
}

/// A regular polygon tethered at every vertex is a pendulum: U = N k R^2 (1 - cos angle), I = N R^2, so that
/// w = sqrt(k), and at amplitude A the period is 4 K(sin(A/2))/w.
TEST(RigidDynamics, TetheredPolygonIsAPendulum) {
  System<2> system = colliding_octagons(1);
  ForceField<2> field = shell_field();
  const double k = 2.5, amplitude = 2;
  for (int i = 0; i < 8; ++i) field.external().tethers.push_back({i, system.state.position[i], k});
  system.rigid.velocity[0] = {};
  system.rigid.angle[0] = amplitude;
  place_sites(system);
  Mover dynamics(std::move(field));
  const double period = 4 * std::comp_ellint_1(std::sin(amplitude / 2)) / std::sqrt(k);
  const auto error = [&](int steps) {
    System<2> copy = system;
    dynamics.invalidate();
    for (int step = 0; step < steps; ++step) dynamics.advance(copy, 0.25 * period / steps);
    return copy.rigid.angle[0];  // 0 after a quarter of the period
  };
  const double coarse = error(200), fine = error(400);
  EXPECT_LT(std::abs(coarse), 1e-4);
  EXPECT_NEAR(coarse / fine, 4, 0.05);
}

TEST(RigidDynamics, CollisionsKeepMomentumAngularMomentumAndEnergy) {
  for (int rigid : {2, 1}) {
    const auto energy_error = [&](double dt) {
      System<2> system = colliding_octagons(rigid);
      Mover dynamics(shell_field());
      const double energy = total_energy(dynamics, system), turning = angular_momentum(system);
      const Vec2 before = momenta(system).linear;
      double touched = 0, squares = 0;
      while (system.time < 35) {
        dynamics.advance(system, dt);
        squares += dt * std::pow(total_energy(dynamics, system) / energy - 1, 2);
        touched = std::max(touched, dynamics.evaluate_energies(system).energy.elastic);
      }
      EXPECT_GT(touched, 0.1 * energy);
      EXPECT_EQ(dynamics.evaluate_energies(system).energy.elastic, 0) << "they have parted";
      EXPECT_GT(std::abs(system.rigid.spin[0]), 0.005);
      EXPECT_LT(norm(momenta(system).linear - before), 1e-12);
      EXPECT_NEAR(angular_momentum(system), turning, 1e-11) << "of " << turning;
      return std::sqrt(squares / system.time);
    };
    // How much depends on where in a step contacts begin, but none of it is of first order.
    for (double dt : {0.16, 0.04, 0.01})
      EXPECT_LT(energy_error(dt), 0.15 * dt * dt) << rigid << " rigid, step " << dt;
  }
}

TEST(RigidDynamics, MixedWithShellsAndDiscsKeepsTheEnergy) {
  System<2> system = warm_shells(9, 3);
  add_disc_body(system, {3.3, 3.4}, 0.2);
  Mover dynamics(shell_field());
  const double dt = default_step(system, dynamics.forces()), before = total_energy(dynamics, system);
  const Vec2 moving = momenta(system).linear;
  for (int k = 0; k < 3000; ++k) dynamics.advance(system, dt);
  EXPECT_NEAR(total_energy(dynamics, system), before, 5e-6 * before);
  EXPECT_LT(norm(momenta(system).linear - moving), 1e-12);
  EXPECT_NE(system.rigid.angle[0], 0);
}

TEST(RigidDynamics, DampingSlowsTranslationAndRotationAlike) {
  System<2> system = colliding_octagons(1);
  system.rigid.velocity[0] = {-0.5, 0};
  system.rigid.spin[0] = 2;
  Mover dynamics(shell_field(), 0.3);
  for (int k = 0; k < 100; ++k) dynamics.advance(system, 0.05);
  EXPECT_NEAR(system.rigid.velocity[0][0], -0.5 * std::exp(-1.5), 1e-13);
  EXPECT_NEAR(system.rigid.spin[0], 2 * std::exp(-1.5), 1e-13);
}

TEST(RigidDynamics, HeldBodiesStayAndOthersGoOnFromTheStateBitForBit) {
  System<2> system = warm_shells(9, 3, 0.3);
  system.state.mobility[system.topology.begin[2] + 1] = Mobility::fixed;
  const Vec2 held_at = system.rigid.centre[1];
  const double held_angle = system.rigid.angle[1];
  Mover dynamics(shell_field());
  const double dt = default_step(system, dynamics.forces());
  for (int k = 0; k < 200; ++k) dynamics.advance(system, dt);
  EXPECT_EQ(system.rigid.centre[1], held_at);
  EXPECT_EQ(system.rigid.angle[1], held_angle);
  System<2> copy = system;
  Mover again(shell_field());
  for (int k = 0; k < 200; ++k) {
    dynamics.advance(system, dt);
    again.advance(copy, dt);
  }
  EXPECT_EQ(system.state.position, copy.state.position);
  EXPECT_EQ(system.state.velocity, copy.state.velocity);
  EXPECT_EQ(system.rigid.angle, copy.rigid.angle);
  EXPECT_EQ(system.rigid.spin, copy.rigid.spin);
}

/// A rigid body is the limit of a stiff one.
TEST(RigidDynamics, IsTheLimitOfStiffShells) {
  const auto turning_after = [](double stiffness) {
    System<2> system = colliding_octagons(0);
    for (ShapeStiffness& k : system.shape.stiffness) k = {stiffness, stiffness, stiffness, 0};
    if (stiffness == 0) make_rigid(system, 0), make_rigid(system, 1);
    Mover dynamics(shell_field());
    while (system.time < 35) dynamics.advance(system, 0.002);
    return angular_momentum(system, 0, 8);
  };
  const double rigid = turning_after(0), stiff = turning_after(1e4), soft = turning_after(1e3);
  EXPECT_NEAR(stiff, rigid, 3e-3 * std::abs(rigid));
  EXPECT_GT(std::abs(soft - rigid), 3 * std::abs(stiff - rigid));
}

}  // namespace
}  // namespace supple
