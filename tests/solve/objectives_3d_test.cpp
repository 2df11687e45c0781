#include <gtest/gtest.h>

#include <cmath>

#include "supple/contact/rough_contacts.hpp"
#include "supple/contact/smooth_surfaces.hpp"
#include "supple/core/random.hpp"
#include "supple/force/surface_shape.hpp"
#include "supple/model/rigid.hpp"
#include "supple/solve/cell_objective.hpp"
#include "tests/support/surface_reference.hpp"

namespace supple {
namespace {

ForceField<3> field_of(const BodyContacts<3>& contacts) {
  ForceField<3> field(contacts);
  field.terms().add(std::make_shared<SurfaceShape>());
  return field;
}

/// Slopes against central differences of the energy, second derivatives against those of the slopes. `near`:
/// of the largest.
void expect_consistent(Objective& objective, std::vector<double> x, double near, int stride = 7) {
  const int n = objective.size();
  std::vector<double> slope(static_cast<std::size_t>(n)), above(slope), below(slope);
  objective.evaluate(x, slope);
  SparseMatrix lower;
  objective.hessian(x, lower);
  std::vector<std::vector<double>> h(slope.size(), std::vector<double>(slope.size(), 0));
  double stiffest = 0, steepest = 0;
  for (int c = 0; c < n; ++c)
    for (int k = lower.begin[c]; k < lower.begin[c + 1]; ++k) {
      h[lower.row[k]][c] = h[c][lower.row[k]] = lower.value[k];
      stiffest = std::max(stiffest, std::abs(lower.value[k]));
    }
  for (const double s : slope) steepest = std::max(steepest, std::abs(s));
  ASSERT_GT(steepest, 1e-3);
  for (int i = 0; i < n; i += stride) {  // not all of hundreds
    const double at = x[i], step = 1e-6;
    x[i] = at + step;
    const double high = objective.evaluate(x, above);
    x[i] = at - step;
    const double low = objective.evaluate(x, below);
    x[i] = at;
    EXPECT_NEAR(slope[i], (high - low) / (2 * step), near * steepest) << i;
    for (int j = 0; j < n; ++j)
      EXPECT_NEAR(h[i][j], (above[j] - below[j]) / (2 * step), near * stiffest) << i << ' ' << j;
  }
}

TEST(ObjectivesIn3D, BodiesHaveTheDerivativesOfTheirEnergy) {
  testing::SurfaceReference rough = testing::read_surfaces("shells4_12_rough");
  ForceField<3> field = field_of(RoughContacts<3>(Harmonic{rough.stiffness("k_c"), false}));
  BodyObjective<3> objective(rough.system, field, {});
  EXPECT_EQ(objective.block_size(), 3);
  expect_consistent(objective, objective.coordinates(), 1e-7);
}

TEST(ObjectivesIn3D, SitesThatAreHeldAreNoDegreesOfFreedom) {
  testing::SurfaceReference rough = testing::read_surfaces("shells4_12_rough");
  for (const std::size_t i : {0, 13, 47}) rough.system.state.mobility[i] = Mobility::fixed;
  ForceField<3> field = field_of(RoughContacts<3>(Harmonic{rough.stiffness("k_c"), false}));
  BodyObjective<3> objective(rough.system, field, {});
  EXPECT_EQ(objective.size(), 3 * 45);
  expect_consistent(objective, objective.coordinates(), 1e-7);
}

/// Shells that overlap, these of them rigid, turned by so much since.
testing::SurfaceReference with_rigid_bodies(const char* name, const std::vector<int>& bodies, double angle) {
  testing::SurfaceReference made = testing::read_surfaces(name);
  System<3>& s = made.system;
  for (const int b : bodies) make_rigid(s, b);
  for (int r = 0; r < s.rigid.size(); ++r)
    s.rigid.angle[r] = angle / std::sqrt(14.0) * Vec3{1, r % 2 ? -2. : 2., 3};
  place_sites(s);
  return made;
}

/// At angles that need not be small.
TEST(ObjectivesIn3D, RigidBodiesHaveTheDerivativesOfTheirEnergy) {
  for (const double angle : {0.0, 0.4, 1.9, 2.9}) {
    testing::SurfaceReference rough = with_rigid_bodies("shells4_12_rough", {0, 2, 3}, angle);
    rough.system.state.mobility[16] = Mobility::fixed;
    ForceField<3> field = field_of(RoughContacts<3>(Harmonic{rough.stiffness("k_c"), false}));
    BodyObjective<3> objective(rough.system, field, {});
    ASSERT_EQ(objective.size(), 3 * 11 + 6 * 3);
    expect_consistent(objective, objective.coordinates(), 1e-7, 1);
  }
}

TEST(ObjectivesIn3D, ARigidBodyWithAHeldSiteIsHeld) {
  testing::SurfaceReference rough = with_rigid_bodies("shells4_12_rough", {0, 2, 3}, 0.3);
  rough.system.state.mobility[3] = Mobility::fixed;
  ForceField<3> field = field_of(RoughContacts<3>(Harmonic{rough.stiffness("k_c"), false}));
  BodyObjective<3> objective(rough.system, field, {});
  ASSERT_EQ(objective.size(), 3 * 12 + 6 * 2);
  expect_consistent(objective, objective.coordinates(), 1e-7, 5);
}

TEST(ObjectivesIn3D, RotationVectorsBeginShort) {
  testing::SurfaceReference rough = with_rigid_bodies("shells4_12_rough", {0, 2, 3}, 17);
  const std::vector<Vec3> before = rough.system.state.position;
  ForceField<3> field = field_of(RoughContacts<3>(Harmonic{rough.stiffness("k_c"), false}));
  BodyObjective<3> objective(rough.system, field, {});
  std::vector<double> x = objective.coordinates(), slope(x.size());
  for (const Vec3& angle : rough.system.rigid.angle) EXPECT_LE(norm(angle), 3.2);
  objective.evaluate(x, slope);
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_LT(norm(rough.system.state.position[i] - before[i]), 1e-13);
}

/// As a minimiser moves it.
TEST(ObjectivesIn3D, ARigidBodyKeepsItsShapeOverManySteps) {
  testing::SurfaceReference rough = with_rigid_bodies("shells4_12_rough", {0, 1, 2, 3}, 0);
  System<3>& s = rough.system;
  const System<3> before = s;
  const BodyDegrees<3> degrees(s);
  ASSERT_EQ(degrees.size(), 24);
  std::vector<double> q(24);
  degrees.read(s, q);
  RandomStream draw(3, Purpose::test);
  for (int step = 0; step < 10000; ++step) {
    for (double& number : q) number += draw.uniform(-0.02, 0.02);
    degrees.write(q, s);
    degrees.read(s, q);
  }
  double turned = 0, most = 0;
  for (int r = 0; r < 4; ++r) {
    turned = std::max(turned, norm(s.rigid.angle[r]));
    for (int i = s.topology.begin[r]; i < s.topology.begin[r + 1]; ++i)
      for (int j = s.topology.begin[r]; j < i; ++j)
        most = std::max(most, std::abs(norm(s.state.position[i] - s.state.position[j]) -
                                       norm(before.state.position[i] - before.state.position[j])));
  }
  EXPECT_GT(turned, 1);
  EXPECT_LT(most, 1e-13);
}

/// Contacts of rigid bodies push with no net force, and in an open cell with no net torque.
TEST(ObjectivesIn3D, RigidBodiesPushOnEachOtherAlone) {
  testing::SurfaceReference rough = with_rigid_bodies("shells4_12_rough", {0, 1, 2, 3}, 0.7);
  System<3>& s = rough.system;
  s.box.periodic = {false, false, false};
  s.box.length = {100, 100, 100};
  s.box.strain = 0;
  ForceField<3> field = field_of(RoughContacts<3>(Harmonic{rough.stiffness("k_c"), false}));
  Evaluation<3> out;
  field.evaluate(s, Detail::energies, out);
  Vec3 force{}, torque{};
  double size = 0;
  for (int r = 0; r < 4; ++r) {
    const RigidForceOf<3> on_body = force_on_rigid(s, out.force, r);
    force += on_body.force;
    torque += on_body.torque + cross(s.rigid.centre[r], on_body.force);
    size += norm(on_body.force);
  }
  ASSERT_GT(size, 1e-3);
  EXPECT_LT(norm(force), 1e-14 * size);
  EXPECT_LT(norm(torque), 1e-13 * size);
}

TEST(ObjectivesIn3D, TheCellHasTheSlopeOfItsEnthalpy) {
  for (const char* name : {"shells4_12_rough", "shells4_42_smooth", "rigid shells4_12_rough"}) {
    const bool rigid = name[0] == 'r';
    if (rigid) name += 6;
    testing::SurfaceReference reference =
        with_rigid_bodies(name, rigid ? std::vector{0, 2} : std::vector<int>{}, 1.2);
    const Harmonic law{reference.stiffness("k_c"), false};
    ForceField<3> field = std::string(name).ends_with("rough") ? field_of(RoughContacts<3>(law))
                                                               : field_of(SmoothSurfaces(law));
    CellObjective<3> objective(reference.system, field, {}, {true, true}, 0.02, 0.003);
    EXPECT_EQ(objective.block_size(), 3);
    std::vector<double> x = objective.coordinates(), slope(x.size()), other(x.size());
    x[x.size() - 2] = 0.01;
    x[x.size() - 1] = -0.02;
    objective.evaluate(x, slope);
    double steepest = 0;
    for (const double s : slope) steepest = std::max(steepest, std::abs(s));
    for (std::size_t i = 0; i < x.size(); i += i + 5 < x.size() ? 5 : 1) {
      const double at = x[i], step = 1e-6;
      x[i] = at + step;
      const double high = objective.evaluate(x, other);
      x[i] = at - step;
      const double low = objective.evaluate(x, other);
      x[i] = at;
      EXPECT_NEAR(slope[i], (high - low) / (2 * step), 1e-7 * steepest) << name << ' ' << i;
    }
  }
}

/// Two spheres between walls, one at an edge of the box.
TEST(ObjectivesIn3D, WallsPushInEveryDirection) {
  System<3> s;
  s.box.length = {4, 5, 6};
  s.box.periodic = {false, false, false};
  add_sphere_body(s, {0.4, 2, 5.3}, 1);
  add_sphere_body(s, {2, 4.2, 3}, 1);
  ForceField<3> field{RoughContacts<3>(Harmonic{1, false})};
  field.set_walls({.repulsion = Harmonic{4, false}});
  const auto evaluated = [&] {
    Evaluation<3> out;
    field.invalidate();
    field.evaluate(s, Detail::energies, out);
    return out;
  };
  const Evaluation<3> out = evaluated();
  EXPECT_NEAR(out.energy.wall, 2 * (0.6 * 0.6 + 0.3 * 0.3 + 0.2 * 0.2), 1e-14);
  EXPECT_LT(norm(out.force[0] - Vec3{4 * 0.6, 0, -4 * 0.3}), 1e-14);
  EXPECT_EQ(out.wall.size(), 3u);
  for (int d = 0; d < 3; ++d) {  // walls move with the cell
    const double step = 1e-6;
    double energy[2];
    const System<3> before = s;
    for (const int side : {0, 1}) {
      const double stretch = 1 + (side == 0 ? -step : step);
      s.box.length[d] *= stretch;
      for (Vec3& x : s.state.position) x[d] *= stretch;
      energy[side] = evaluated().energy.stored();
      s = before;
    }
    EXPECT_NEAR(out.virial[d][d], -(energy[1] - energy[0]) / (2 * step), 1e-8) << d;
  }
  WallLaw<3> rubbing;
  rubbing.floor_friction = 0.1;
  field.set_walls(rubbing);
  EXPECT_THROW(evaluated(), Error);
}

}  // namespace
}  // namespace supple
