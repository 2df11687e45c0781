/// The test cases of the particleShear documentation, part 4 (Tables S4-2 to S4-11), in the documented model.
#include <gtest/gtest.h>

#include "supple/observe/stress.hpp"
#include "supple/observe/summary.hpp"
#include "tests/support/prepared.hpp"

namespace supple {
namespace {

constexpr double rounding = 1e-15;

double largest(const Mat2& m) {
  return std::max({std::abs(m[0][0]), std::abs(m[0][1]), std::abs(m[1][0]), std::abs(m[1][1])});
}
void expect_zero(const Mat2& m) { EXPECT_EQ(largest(m), 0); }
void expect_equal(const Mat2& a, const Mat2& b, double tolerance = rounding) {
  EXPECT_LE(largest(a + -1 * b), tolerance * largest(a));
}
void expect_symmetric(const Mat2& m, double tolerance = rounding) {
  EXPECT_LE(std::abs(m[0][1] - m[1][0]), tolerance * (std::abs(m[0][0]) + std::abs(m[1][1])));
}
void expect_asymmetric(const Mat2& m) { EXPECT_GT(std::abs(m[0][1] - m[1][0]), 0.01 * largest(m)); }
void expect_positive_diagonal(const Mat2& m) {
  EXPECT_GT(m[0][0], 0);
  EXPECT_GT(m[1][1], 0);
}
/// Of the form -p 1: the centrifugal tension of spinning discs.
void expect_equal_tension(const Mat2& m) {
  EXPECT_LT(m[0][0], 0);
  EXPECT_EQ(m[0][0], m[1][1]);
  EXPECT_EQ(m[0][1], 0);
  EXPECT_EQ(m[1][0], 0);
}

/// Discs of radius 60 and mass 1 in a cell of 500 x 500, of the published test scripts.
class Discs {
 public:
  explicit Discs(DiscLaw law, Plates plates = Plates::none)
      : dynamics_(ForceField<2>(DiscContacts(Divergent(0), law))) {
    system.box.length = {500, 500};
    dynamics_.set_plates(plates);
    plates_ = plates;
  }
  void add(Vec2 position, Vec2 velocity, double spin = 0) {
    State<2>& s = system.state;
    const int i = s.size();
    s.resize(i + 1);
    s.position[i] = position;
    s.velocity[i] = velocity;
    s.spin[i] = spin;
    s.radius[i] = 60;
    s.mass[i] = 1;
    s.inertia[i] = 1800;
  }
  void run(int steps, double dt = 0.1) {
    capture_at_boundaries(system, plates_);
    for (int i = 0; i < steps; ++i) {
      dynamics_.evaluate(system, {});
      dynamics_.advance(system, {}, dt, 1);
    }
    dynamics_.evaluate(system, {});
  }
  const Evaluation<2>& evaluation() { return dynamics_.evaluate(system, {}); }
  StressTensors tensors() { return stress_tensors(system, evaluation()); }
  Momenta<2> momenta() { return supple::momenta(system, evaluation()); }

  System<2> system;

