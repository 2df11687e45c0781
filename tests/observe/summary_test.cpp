#include "supple/observe/summary.hpp"

#include <gtest/gtest.h>

namespace supple {
namespace {

System<2> two_discs() {
  System<2> s;
  s.box.length = {10, 20};
  s.state.resize(2);
  s.state.position = {{2, 3}, {5, 16}};
  s.state.velocity = {{1, -2}, {0.5, 4}};
  s.state.mass = {2, 3};
  s.state.radius = {1, 2};
  s.state.inertia = {1, 6};
  s.state.spin = {0.5, -1};
  return s;
}
Evaluation<2> no_forces() {
  Evaluation<2> e;
  e.force.resize(2);
  e.torque.resize(2);
  return e;
}

TEST(Summary, MomentaAboutTheCorner) {
  const Momenta m = momenta(two_discs(), no_forces());
  EXPECT_EQ(m.linear, (Vec2{2 * 1 + 3 * 0.5, 2 * -2 + 3 * 4}));
  EXPECT_EQ(m.angular, 2 * (2 * -2 - 3 * 1) + 3 * (5 * 4 - 16 * 0.5) + 1 * 0.5 - 6 * 1);
}

TEST(Summary, KineticEnergyIsThatOfFreeDiscsAndOfAllSpins) {
  System<2> s = two_discs();
  s.box.strain_rate = 0.5;  // the flow at the second disc: 3
  s.state.mobility[0] = Mobility::lower_plate;
  const KineticEnergy e = kinetic_energy(s, no_forces());
  EXPECT_EQ(e.translation, 1.5 * (0.25 + 16));
  EXPECT_EQ(e.peculiar, 1.5 * (6.25 + 16));
  EXPECT_EQ(e.spin, 0.5 * 0.25 + 3);
  EXPECT_EQ(e.total(), e.translation + e.spin);
}

TEST(Summary, VelocitiesAreThoseOfTheInstantOfTheForces) {
  System<2> s = two_discs();
  s.lag = 0.1;
  s.state.mobility[0] = Mobility::upper_plate;
  Evaluation<2> e = no_forces();
  e.force = {{6, 6}, {6, 12}};
  e.torque = {2, 12};
  EXPECT_EQ(synchronised_velocity(s, e, 0), (Vec2{1, -2}));
  EXPECT_NEAR(synchronised_velocity(s, e, 1)[0], 0.5 + 0.05 * 2, 1e-15);
  EXPECT_NEAR(synchronised_velocity(s, e, 1)[1], 4 + 0.05 * 4, 1e-15);
  EXPECT_NEAR(synchronised_spin(s, e, 0), 0.5 + 0.05 * 2, 1e-15);
  EXPECT_NEAR(synchronised_spin(s, e, 1), -1 + 0.05 * 2, 1e-15);
}

TEST(Summary, CountsActiveContactsByState) {
  System<2> s = two_discs();
  Evaluation<2> e;
  e.pair.resize(6);
  using enum ContactState;
  e.trial_state = {stick, slip, permanent, permanent, stick, open};
  for (const int row : {0, 1, 2, 3}) e.pair[row].active = true;
  const ContactCounts counts = contact_counts(e);
  EXPECT_EQ(counts.stick, 1);
  EXPECT_EQ(counts.slip, 1);
  EXPECT_EQ(counts.links, 2);
  EXPECT_EQ(coordination(s, e), 4);
  EXPECT_EQ(coordination(System<2>{}, e), 0);
}

TEST(Summary, PackingFraction) {
  EXPECT_NEAR(packing_fraction(two_discs()), 3.14159265358979 * 5 / 200, 1e-14);
}

}  // namespace
}  // namespace supple
