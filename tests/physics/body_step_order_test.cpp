/// Motion of bodies of many sites with links and dashpots is of second order in the time step.
#include <gtest/gtest.h>

#include <cmath>

#include "supple/contact/link_forces.hpp"
#include "supple/contact/rough_contacts.hpp"
#include "supple/solve/mover.hpp"
#include "tests/support/polygons.hpp"
#include "tests/support/touching.hpp"

namespace supple {
namespace {

/// Rigid and deformable polygons and a disc apart from each other, linked into a chain that turns, in an open
/// cell, or in one that is sheared.
System<2> chain(bool rigid, bool sheared) {
  System<2> system;
  system.box.length = {40, 40};
  if (!sheared) system.box.periodic = {false, false};
  for (int b = 0; b < 3; ++b) add_polygon(system, {10.0 + 4 * b, sheared ? 39.0 : 20.0}, 1.5, 7, 0.2, 1, {});
  add_disc_body(system, {10, sheared ? 36.0 : 17.0}, 0.5);
  if (rigid) make_rigid(system, 1);
  const auto& begin = system.topology.begin;
  system.links = {{begin[0], begin[1] + 3, {}, 2, 0},
                  {begin[1], begin[2] + 3, {}, 2, 0},
                  {begin[0] + 4, begin[3], {}, 2, 0}};
  for (int i = 0; i < system.state.size(); ++i)
    system.state.velocity[i] = {0.1 * std::sin(i), 0.3 * std::cos(2 * i)};
  for (int r = 0; r < system.rigid.size(); ++r)
    system.rigid.velocity[r] = {0.4, -0.2}, system.rigid.spin[r] = 0.5;
  place_sites(system);
  return system;
}

struct End {
  System<2> system;
  double residual;
};

End moved(System<2> system, int steps, bool sheared) {
  ForceField<2> field = testing::polygon_field(RoughContacts<2>(Harmonic{5}));
  field.add(LinkForces(LinkLaw{3, 0.8, 2, 0.5}));
  Mover mover(std::move(field));
  EnergyBalance<2> balance;
  mover.set_account(&balance);
  const double dt = 2.0 / steps;
  const auto strain = [&](double t) { return sheared ? 0.05 * std::sin(3 * t) : 0; };
  const auto rates = [&](int k) {
    const double rate = (strain((k + 1) * dt) - strain(k * dt)) / dt;
    return ShearRates{rate, rate};
  };
  balance.open(system, mover.evaluate(system, rates(0)));
  for (int k = 0; k < steps; ++k) {
    mover.evaluate(system, rates(k));
    mover.advance(system, rates(k), dt, std::exp(-0.5 * dt));
  }
  const Evaluation<2>& last = mover.evaluate(system, rates(steps));
  return {system, balance.residual(system, last)};
}

double apart(const System<2>& a, const System<2>& b) {
  double most = 0;
  for (int i = 0; i < a.state.size(); ++i)
    most = std::max(most, norm(a.box.displacement(a.state.position[i], b.state.position[i])));
  return most;
}

void expect_second_order(bool rigid, bool sheared) {
  SCOPED_TRACE(rigid ? "with a rigid body" : "deformable");
  SCOPED_TRACE(sheared ? "sheared" : "open");
  const System<2> start = chain(rigid, sheared);
  const End a = moved(start, 200, sheared), b = moved(start, 400, sheared), c = moved(start, 800, sheared);
  const double coarse = apart(a.system, b.system), fine = apart(b.system, c.system);
  EXPECT_GT(fine, 1e-10);
  EXPECT_NEAR(coarse / fine, 4, 0.4);
  if (rigid) return;  // their dashpots are booked about sites that turn within a step
  EXPECT_NEAR(a.residual / b.residual, 4, 0.6);
  EXPECT_NEAR(b.residual / c.residual, 4, 0.6);
}

TEST(BodyStepOrder, LinkedBodiesInAnOpenCell) {
  expect_second_order(false, false);
  expect_second_order(true, false);
}

TEST(BodyStepOrder, LinkedBodiesInACellWhoseShearSwings) {
  expect_second_order(false, true);
  expect_second_order(true, true);
}

}  // namespace
}  // namespace supple
