/// What the account of energy hands over, in J/m whatever the run's units are, and what goes on from it.
#include <gtest/gtest.h>

#include <cmath>

#include "supple/core/error.hpp"
#include "supple/experiment/energy_table.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/experiment/suspension.hpp"
#include "supple/solve/mover.hpp"
#include "tests/support/prepared.hpp"

namespace supple {
namespace {

/// Units of which none is 1: energies count in 1e-9 (1e-6 / 1e-3)^2 J/m.
const Units small_units{"um, ug, ms", 1e-6, 1e-9, 1e-3};
constexpr double joule_per_metre = 1e-15;
constexpr double stiffness = 100, overlap = 0.1, factor = 0.99;
constexpr int steps = 100;

/// Two discs that fly and spin freely, slowed down by `factor` a step, and two fixed ones that overlap.
Suspension free_discs() {
  const PairStiffness contact{stiffness, 0, 0, 0};
  const DiscLaw law{contact, contact, Tensile{}, 0, Slip::clamp, LeverArm::distance};
  Suspension s;
  s.units = small_units;
  s.time_step = 1e-3;
  s.damping = factor;
  s.stepper = std::make_unique<Mover<2>>(ForceField<2>(DiscContacts(Divergent(0), law)));
  s.system.box.length = {50, 50};
  State<2>& state = s.system.state;
  state.resize(4);
  state.position = {{10, 10}, {20, 10}, {30, 30}, {32 - overlap, 30}};
  state.velocity = {{3, 4}, {-5, 12}, {}, {}};
  state.spin = {2, 0.5, 0, 0};
  state.radius = {1, 1, 1, 1};
  state.mass = {2, 3, 1, 1};
  state.inertia = {0.5, 8, 1, 1};
  state.mobility = {Mobility::free, Mobility::free, Mobility::fixed, Mobility::fixed};
  return s;
}

/// (2 5^2 + 3 13^2)/2, (0.5 2^2 + 8 0.5^2)/2 and k overlap^2/2.
constexpr double translation = 278.5, spin = 2, elastic = 0.5 * stiffness * overlap * overlap;

void record_steps(EnergyTable& table, Suspension& s) {
  for (int i = 0; i < steps; ++i) {
    table.append(s.system, s.stepper->evaluate(s.system, {}));
    s.stepper->advance(s.system, {}, s.time_step, s.damping);
  }
  table.append(s.system, s.stepper->evaluate(s.system, {}));
  table.finish();
}

void expect_last(const MemoryRecorder& r, const char* column, double expected) {
  EXPECT_NEAR(r.tables.at("energy").column(column).back(), expected, 1e-12 * expected) << column;
}

TEST(EnergyAccountOfARun, IsInJoulePerMetreWhateverTheUnits) {
  MemoryRecorder r;
  Suspension s = free_discs();
  EnergyTable table(r, *s.stepper, s.system, s.units, Case{}, nullptr);
  record_steps(table, s);
  const MemoryRecorder::Table& rows = r.tables.at("energy");
  EXPECT_NEAR(rows.column("kinetic").front(), joule_per_metre * translation, 1e-12 * joule_per_metre);
  EXPECT_NEAR(rows.column("spin").front(), joule_per_metre * spin, 1e-12 * joule_per_metre);
  EXPECT_EQ(rows.column("lost_background").front(), 0);
  // The last instant has been damped over half a step less: its own damping comes with the next step.
  const double left = std::pow(factor, 2 * steps - 1);
  expect_last(r, "t", 1e-3 * steps * s.time_step);
  expect_last(r, "kinetic", joule_per_metre * translation * left);
  expect_last(r, "spin", joule_per_metre * spin * left);
  expect_last(r, "elastic", joule_per_metre * elastic);
  expect_last(r, "total", joule_per_metre * ((translation + spin) * left + elastic));
  expect_last(r, "lost_background", joule_per_metre * (translation + spin) * (1 - left));
  EXPECT_NEAR(rows.column("residual").back(), 0, 1e-12 * joule_per_metre * translation);
  EXPECT_NEAR(r.get(protocol_group, "account_opening"), joule_per_metre * (translation + spin + elastic),
              1e-12 * joule_per_metre * translation);
  EXPECT_NEAR(r.get(protocol_group, "account_lost_background"),
              joule_per_metre * (translation + spin) * (1 - left), 1e-12 * joule_per_metre * translation);
}

TEST(EnergyAccountOfARun, GoesOnFromJoulePerMetreWhateverTheUnits) {
  MemoryRecorder first;
  Suspension s = free_discs();
  {
    EnergyTable table(first, *s.stepper, s.system, s.units, Case{}, nullptr);
    record_steps(table, s);
  }
  InitialState initial;
  for (const std::string& name : account_numbers()) initial.protocol[name] = first.get(protocol_group, name);
  Case c;
  c.initial.keep_time = true;
  MemoryRecorder second;
  EnergyTable table(second, *s.stepper, s.system, s.units, c, &initial);
  record_steps(table, s);
  const double left = std::pow(factor, 4 * steps - 1);
  EXPECT_NEAR(second.tables.at("energy").column("lost_background").front(),
              first.tables.at("energy").column("lost_background").back(), 1e-12 * joule_per_metre);
  expect_last(second, "lost_background", joule_per_metre * (translation + spin) * (1 - left));
  EXPECT_NEAR(second.tables.at("energy").column("residual").back(), 0, 1e-12 * joule_per_metre * translation);
}

/// One cycle of 20 % strain of discs with links and friction, so that every channel takes part. It ends while
/// the plates move.
Case oscillation() {
  Case c;
  c.particles.discs = 45;
  c.material.friction = 0.3;
  c.shear.pre_periods = c.shear.post_periods = 0;
  c.shear.periods = 1;
  c.output.energies = true;
  return c;
}

/// Energy of the final state - energy at the opening = work - losses, all of them as handed over for a
/// continuation: to 1e-3 of the work, as tests/physics/energy_balance_test.cpp.
void expect_closed(const MemoryRecorder& r) {
  const auto kept = [&](const std::string& name) { return r.get(protocol_group, "account_" + name); };
  EnergyFlows booked;
  booked.plates = kept("work_plates");
  booked.images = kept("work_images");
  booked.shear_rate = kept("work_shear_rate");
  booked.viscous = kept("lost_viscous");
  booked.tangential_viscous = kept("lost_tangential");
  booked.sliding = kept("lost_sliding");
  booked.background = kept("lost_background");
  const double opening = kept("opening"), work = booked.work();
  ASSERT_GT(work, 0);
  const MemoryRecorder::Table& rows = r.tables.at("energy");
  EXPECT_EQ(opening, rows.column("total").front());
  EnergyBalance<2> account;
  account.resume(r.last_system, opening, booked);
  const std::unique_ptr<Mover<2>> dynamics = testing::documented_dynamics(oscillation());
  dynamics->set_account(&account);
  System<2> again = r.last_system;
  // What the forces of this instant lose, at the rate that its step had or would have had.
  const auto per_period = static_cast<int>(std::lround(r.get("constants", "steps_per_period")));
  dynamics->evaluate(again, testing::one_cycle(oscillation(), per_period).rates(again.step));
  const EnergyState now = energy_state(r.last_system, r.last_evaluation);
  const EnergyFlows flows = account.flows(r.last_system, r.last_evaluation);
  EXPECT_NEAR(now.total() - opening, flows.work() - flows.lost(), 1e-3 * work);
  // The last row is of the same instant.
  const double rounding = 1e-12 * work;
  EXPECT_NEAR(now.total(), rows.column("total").back(), rounding);
  EXPECT_NEAR(flows.plates, rows.column("work_plates").back(), rounding);
  EXPECT_NEAR(flows.images, rows.column("work_images").back(), rounding);
  EXPECT_NEAR(flows.shear_rate, rows.column("work_shear_rate").back(), rounding);
  EXPECT_NEAR(flows.viscous, rows.column("lost_viscous").back(), rounding);
  EXPECT_NEAR(flows.tangential_viscous, rows.column("lost_tangential").back(), rounding);
  EXPECT_NEAR(flows.sliding, rows.column("lost_sliding").back(), rounding);
  EXPECT_NEAR(flows.background, rows.column("lost_background").back(), rounding);
}

TEST(EnergyAccountOfARun, ClosesAtTheEndOfAnOscillation) {
  MemoryRecorder r;
  run(oscillation(), nullptr, r);
  expect_closed(r);
}

/// Asks to stop when it has this many rows of energy.
class Impatient : public MemoryRecorder {
 public:
  bool stop_requested() override {
    const auto at = tables.find("energy");
    return at != tables.end() && at->second.rows.size() >= 400;
  }
};

TEST(EnergyAccountOfARun, ClosesWhereAnOscillationIsStopped) {
  Impatient r;
  try {
    run(oscillation(), nullptr, r);
    FAIL() << "it went on";
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::interrupted);
  }
  ASSERT_EQ(r.tables.at("energy").rows.size(), 401u) << "with that of the instant at which it stops";
  expect_closed(r);
}

}  // namespace
}  // namespace supple
