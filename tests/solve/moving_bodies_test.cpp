#include "supple/solve/mover.hpp"
#include "supple/solve/time_step.hpp"

#include <gtest/gtest.h>

#include "supple/contact/rough_contacts.hpp"
#include "supple/core/error.hpp"
#include "supple/solve/degrees.hpp"
#include "tests/support/moving_bodies.hpp"
#include "tests/support/polygons.hpp"

namespace supple {
namespace {

using testing::heat;
using testing::largest;
using testing::shell_field;
using testing::total_energy;
using testing::warm_shells;

TEST(MovingBodies, KeepsTheEnergyAtTheDefaultStep) {
  System<2> system = warm_shells(4);
  Mover dynamics(shell_field());
  const double dt = default_step(system, dynamics.forces()), before = total_energy(dynamics, system);
  double first = 0, last = 0;
  const int steps = 20000;
  for (int k = 0; k < steps; ++k) {
    dynamics.advance(system, dt);
    if (k % 10) continue;
    const double change = (total_energy(dynamics, system) / before - 1) / (steps / 40);
    if (k < steps / 4) first += change;
    if (k >= steps - steps / 4) last += change;
  }
  EXPECT_LT(std::abs(last - first), 5e-6);
  EXPECT_EQ(system.step, steps);
  EXPECT_NEAR(system.time, steps * dt, 1e-9 * system.time);
}

TEST(MovingBodies, EnergyFluctuatesBySecondOrderOfTheStep) {
  const System<2> start = warm_shells(4);
  const auto fluctuation = [&](double dt, int steps) {
    System<2> system = start;
    Mover dynamics(shell_field());
    double sum = 0, squares = 0;
    const double before = total_energy(dynamics, system);
    for (int k = 0; k < steps; ++k) {
      dynamics.advance(system, dt);
      const double change = total_energy(dynamics, system) - before;
      sum += change;
      squares += change * change;
    }
    return std::sqrt(squares / steps - sum / steps * (sum / steps));
  };
  const double coarse = fluctuation(4e-3, 500), fine = fluctuation(2e-3, 1000),
               finer = fluctuation(1e-3, 2000);
  EXPECT_NEAR(coarse / fine, 4, 0.15 * 4);
  EXPECT_NEAR(fine / finer, 4, 0.15 * 4);
}

TEST(MovingBodies, KeepsTheMomentum) {
  System<2> system = warm_shells(9);
  Mover dynamics(shell_field());
  const Vec2 before = momenta(system).linear;
  const double dt = default_step(system, dynamics.forces());
  for (int k = 0; k < 1000; ++k) dynamics.advance(system, dt);
  EXPECT_LT(norm(momenta(system).linear - before), 1e-12) << "of 100 sites of mass 1 and speed 0.1";
}

TEST(MovingBodies, RunsBackwards) {
  System<2> system = warm_shells(4);
  Mover dynamics(shell_field());
  const std::vector<Vec2> before = system.state.position;
  const double dt = default_step(system, dynamics.forces());
  for (int k = 0; k < 500; ++k) dynamics.advance(system, dt);
  EXPECT_GT(largest(before, system.state.position), 0.1);
  for (Vec2& v : system.state.velocity) v = -v;
  for (int k = 0; k < 500; ++k) dynamics.advance(system, dt);
  EXPECT_LT(largest(before, system.state.position), 1e-11);
}

TEST(MovingBodies, DampedComesToRestInAMinimum) {
  System<2> system = warm_shells(4);
  Mover dynamics(shell_field(), 0.5);
  const double dt = default_step(system, dynamics.forces(), 0.3);
  double before = total_energy(dynamics, system);
  for (int block = 0; block < 200; ++block) {
    for (int k = 0; k < 50; ++k) dynamics.advance(system, dt);
    const double now = total_energy(dynamics, system);
    EXPECT_LE(now, before * (1 + 1e-14));
    before = now;
  }
  EXPECT_LT(kinetic_energy(system).total(), 1e-12);
  EXPECT_LT(largest(dynamics.evaluate(system).force, std::vector<Vec2>(system.state.position.size())), 1e-6);
  EXPECT_GT(before, 1e-3) << "they still touch";
}

/// v = v0 exp(-b t) + g (1 - exp(-b t))/b; splitting leaves g b dt^2/12 of the drift.
TEST(MovingBodies, FallsLikeABodyThatFalls) {
  System<2> system;
  system.box = {.length = {10, 10}, .periodic = {false, false}};
  add_disc_body(system, {5, 9}, 0.3);
  system.state.velocity[0] = {1, 2};
  ForceField<2> field = shell_field();
  field.external().gravity = {0, -3};
  Mover dynamics(std::move(field));
  const System<2> start = system;
  for (int k = 0; k < 100; ++k) dynamics.advance(system, 0.02);
  EXPECT_NEAR(system.state.position[0][0], 5 + 2, 1e-13);
  EXPECT_NEAR(system.state.position[0][1], 9 + 2 * 2 - 0.5 * 3 * 4, 1e-13);
  EXPECT_NEAR(system.state.velocity[0][1], 2 - 3 * 2, 1e-13);

  system = start;
  const double b = 0.7, decay = std::exp(-b * 2);
  dynamics.set_drag(b);
  dynamics.invalidate();
  for (int k = 0; k < 1000; ++k) dynamics.advance(system, 0.002);
  EXPECT_NEAR(system.state.velocity[0][0], decay, 1e-12);
  EXPECT_NEAR(system.state.velocity[0][1], 2 * decay - 3 * (1 - decay) / b, 1e-6);
}

TEST(MovingBodies, BouncesFromWallsAndLeavesFixedSitesInPlace) {
  System<2> system = warm_shells(4);
  system.box.periodic = {false, false};
  system.box.length = {10, 10};
  system.box.strain = 0;
  for (Vec2& x : system.state.position) x += Vec2{2.5, 2};
  heat(system, 0.3);
  system.state.mobility[3] = Mobility::fixed;
  const Vec2 pinned = system.state.position[3];
  ForceField<2> field = shell_field();
  field.set_walls({});
  Mover dynamics(std::move(field));
  const double dt = default_step(system, dynamics.forces(), 0.1);
  dynamics.advance(system, dt);
  const double before = total_energy(dynamics, system);
  double pushed = 0;
  for (int k = 0; k < 5000; ++k) {
    dynamics.advance(system, dt);
    pushed = std::max(pushed, dynamics.evaluate_energies(system).energy.wall);
  }
  EXPECT_GT(pushed, 0.01);
  EXPECT_NEAR(total_energy(dynamics, system), before, 1e-3 * before);
  EXPECT_EQ(system.state.position[3], pinned);
  EXPECT_EQ(system.state.velocity[3], Vec2{});
}

/// Sliding on a floor with friction, with memory where sites stick: the state alone is enough to go on.
TEST(MovingBodies, GoesOnFromTheStateBitForBit) {
  const auto field = [] {
    ForceField<2> forces = shell_field();
    forces.external().gravity = {0.3, -1};
    forces.set_walls({.floor_friction = 0.3});
    return forces;
  };
  System<2> system = warm_shells(9);  // of four, one gets as long as the cell and is refused
  system.box.periodic[gradient] = false;
  system.box.strain = 0;
  for (Vec2& x : system.state.position) x += Vec2{0, 1.5};
  Mover dynamics(field(), 0.1);
  for (int k = 0; k < 700; ++k) dynamics.advance(system, 0.01);
  ASSERT_FALSE(system.floor_contact.empty());
  System<2> copy = system;
  copy.pairs = {};  // another neighbour list, built at another time
  copy.pairs.width = 0;
  Mover again(field(), 0.1);
  for (int k = 0; k < 300; ++k) {
    dynamics.advance(system, 0.01);
    again.advance(copy, 0.01);
    if (k % 7 == 0) again.evaluate_energies(copy);
  }
  EXPECT_EQ(system.state.position, copy.state.position);
  EXPECT_EQ(system.state.velocity, copy.state.velocity);
  EXPECT_EQ(system.lag, 0);
}

/// Of any bodies; and a step between velocities of one instant first completes those that lag.
TEST(MovingBodies, ALeapfrogCompletedByHalfAKickIsVelocityVerlet) {
  System<2> lagging = testing::warm_shells(9, 3), whole = lagging;
  Mover leapfrog(shell_field()), verlet(shell_field());
  const double dt = default_step(whole, verlet.forces());
  for (int k = 0; k < 100; ++k) {
    leapfrog.evaluate(lagging);
    leapfrog.advance(lagging, {}, dt, 1);
    verlet.advance(whole, dt);
  }
  ASSERT_EQ(lagging.lag, dt);
  ASSERT_EQ(whole.lag, 0);
  const auto apart = [&](const std::vector<Vec2>& velocity) {  // one wraps, the other does not
    double most = 0;
    for (int i = 0; i < whole.state.size(); ++i)
      most = std::max({most, norm(velocity[i] - whole.state.velocity[i]),
                       norm(whole.box.displacement(whole.state.position[i], lagging.state.position[i]))});
    return most;
  };
  EXPECT_GT(apart(lagging.state.velocity), 1e-6);
  std::vector<Vec2> velocity;
  std::vector<double> spin;
  leapfrog.evaluate(lagging);
  leapfrog.bring_to_instant(lagging, 0, velocity, spin);
  EXPECT_LT(apart(velocity), 1e-13);
  leapfrog.advance(lagging, dt);
  verlet.advance(whole, dt);
  EXPECT_LT(apart(lagging.state.velocity), 1e-13);
}

TEST(MovingBodies, FrequencyBoundIsCloseToTheStiffestFrequency) {
  System<2> system = warm_shells(4);
  system.state.mass[5] = 0.2;
  ForceField<2> field = shell_field();
  const BodyDegrees<2> degrees(system);
  HessianBlocks<2> blocks;
  field.add_hessian(system, blocks);
  const std::vector<double> mass = degrees.masses(system);
  const std::vector<MatrixEntry> entries = degrees.hessian(system, blocks, system.state.velocity);
  std::vector<double> x(mass.size()), y(mass.size());
  for (std::size_t k = 0; k < x.size(); ++k) x[k] = std::sin(1.0 + static_cast<double>(k));
  double square = 0;
  for (int iteration = 0; iteration < 3000; ++iteration) {
    std::fill(y.begin(), y.end(), 0.0);
    for (const MatrixEntry& e : entries) {
      const double value = e.value() / std::sqrt(mass[e.row()] * mass[e.col()]);
      y[e.row()] += value * x[e.col()];
      if (e.row() != e.col()) y[e.col()] += value * x[e.row()];
    }
    square = 0;
    for (double v : y) square += v * v;
    square = std::sqrt(square);
    for (std::size_t k = 0; k < x.size(); ++k) x[k] = y[k] / square;
  }
  double spring = 0;  // of further contacts
  for (int i = 0; i < system.state.size(); ++i)
    spring =
        std::max(spring, 6 / (4 * system.state.radius[i] * system.state.radius[i] * system.state.mass[i]));
  const double bound = frequency_bound(system, field);
  EXPECT_GE(bound * bound, square + spring);
  EXPECT_LE(bound * bound, 1.25 * square + spring);
  EXPECT_DOUBLE_EQ(default_step(system, field, 0.5), 1 / bound);
}

TEST(MovingBodies, RefusesWhatItCannotDo) {
  EXPECT_THROW(Mover(shell_field(), -1), Error);
  EXPECT_THROW(Mover(shell_field(), std::nan("")), Error);
  System<2> system = warm_shells(4);
  Mover dynamics(shell_field());
  system.state.velocity[7] = {1e308, 0};
  try {
    dynamics.advance(system, 10);
    FAIL() << "a position that is not finite";
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::numerics);
    EXPECT_NE(std::string(e.what()).find("site 7"), std::string::npos) << e.what();
  }
  system = warm_shells(4);
  system.box.strain_rate = 0.1;
  EXPECT_THROW(dynamics.advance(system, 0.01), Error);
  System<2> alone;
  alone.box.length = {10, 10};
  EXPECT_THROW(default_step(alone, dynamics.forces()), Error);
}

}  // namespace
}  // namespace supple
