/// A crosslinked cluster that rotates as a whole winds up nothing: the tangential springs see only the motion
/// within.
#include <gtest/gtest.h>

#include <numbers>

#include "supple/observe/summary.hpp"
#include "supple/solve/mover.hpp"

namespace supple {
namespace {

constexpr double dt = 1e-3, spin = 2 * std::numbers::pi / 10;  // a turn takes 10

Mover<2> dynamics(LeverArm arm) {
  const PairStiffness s{100, 0.5, 80, 0.4};
  return Mover(ForceField<2>(DiscContacts(Divergent(1), {s, s, Tensile{}, 0.3, Slip::clamp, arm})));
}

void run(System<2>& s, Mover<2>& d, int steps, double damping = 1) {
  for (int i = 0; i < steps; ++i) {
    d.evaluate(s, {});
    d.advance(s, {}, dt, damping);
  }
}

/// A large disc amid six of two sizes, all neighbours linked, some compressed and some stretched, at rest.
System<2> cluster(Mover<2>& d) {
  System<2> s;
  s.box.length = {50, 50};
  s.state.resize(7);
  for (int i = 0; i < 7; ++i) {
    const double angle = i * std::numbers::pi / 3, away = i == 6 ? 0 : i % 3 ? 2.1 : 1.8;
    s.state.position[i] = Vec2{25, 25} + away * Vec2{std::cos(angle), std::sin(angle)};
    s.state.radius[i] = i == 6 ? 1.2 : i % 2 ? 1 : 0.8;
    s.state.mass[i] = s.state.radius[i] * s.state.radius[i];
    s.state.inertia[i] = 0.5 * s.state.mass[i] * s.state.mass[i];
  }
  for (int i = 0; i < 6; ++i) {
    set_pair_state(s.pairs, 7, std::min(i, (i + 1) % 6), std::max(i, (i + 1) % 6), ContactState::permanent);
    set_pair_state(s.pairs, 7, i, 6, ContactState::permanent);
  }
  d.invalidate();
  run(s, d, 20000, 0.99);
  return s;
}

/// Gives every disc the velocity of a rigid rotation about the centre of mass.
void rotate(System<2>& s) {
  Vec2 centre{};
  double mass = 0;
  for (int i = 0; i < 7; ++i) {
    centre += s.state.mass[i] * s.state.position[i];
    mass += s.state.mass[i];
  }
  for (int i = 0; i < 7; ++i) {
    s.state.velocity[i] = spin * turned_left(s.state.position[i] - (1 / mass) * centre);
    s.state.spin[i] = spin;
  }
}

/// Largest change of a link's elongation over a whole turn, the stretch by the rotation having settled
/// before.
double wound_up_in_a_turn(LeverArm arm) {
  Mover d = dynamics(arm);
  System<2> s = cluster(d);
  rotate(s);
  run(s, d, 10000);
  const std::vector<double> before = s.pairs.history;
  run(s, d, 10000);
  double largest = 0;
  for (std::size_t row = 0; row < before.size(); ++row) {
    EXPECT_EQ(s.pairs.state[row], ContactState::permanent);
    largest = std::max(largest, std::abs(s.pairs.history[row] - before[row]));
  }
  return largest;
}

TEST(RotatingCluster, WindsUpNothing) {
  EXPECT_LT(wound_up_in_a_turn(LeverArm::distance), 1e-5);
  // The published package's arms, which hold for discs that just touch only, wind the links up.
  EXPECT_GT(wound_up_in_a_turn(LeverArm::radius), 1e-2);
}

TEST(RotatingCluster, KeepsRotating) {
  Mover d = dynamics(LeverArm::distance);
  System<2> s = cluster(d);
  rotate(s);
  run(s, d, 10000);
  const double before = momenta(s, d.evaluate(s, {})).angular,
               energy = kinetic_energy(s, d.evaluate(s, {})).total();
  run(s, d, 10000);
  EXPECT_NEAR(momenta(s, d.evaluate(s, {})).angular, before, 1e-12 * before);
  EXPECT_NEAR(kinetic_energy(s, d.evaluate(s, {})).total(), energy, 1e-5 * energy);
  for (int i = 0; i < 7; ++i) EXPECT_NEAR(s.state.spin[i], spin, 0.01 * spin);
}

TEST(RotatingCluster, RotationIsNoSlidingAtAnyDistance) {
  // At one instant, of links at rest length, compressed to half and stretched to twice the sum of radii.
  for (const double distance : {1.8, 0.9, 3.6}) {
    System<2> s;
    s.box.length = {50, 50};
    s.state.resize(2);
    s.state.position = {{20, 20}, {20 + 0.6 * distance, 20 + 0.8 * distance}};
    s.state.velocity = {{1, 2}, Vec2{1, 2} + spin * turned_left(s.state.position[1] - s.state.position[0])};
    s.state.spin = {spin, spin};
    s.state.radius = {0.8, 1};
    s.state.mass = s.state.inertia = {1, 1};
    set_pair_state(s.pairs, 2, 0, 1, ContactState::permanent);
    Mover d = dynamics(LeverArm::distance);
    d.invalidate();
    EXPECT_NEAR(d.evaluate(s, {}).pair[0].tangential, 0, 1e-14) << distance;
  }
}

}  // namespace
}  // namespace supple
