/// What Lees-Edwards boundaries may not change: trajectories and the full virial under a shift of the origin,
/// a Galilean shift, and a strain of one more image; contact forces against a search of all pairs.
#include <gtest/gtest.h>

#include "supple/observe/stress.hpp"
#include "tests/support/all_pairs.hpp"
#include "tests/support/prepared.hpp"

namespace supple {
namespace {

/// A few crosslinked particles with friction in a cell without plates.
Case plain_cell() {
  Case c;
  c.particles.discs = 40;
  c.particles.cut_lines = 3;
  c.material.friction = 0.3;
  c.box.plates = "none";
  return c;
}

/// Positions and the virial stress after a part of a cycle.
struct Outcome {
  System<2> system;
  Mat2 virial;
};

constexpr int steps_per_cycle = 2240, steps = 1000;

/// From this state, under oscillating shear or at the constant rate of its start.
enum class Rate { oscillating, constant };
Outcome sheared(System<2> system, const Case& c, Rate rate, double damping) {
  const std::unique_ptr<Mover<2>> dynamics = testing::documented_dynamics(c);
  const OscillatoryProtocol protocol = testing::one_cycle(c, steps_per_cycle);
  for (int i = 0; i < steps; ++i) {
    const ShearRates rates = protocol.rates(rate == Rate::constant ? 0 : i);
    dynamics->evaluate(system, rates);
    dynamics->advance(system, rates, protocol.time_step(), damping);
  }
  const Mat2 virial = stress_tensors(system, dynamics->evaluate(system, {})).virial;
  return {system, virial};
}

/// The prepared state, already flowing at the rate with which a cycle starts.
System<2> flowing(const Case& c) {
  System<2> system = testing::prepared_suspension(c).system;
  set_strain_rate(system, testing::one_cycle(c, steps_per_cycle).rates(0).mid);
  return system;
}

void wrap_all(System<2>& s) {
  for (int i = 0; i < s.state.size(); ++i) s.box.wrap(s.state.position[i], s.state.velocity[i]);
}

/// The same discs as in `expected`, up to whole cells, and the same stress.
void expect_same(const Outcome& a, const Outcome& expected, Vec2 shift = {}) {
  const Box<2>& box = a.system.box;
  for (int i = 0; i < a.system.state.size(); ++i)
    EXPECT_LE(norm(box.displacement(a.system.state.position[i], expected.system.state.position[i] + shift)),
              1e-9 * box.length[0])
        << "disc " << i;
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      EXPECT_NEAR(a.virial[i][j], expected.virial[i][j], 1e-7 * std::abs(expected.virial[0][0])) << i << j;
}

TEST(LeesEdwards, ShiftOfTheOriginChangesNothing) {
  const Case c = plain_cell();
  const System<2> start = flowing(c);
  const Outcome reference = sheared(start, c, Rate::oscillating, 0.999);
  const Vec2 shift{1.3e-4, 2.1e-4};
  System<2> shifted = start;
  for (int i = 0; i < shifted.state.size(); ++i) {
    shifted.state.position[i] += shift;
    shifted.state.velocity[i][flow] += shift[gradient] * shifted.box.strain_rate;
  }
  wrap_all(shifted);
  // A disc that is higher by shift_y flows faster by shift_y rate.
  const double strain = reference.system.box.strain - start.box.strain;
  expect_same(sheared(shifted, c, Rate::oscillating, 0.999), reference,
              shift + Vec2{shift[gradient] * strain, 0});
}

TEST(LeesEdwards, GalileanShiftChangesNothing) {
  const Case c = plain_cell();
  const System<2> start = flowing(c);
  const Outcome reference = sheared(start, c, Rate::constant, 1);
  const double time = reference.system.time - start.time;
  const Vec2 velocity = (1 / time) * Vec2{2.2e-4, 3.7e-4};  // most of a cell
  System<2> moving = start;
  for (Vec2& v : moving.state.velocity) v += velocity;
  expect_same(sheared(moving, c, Rate::constant, 1), reference, time * velocity);
}

TEST(LeesEdwards, OneMoreImageOfStrainIsTheSameCell) {
  const Case c = plain_cell();
  const System<2> start = flowing(c);
  const Outcome reference = sheared(start, c, Rate::oscillating, 0.999);
  for (const int images : {1, -3}) {
    System<2> again = start;
    again.box.strain += images * start.box.length[flow] / start.box.length[gradient];
    expect_same(sheared(again, c, Rate::oscillating, 0.999), reference);
  }
}

TEST(LeesEdwards, ForcesOfAWholeCycleAreThoseOfAllPairs) {
  Case c = plain_cell();
  c.shear.amplitude = 0.7;
  System<2> system = flowing(c);
  const std::unique_ptr<Mover<2>> dynamics = testing::documented_dynamics(c);
  DiscContacts contacts = dynamics->forces().contacts();
  const OscillatoryProtocol protocol = testing::one_cycle(c, steps_per_cycle);
  int checked = 0;
  for (int i = 0; i < steps_per_cycle; ++i) {
    const Evaluation<2>& evaluation = dynamics->evaluate(system, protocol.rates(i));
    System<2> all = system;
    testing::fill_all_pairs(all);
    for (int row = 0; row < system.pairs.size(); ++row) {
      const int at = all.pairs.find(system.pairs.first[row], system.pairs.second[row]);
      all.pairs.state[at] = system.pairs.state[row];
      all.pairs.history[at] = system.pairs.history[row];
    }
    Evaluation<2> expected;
    expected.force.resize(all.state.size());
    expected.torque.resize(all.state.size());
    expected.now = evaluation.now;
    contacts.evaluate(all, all.lag, Detail::forces, expected);
    ASSERT_EQ(evaluation.force, expected.force) << "step " << i;
    ASSERT_EQ(evaluation.torque, expected.torque) << "step " << i;
    ++checked;
    dynamics->advance(system, protocol.rates(i), protocol.time_step(), 1);
  }
  EXPECT_GT(dynamics->forces().neighbors().builds(), 10);
  EXPECT_LT(dynamics->forces().neighbors().builds(), checked / 4);
}

}  // namespace
}  // namespace supple
