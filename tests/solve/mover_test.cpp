#include "supple/solve/mover.hpp"

#include <gtest/gtest.h>

#include "tests/support/suspension.hpp"

namespace supple {
namespace {

DiscLaw law(double friction) {
  const PairStiffness s{100, 0.5, 80, 0.4};
  return {s, s, Tensile{}, friction, Slip::clamp, LeverArm::distance};
}

Mover<2> dynamics(double friction = 0.3) {
  return Mover(ForceField<2>(DiscContacts(Divergent(1), law(friction))));
}

void run(System<2>& s, Mover<2>& d, int steps, double rate = 0.3, double dt = 1e-3) {
  for (int i = 0; i < steps; ++i) {
    d.evaluate(s, {rate, rate});
    d.advance(s, {rate, rate}, dt, 0.999);
  }
}

void expect_same_bits(const System<2>& a, const System<2>& b) {
  EXPECT_EQ(a.state.position, b.state.position);
  EXPECT_EQ(a.state.velocity, b.state.velocity);
  EXPECT_EQ(a.state.spin, b.state.spin);
  EXPECT_EQ(a.box.strain, b.box.strain);
}

TEST(Mover, GivesTheSameBitsForOneAndTwoThreads) {
  System<2> one = testing::random_suspension(1500, 0.9), two = one;
  Mover a = dynamics(), b = dynamics();
  run(one, a, 60);
  thread_count() = 2;
  run(two, b, 60);
  thread_count() = 1;
  expect_same_bits(one, two);
}

TEST(Mover, ContinuesFromItsStateBitForBitWheneverTheListIsBuilt) {
  System<2> whole = testing::random_suspension(200, 0.9);
  System<2> split = whole;
  Mover a = dynamics(), b = dynamics();
  run(whole, a, 100);
  run(split, b, 37);
  Mover c = dynamics();  // a fresh list, built at another instant
  run(split, c, 63);
  expect_same_bits(whole, split);
}

TEST(Mover, PassesTheSpeedOfTwoDiscsOnInACentralCollision) {
  System<2> s;
  s.box.length = {50, 50};
  s.state.resize(2);
  s.state.position = {{10, 20}, {12.5, 20}};
  s.state.velocity = {{1, 0}, {0, 0}};
  s.state.radius = {1, 1};
  s.state.mass = {1, 1};
  s.state.inertia = {0.5, 0.5};
  DiscLaw elastic = law(0);
  elastic.contact.eta = elastic.contact.eta_t = 0;
  Mover d{ForceField<2>(DiscContacts(Divergent(0), elastic))};
  for (int i = 0; i < 3000; ++i) {
    d.evaluate(s, {});
    d.advance(s, {}, 1e-3, 1);
  }
  EXPECT_NEAR(s.state.velocity[0][0], 0, 1e-4);
  EXPECT_NEAR(s.state.velocity[1][0], 1, 1e-4);
}

TEST(Mover, NamesStepAndDiscWhenAValueIsNotFinite) {
  System<2> s = testing::random_suspension(20, 0.01);  // so dilute that it cannot spoil a neighbour
  Mover d = dynamics();
  run(s, d, 3);
  s.state.velocity[7][0] = std::nan("");
  try {
    run(s, d, 1);
    FAIL();
  } catch (const std::exception& e) {
    EXPECT_NE(std::string(e.what()).find("site 7 is not finite at step 4"), std::string::npos) << e.what();
  }
}

/// The image that a link keeps counts cells in 32 bits, and a coordinate in 53.
TEST(Mover, ADiscThatLeavesAMillionCellsBehindEndsTheRun) {
  for (const double speed : {1e12, 1e40, -1e300}) {
    System<2> s = testing::random_suspension(20, 0.01);
    Mover d = dynamics();
    run(s, d, 3);
    s.state.velocity[7][0] = speed;
    try {
      run(s, d, 1);
      FAIL() << speed;
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::numerics);
      EXPECT_NE(std::string(e.what()).find("site 7 left a million cells behind"), std::string::npos)
          << e.what();
    }
  }
}

TEST(Mover, DiscsThatReachAPlateStayOnIt) {
  System<2> s = testing::random_suspension(50, 0.9);
  Mover d = dynamics();
  d.set_plates(Plates::capture);
  run(s, d, 200);
  int captured = 0;
  for (int i = 0; i < 50; ++i) {
    if (s.state.mobility[i] == Mobility::free) continue;
    ++captured;
    const double speed =
        s.state.mobility[i] == Mobility::upper_plate ? 1.2 : -1.2;  // rate Ly/2 = 0.3 * 8 / 2
    EXPECT_NEAR(s.state.velocity[i][0], speed, 1e-14);
    EXPECT_EQ(s.state.velocity[i][1], 0);
  }
  EXPECT_GT(captured, 3);
}

}  // namespace
}  // namespace supple
