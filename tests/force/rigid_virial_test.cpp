#include <gtest/gtest.h>

#include "supple/contact/rough_contacts.hpp"
#include "supple/model/rigid.hpp"
#include "tests/support/moving_bodies.hpp"
#include "tests/support/surface_reference.hpp"

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

/// In 3D, of a periodic cell.
TEST(RigidVirial, OfSurfacesIsTheSlopeOfTheEnergy) {
  System<3> system = testing::read_surfaces("shells4_12_rough").system;
  for (const int b : {0, 2, 3}) make_rigid(system, b);
  for (Vec3& angle : system.rigid.angle) angle = {0.3, -0.4, 0.2};
  place_sites(system);
  ForceField<3> field{RoughContacts<3>(Harmonic{1, false})};
  Evaluation<3> at, out;
  field.evaluate(system, Detail::energies, at);
  const auto energy = [&](int i, int j, double e) {
    System<3> s = system;
    for (auto* points : {&s.state.position, &s.rigid.centre})
      for (Vec3& x : *points) x[i] += e * x[j];
    place_sites(s);
    if (i != j) s.box.strain += e;
    else s.box.length[i] *= 1 + e;
    if (i == j && i == flow) s.box.strain *= 1 + e;
    if (i == j && i == gradient) s.box.strain /= 1 + e;
    field.invalidate();
    field.evaluate(s, Detail::energies, out);
    return out.energy.stored();
  };
  const double h = 1e-5;
  double scale = 0;
  for (int d = 0; d < 3; ++d) scale = std::max(scale, std::abs(at.virial[d][d]));
  ASSERT_GT(scale, 1e-3);
  ASSERT_GT(std::abs(rigid_virial(system, at.force)[0][0]), 0.01 * scale);
  for (int d = 0; d < 3; ++d)
    EXPECT_NEAR(at.virial[d][d], -(energy(d, d, h) - energy(d, d, -h)) / (2 * h), 1e-8 * scale) << d;
  const double shear = -(energy(flow, gradient, h) - energy(flow, gradient, -h)) / (2 * h);
  EXPECT_NEAR(at.virial[flow][gradient], shear, 1e-8 * scale);
}

}  // namespace
}  // namespace supple
