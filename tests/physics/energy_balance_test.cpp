/// Energy over a cycle of shear: work of plates, images and rate changes = change of energy + losses by
/// channel.
#include "supple/observe/energy_balance.hpp"

#include <gtest/gtest.h>

#include "tests/support/prepared.hpp"

namespace supple {
namespace {

/// 45 discs with friction 0.3, so that every channel takes part.
Case frictional(const char* plates, bool links) {
  Case c;
  c.particles.discs = 45;
  c.particles.permanent_links = links;
  c.box.plates = plates;
  c.material.friction = 0.3;
  return c;
}

struct Account {
  EnergyFlows flows;
  double change = 0, residual = 0;
};

/// One cycle of 20 % strain in so many steps, from this state.
Account shear_one_cycle(System<2> system, const Case& c, int steps) {
  const std::unique_ptr<Mover<2>> dynamics = testing::documented_dynamics(c);
  const OscillatoryProtocol protocol = testing::one_cycle(c, steps);
  EnergyBalance<2> balance;
  dynamics->set_account(&balance);
  const Evaluation<2>& now = dynamics->evaluate(system, {});
  balance.open(system, now);
  const double before = energy_state(system, now).total();
  for (int i = 0; i < steps; ++i) {
    dynamics->evaluate(system, protocol.rates(i));
    dynamics->advance(system, protocol.rates(i), protocol.time_step(), testing::damping(c, steps));
  }
  dynamics->evaluate(system, {});
  return {balance.flows(system, now), energy_state(system, now).total() - before,
          balance.residual(system, now)};
}

void expect_closed(const Case& c) {
  const Suspension s = testing::prepared_suspension(c);
  for (const int steps : {560, 1120, 2240, 4480}) {
    const Account a = shear_one_cycle(s.system, c, steps);
    EXPECT_LT(std::abs(a.residual), 2e-6 * 560 / steps * a.flows.work()) << steps << " steps";
    EXPECT_NEAR(a.residual, a.change + a.flows.lost() - a.flows.work(), 1e-12 * a.flows.work());
  }
}

TEST(EnergyBalance, ClosesOverACycleBetweenPlatesWithLinks) { expect_closed(frictional("capture", true)); }
TEST(EnergyBalance, ClosesOverACycleOfAPlainLeesEdwardsCell) { expect_closed(frictional("none", true)); }
TEST(EnergyBalance, ClosesOverACycleBetweenRepulsivePlates) { expect_closed(frictional("repulsive", false)); }

TEST(EnergyBalance, EveryChannelTakesPart) {
  const Case c = frictional("capture", false);
  const Account a = shear_one_cycle(testing::prepared_suspension(c).system, c, 1120);
  const EnergyFlows& f = a.flows;
  for (const double part :
       {f.plates, f.images, f.shear_rate, f.viscous, f.tangential_viscous, f.sliding, f.background, a.change})
    EXPECT_GT(std::abs(part), 5e-3 * f.work());
  for (const double loss : {f.viscous, f.tangential_viscous, f.sliding}) EXPECT_GT(loss, 0);
}

}  // namespace
}  // namespace supple
