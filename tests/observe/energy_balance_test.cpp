/// The account of systems simple enough to know every flow.
#include "supple/observe/energy_balance.hpp"

#include <gtest/gtest.h>

#include "supple/solve/mover.hpp"

namespace supple {
namespace {

/// Two discs of unit radius and mass that close at speed 1, in a cell of 50 x 50.
System<2> colliding(double strain_rate = 0) {
  System<2> s;
  s.box.length = {50, 50};
  s.state.resize(2);
  s.state.position = {{20, 20}, {22.1, 20}};
  s.state.velocity = {{0.5, 0}, {-0.5, 0}};
  s.state.radius = s.state.mass = {1, 1};
  s.state.inertia = {0.5, 0.5};
  set_strain_rate(s, strain_rate);
  return s;
}

struct Outcome {
  EnergyFlows flows;
  EnergyState before, after;
  double residual;
};

Outcome run(System<2> s, PairStiffness contact, double friction, double damping, ShearRates rates = {},
            Plates plates = Plates::none) {
  const DiscLaw law{contact, contact, Tensile{}, friction, Slip::clamp, LeverArm::distance};
  Mover dynamics{ForceField<2>(DiscContacts(Divergent(0), law))};
  dynamics.set_plates(plates);
  EnergyBalance<2> balance;
  dynamics.set_account(&balance);
  const Evaluation<2>& now = dynamics.evaluate(s, rates);
  balance.open(s, now);
  const EnergyState before = energy_state(s, now);
  for (int i = 0; i < 1000; ++i) {
    dynamics.evaluate(s, rates);
    dynamics.advance(s, rates, 1e-3, damping);
  }
  dynamics.evaluate(s, rates);
  return {balance.flows(s, now), before, energy_state(s, now), balance.residual(s, now)};
}

TEST(EnergyAccount, ElasticCollisionLosesNothing) {
  const Outcome r = run(colliding(), {100, 0, 0, 0}, 0, 1);
  EXPECT_NEAR(r.before.total(), 0.25, 1e-15);
  EXPECT_NEAR(r.after.kinetic, 0.25, 1e-4);
  EXPECT_EQ(r.flows.work(), 0);
  EXPECT_EQ(r.flows.lost(), 0);
  EXPECT_NEAR(r.residual, 0, 1e-4);
}

TEST(EnergyAccount, DampedCollisionLosesInTheCentralDashpot) {
  const Outcome r = run(colliding(), {100, 4, 0, 0}, 0, 1);
  EXPECT_LT(r.after.kinetic, 0.1);
  EXPECT_NEAR(r.flows.viscous, 0.25 - r.after.total(), 5e-3 * 0.25);
  EXPECT_EQ(r.flows.tangential_viscous + r.flows.sliding + r.flows.background, 0);
}

TEST(EnergyAccount, SpinningDiscsLoseBySliding) {
  System<2> s = colliding();
  s.state.spin = {3, 3};
  const Outcome r = run(s, {100, 0, 80, 0}, 0.1, 1);
  EXPECT_GT(r.flows.sliding, 0.1);
  EXPECT_EQ(r.flows.viscous, 0);
  EXPECT_NEAR(r.flows.lost(), r.before.total() - r.after.total(), 1e-3 * r.flows.lost());
}

TEST(EnergyAccount, DampingTakesWhatTheDiscsLose) {
  System<2> s = colliding();
  s.state.velocity = {{-0.5, 1}, {0.5, 2}};
  const Outcome r = run(s, {100, 0, 0, 0}, 0, 0.999);
  // The half step that is left to the last instant has its damping with the next step.
  EXPECT_NEAR(r.flows.background, r.before.kinetic * (1 - std::pow(0.999, 2 * 999.5)), 1e-12);
  EXPECT_NEAR(r.residual, 0, 1e-14);
}

TEST(EnergyAccount, AChangeOfShearRateDoesWork) {
  System<2> s = colliding();
  s.state.velocity = {{-0.5, 1}, {0.5, 1}};
  const Outcome r = run(s, {100, 0, 0, 0}, 0, 1, {0.01, 0.01});
  // v_x += (20 - 25) 0.01 and spin -= 0.005 on both.
  const double energy = 0.5 * (0.55 * 0.55 + 0.45 * 0.45 - 0.5) + 0.5 * 2 * 0.5 * 0.005 * 0.005;
  EXPECT_NEAR(r.flows.shear_rate, energy, 1e-14);
  EXPECT_NEAR(r.residual, 0, 1e-14);
}

TEST(EnergyAccount, ADiscThatCrossesTheShearedBoundaryTakesItsSpeed) {
  System<2> s = colliding(0.1);
  s.state.position[1] = {30, 49.5};
  s.state.velocity[1] = {3, 1};
  const Outcome r = run(s, {100, 0, 0, 0}, 0, 1, {0.1, 0.1});
  EXPECT_NEAR(r.flows.images, 0.5 * (2 * 2 - 3 * 3), 1e-14);
  EXPECT_NEAR(r.residual, 0, 1e-14);
}

TEST(EnergyAccount, APlateTakesTheEnergyOfADiscThatJoinsIt) {
  System<2> s = colliding();
  s.state.position[0] = {30, 1.5};
  s.state.velocity[0] = {1, -2};
  const Outcome r = run(s, {100, 0, 0, 0}, 0, 1, {}, Plates::capture);
  EXPECT_NEAR(r.flows.plates, -2.5, 1e-14);
  EXPECT_NEAR(r.residual, 0, 1e-14);
}

TEST(EnergyAccount, OpensBetweenTwoSteps) {
  // An account opened while velocities lag behind closes as well as one opened at rest.
  System<2> s = colliding();
  const PairStiffness contact{100, 2, 80, 1};
  Mover dynamics{ForceField<2>(
      DiscContacts(Divergent(0), {contact, contact, Tensile{}, 0.3, Slip::clamp, LeverArm::distance}))};
  s.state.spin = {3, 1};
  EnergyBalance<2> balance;
  dynamics.set_account(&balance);
  for (int i = 0; i < 600; ++i) {
    const Evaluation<2>& now = dynamics.evaluate(s, {});
    if (i == 200) {  // deep in the contact
      EXPECT_GT(now.energy.elastic, 0.01);
      balance.open(s, now);
      EXPECT_EQ(balance.flows(s, now).lost(), 0);
      EXPECT_NEAR(balance.residual(s, now), 0, 1e-15);
    }
    dynamics.advance(s, {}, 1e-3, 1);
  }
  const Evaluation<2>& now = dynamics.evaluate(s, {});
  EXPECT_GT(balance.flows(s, now).lost(), 0.05);
  EXPECT_NEAR(balance.residual(s, now), 0, 0.01 * balance.flows(s, now).lost());
}

}  // namespace
}  // namespace supple