 private:
  Mover<2> dynamics_;
  Plates plates_;
};

DiscLaw law(PairStiffness contact, double friction) {
  return {contact, contact, Tensile{}, friction, Slip::clamp, LeverArm::distance};
}
const DiscLaw all_forces = law({1, 1, 1, 1}, 0.5);

/// Momenta stay as they are over 20 more steps, to these shares of what each is made of.
void expect_momenta_conserved(Discs& discs, double linear, double angular) {
  const Momenta before = discs.momenta();
  discs.run(20);
  const Momenta after = discs.momenta();
  double momentum = 0, moment = 0;
  for (int i = 0; i < discs.system.state.size(); ++i) {
    momentum += discs.system.state.mass[i] * norm(discs.system.state.velocity[i]);
    moment += discs.system.state.mass[i] * norm(discs.system.state.velocity[i]) *
                  norm(discs.system.state.position[i]) +
              discs.system.state.inertia[i] * std::abs(discs.system.state.spin[i]);
  }
  EXPECT_LE(norm(after.linear - before.linear), linear * momentum);
  EXPECT_LE(std::abs(after.angular - before.angular), angular * moment);
}

TEST(Part4, TableS4_2_TranslatingDisc) {
  Discs discs(all_forces);
  discs.add({150, 120}, {4, 7});
  discs.run(20);
  const StressTensors s = discs.tensors();
  for (const Mat2& m : {s.love_weber, s.overall, s.linear_acceleration, s.external, s.virial}) expect_zero(m);
  EXPECT_GT(largest(s.otsuki), 0);
  expect_momenta_conserved(discs, rounding, rounding);
}

TEST(Part4, TableS4_3_SpinningDisc) {
  Discs discs(all_forces);
  discs.add({150, 120}, {}, 0.7);
  discs.run(20);
  const StressTensors s = discs.tensors();
  for (const Mat2& m : {s.love_weber, s.linear_acceleration, s.external, s.otsuki}) expect_zero(m);
  const double pressure = -0.5 * 1800 * 0.49 / 250000;
  expect_equal(s.overall, Mat2{{{pressure, 0}, {0, pressure}}});
  expect_momenta_conserved(discs, rounding, rounding);
}

TEST(Part4, TableS4_4_CentralCollision) {
  Discs discs(law({1, 1, 1, 1}, 0));
  discs.add({150, 150}, {10, 3});
  discs.add({270, 180}, {-10, 2});
  discs.run(6);
  const StressTensors s = discs.tensors();
  expect_positive_diagonal(s.love_weber);
  expect_symmetric(s.love_weber, 0);
  expect_equal(s.love_weber, s.overall);
  expect_equal(s.love_weber, s.linear_acceleration);
  expect_zero(s.external);
  EXPECT_GT(largest(s.otsuki), 0);
  expect_momenta_conserved(discs, 1e-13, rounding);
}

TEST(Part4, TableS4_5_PurelyTangentialInteraction) {
  DiscLaw tangential = all_forces;
  tangential.link = {0, 0, 1, 1};
  Discs discs(tangential);
  discs.add({150, 150}, {1, 3}, 0.05);
  discs.add({230, 210}, {-1, 2}, 0.02);
  discs.evaluation();  // gives the pair a row
  set_pair_state(discs.system.pairs, 2, 0, 1, ContactState::permanent);
  discs.run(20);
  const StressTensors s = discs.tensors();
  const PairForce<2>& pair = discs.evaluation().pair[0];
  EXPECT_EQ(pair.elastic + pair.viscous, 0);
  Mat2 force_lever;
  force_lever.add_outer(1.0 / 250000, discs.evaluation().force[0],
                        discs.system.state.position[0] - discs.system.state.position[1]);
  expect_equal(s.love_weber, force_lever);
  expect_asymmetric(s.love_weber);
  EXPECT_LE(std::abs(s.overall[0][1] - s.overall[1][0]), rounding * largest(s.love_weber));
  expect_equal(s.love_weber, s.linear_acceleration);
  expect_zero(s.external);
  expect_symmetric(s.otsuki, 0);
  expect_momenta_conserved(discs, rounding, 1e-14);
}

TEST(Part4, TableS4_6_GeneralCollision) {
  Discs discs(all_forces);
  discs.add({150, 150}, {10, 3}, 0.1);
  discs.add({230, 210}, {-10, 2}, -0.05);
  discs.run(3);
  const StressTensors s = discs.tensors();
  const PairForce<2>& pair = discs.evaluation().pair[0];
  for (const double part : {pair.elastic, pair.viscous, pair.tangential}) EXPECT_NE(part, 0);
  for (const Mat2& m : {s.love_weber, s.overall, s.linear_acceleration}) expect_positive_diagonal(m);
  expect_asymmetric(s.love_weber);
  expect_symmetric(s.overall);
  expect_equal(s.love_weber, s.linear_acceleration);
  expect_zero(s.external);
  expect_symmetric(s.otsuki, 0);
  expect_momenta_conserved(discs, 1e-14, rounding);
}

void expect_only_boundary_forces(const StressTensors& s) {
  expect_zero(s.love_weber);
  expect_equal_tension(s.overall);
  EXPECT_GT(largest(s.external), 0);
  expect_equal(s.external, -1 * s.linear_acceleration);
}

TEST(Part4, TableS4_7_DiscAgainstAFixedDisc) {
  Discs discs(all_forces, Plates::capture);
  discs.add({150, 80}, {10, 0});
  discs.add({300, 10}, {-10, 0});
  discs.run(60);
  EXPECT_EQ(discs.system.state.mobility[1], Mobility::lower_plate);
  EXPECT_EQ(discs.system.state.mobility[0], Mobility::free);
  expect_only_boundary_forces(discs.tensors());
}

TEST(Part4, TableS4_8_PairAcrossTheBoundary) {
  for (const bool across_y : {false, true}) {
    Discs discs(all_forces);
    discs.system.box.strain = 0.1;
    if (across_y) {
      discs.add({250, 30}, {0, -5});
      discs.add({280, 430}, {0, 5});
    } else {
      discs.add({30, 250}, {-5, 0});
      discs.add({430, 280}, {5, 0});
    }
    discs.run(20);
    expect_only_boundary_forces(discs.tensors());
    EXPECT_TRUE(discs.evaluation().pair[0].crosses);
  }
}

/// Tensors of an assembly at rest, or shortly after the greatest strain of a cycle of 20 %.
enum class Load { rest, shear };
StressTensors assembly(int count, bool links, Load load) {
  Case c;
  c.particles.discs = count;
  c.particles.permanent_links = links;
  Suspension s = testing::prepared_suspension(c);
  constexpr int steps = 4480;
  const OscillatoryProtocol protocol = testing::one_cycle(c, steps);
  for (int i = 0; load == Load::shear && i < 1200; ++i) {
    s.stepper->evaluate(s.system, protocol.rates(i));
    s.stepper->advance(s.system, protocol.rates(i), protocol.time_step(), testing::damping(c, steps));
  }
  EXPECT_NEAR(s.system.box.strain, load == Load::shear ? 0.2 : 0, 0.01);
  return stress_tensors(s.system, s.stepper->evaluate(s.system, {}), s.units.stress());
}

void expect_compressed_and_nearly_still(const StressTensors& s) {
  for (int i = 0; i < 2; ++i) {
    EXPECT_GT(s.love_weber[i][i], 500);
    EXPECT_GT(s.overall[i][i], 500);
    EXPECT_NEAR(s.external[i][i], s.overall[i][i], 0.1 * s.overall[i][i]);
  }
  expect_symmetric(s.overall, 1e-10);
  EXPECT_LT(largest(s.linear_acceleration), 0.1 * s.overall[0][0]);
}

TEST(Part4, TableS4_9_FreeDiscsAtRest) {
  const StressTensors s = assembly(45, false, Load::rest);
  expect_compressed_and_nearly_still(s);
  EXPECT_LT(std::abs(s.love_weber[0][1]), 0.1 * s.love_weber[0][0]);
  EXPECT_LT(std::abs(s.love_weber[1][0]), 0.1 * s.love_weber[0][0]);
}

TEST(Part4, TableS4_10_FreeDiscsUnderShear) {
  expect_compressed_and_nearly_still(assembly(45, false, Load::shear));
}

TEST(Part4, TableS4_11_CrosslinkedParticlesUnderShear) {
  expect_compressed_and_nearly_still(assembly(60, true, Load::shear));
}

}  // namespace
}  // namespace supple
