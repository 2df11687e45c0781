/// Tangential spring and dashpot: stick, the three kinds of slip, and the bond without a limit.
#include "supple/contact/laws/friction.hpp"

#include <gtest/gtest.h>

namespace supple {
namespace {

constexpr double k_t = 50, eta_t = 2, dt = 0.01;

TEST(Friction, BondAddsUpItsElongationWithoutALimit) {
  const TangentialResponse r = bonded(0.3, 2 * dt, 2, k_t, eta_t);
  EXPECT_DOUBLE_EQ(r.elongation, 0.32);
  EXPECT_DOUBLE_EQ(r.force, 50 * 0.32 + 2 * 2);
  EXPECT_EQ(r.state, ContactState::permanent);
}

TEST(Friction, SticksUpToTheLimit) {
  const double force = k_t * 0.32 + eta_t * 2;
  for (const Slip slip : {Slip::clamp, Slip::freeze, Slip::reset}) {
    const TangentialResponse r = coulomb(0.3, 2 * dt, 2, k_t, eta_t, force, {slip, k_t});
    EXPECT_EQ(r.state, ContactState::stick);
    EXPECT_DOUBLE_EQ(r.force, force);
    EXPECT_DOUBLE_EQ(r.elongation, 0.32);
  }
}

TEST(Friction, SlipsAtTheLimitWithTheSignOfTheTrialForce) {
  for (const double sign : {1.0, -1.0})
    for (const Slip slip : {Slip::clamp, Slip::freeze, Slip::reset}) {
      const TangentialResponse r = coulomb(sign * 0.3, sign * 2 * dt, sign * 2, k_t, eta_t, 5, {slip, k_t});
      EXPECT_EQ(r.state, ContactState::slip);
      EXPECT_DOUBLE_EQ(r.force, sign * 5);
      const double held = slip == Slip::clamp ? (5 - eta_t * 2) / k_t : slip == Slip::freeze ? 0.3 : 0;
      EXPECT_DOUBLE_EQ(r.elongation, sign * held);
    }
}

TEST(Friction, WithoutFrictionNothingIsHeld) {
  const TangentialResponse r = coulomb(0, 2 * dt, 2, k_t, 0, 0, {Slip::clamp, k_t});
  EXPECT_EQ(r.force, 0);
  EXPECT_EQ(r.elongation, 0);
  const TangentialResponse at_rest = coulomb(0, 0, 0, k_t, eta_t, 0, {Slip::clamp, k_t});
  EXPECT_EQ(at_rest.force, 0);
  EXPECT_EQ(at_rest.state, ContactState::stick);
}

TEST(Friction, AnEvaluationWithoutTimeLeavesTheElongation) {
  EXPECT_DOUBLE_EQ(coulomb(0.3, 0, 2, k_t, eta_t, 1e3, {Slip::clamp, k_t}).elongation, 0.3);
}

}  // namespace
}  // namespace supple
