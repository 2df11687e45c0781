#include <gtest/gtest.h>

#include "supple/contact/rough_contacts.hpp"
#include "supple/model/rigid.hpp"
#include "tests/support/moving_bodies.hpp"

namespace supple {
namespace {

/// Shells, discs and rigid bodies between walls: -dU/d(strain) where sites follow the strain and rigid bodies
/// with their centres.
TEST(RigidVirial, IsTheSlopeOfTheEnergyByStrain) {
  System<2> system = testing::random_polygons();
  add_disc_body(system, {0.8, 1.2}, 0.5);
  for (int b : {0, 3, 4, 8}) make_rigid(system, b);
  system.box.periodic[flow] = false;
  system.box.strain = 0;
  for (Vec2& x : system.state.position) x += Vec2{1, 0};
  for (Vec2& x : system.rigid.centre) x += Vec2{1, 0};
  place_sites(system);
  system.box.length[flow] += 0.2;
  ForceField<2> field = testing::shell_field();
  field.set_walls({});
  Evaluation<2> at;
  field.evaluate(system, Detail::energies, at);
  EXPECT_GT(at.energy.wall, 0);
  const auto energy = [&](int i, int j, double e) {
    System<2> strained = system;
    for (auto* points : {&strained.state.position, &strained.rigid.centre})
      for (Vec2& x : *points) x[i] += e * x[j];
    place_sites(strained);
    if (i == j) strained.box.length[i] *= 1 + e;
    Evaluation<2> out;
    ForceField<2> fresh = testing::shell_field();
    fresh.set_walls({});
    fresh.evaluate(strained, Detail::energies, out);
    return out.energy.stored();
  };
  for (int d = 0; d < 2; ++d) {
    const double h = 1e-6, slope = (energy(d, d, h) - energy(d, d, -h)) / (2 * h);
    EXPECT_NEAR(at.virial[d][d], -slope, 1e-7 * std::abs(slope));
  }
}

/// Simple shear of a periodic cell, which turns no body.
TEST(RigidVirial, IsTheSlopeOfTheEnergyByShear) {
  System<2> system = testing::random_polygons();
  for (int b : {0, 3, 4, 8}) make_rigid(system, b);
  ForceField<2> field = testing::shell_field();
  Evaluation<2> at, out;
  field.evaluate(system, Detail::energies, at);
  const auto energy = [&](double e) {
    System<2> strained = system;
    for (auto* points : {&strained.state.position, &strained.rigid.centre})
      for (Vec2& x : *points) x[flow] += e * x[gradient];
    place_sites(strained);
    strained.box.strain += e;
    field.evaluate(strained, Detail::energies, out);
    return out.energy.stored();
  };
  const double h = 1e-6, slope = (energy(h) - energy(-h)) / (2 * h);
  EXPECT_NEAR(at.virial[flow][gradient], -slope, 1e-7 * std::abs(slope));
}

}  // namespace
}  // namespace supple
