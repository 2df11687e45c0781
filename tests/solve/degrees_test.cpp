#include "supple/solve/degrees.hpp"

#include <gtest/gtest.h>

#include "supple/contact/rough_contacts.hpp"
#include "supple/model/rigid.hpp"
#include "tests/support/polygons.hpp"

namespace supple {
namespace {

using testing::polygon_field;
using testing::random_polygons;

/// A force field, numbers, and what must hold between them.
struct Check {
  System<2> system;
  ForceField<2> field = polygon_field(RoughContacts<2>(Harmonic{3}));
  Evaluation<2> out = {};

  double energy(const BodyDegrees<2>& degrees, const std::vector<double>& q) {
    degrees.write(q, system);
    field.evaluate(system, Detail::energies, out);
    return out.energy.stored();
  }

  std::vector<double> gradient(const BodyDegrees<2>& degrees, const std::vector<double>& q) {
    degrees.write(q, system);
    field.evaluate(system, Detail::forces, out);
    std::vector<double> g(q.size());
    degrees.gradient(system, out.force, g);
    return g;
  }

  /// Gradient and Hessian against central differences, and the way there and back.
  void run() {
    const double h = 1e-6;
    const BodyDegrees<2> degrees(system);
    const auto n = static_cast<std::size_t>(degrees.size());
    std::vector<double> q(n), again(n);
    degrees.read(system, q);
    degrees.write(q, system);
    degrees.read(system, again);
    for (std::size_t k = 0; k < n; ++k) EXPECT_NEAR(again[k], q[k], 1e-15 * std::abs(q[k]));
    const std::vector<double> g = gradient(degrees, q);
    HessianBlocks<2> blocks;
    field.add_hessian(system, blocks);
    std::vector<double> dense(n * n);
    for (const MatrixEntry& e : degrees.hessian(system, blocks, out.force)) {
      ASSERT_GE(e.row(), e.col());
      dense[static_cast<std::size_t>(e.row()) * n + static_cast<std::size_t>(e.col())] += e.value();
    }
    double scale = 0;
    for (double value : g) scale = std::max(scale, std::abs(value));
    ASSERT_GT(scale, 1e-3);
    for (std::size_t k = 0; k < n; ++k) {
      std::vector<double> above = q, below = q;
      above[k] += h;
      below[k] -= h;
      EXPECT_NEAR(g[k], (energy(degrees, above) - energy(degrees, below)) / (2 * h), 1e-7 * scale)
          << "number " << k;
      const std::vector<double> g_above = gradient(degrees, above), g_below = gradient(degrees, below);
      for (std::size_t row = k; row < n; ++row)
        EXPECT_NEAR(dense[row * n + k], (g_above[row] - g_below[row]) / (2 * h),
                    1e-7 * (scale + std::abs(dense[row * n + k])))
            << row << ", " << k;
    }
  }
};

TEST(BodyDegrees, OfFreeSitesArePositions) {
  System<2> system = random_polygons();
  add_disc_body(system, {0.3, 1}, 0.7);
  const BodyDegrees<2> degrees(system);
  ASSERT_EQ(degrees.size(), 2 * system.state.size());
  std::vector<double> q(static_cast<std::size_t>(degrees.size())), g(q.size());
  degrees.read(system, q);
  degrees.gradient(system, system.state.position, g);
  for (int i = 0; i < system.state.size(); ++i)
    for (int d = 0; d < 2; ++d) {
      EXPECT_EQ(q[static_cast<std::size_t>(2 * i + d)], system.state.position[i][d]);
      EXPECT_EQ(g[static_cast<std::size_t>(2 * i + d)], -system.state.position[i][d]);
    }
  const std::vector<Vec2> before = system.state.position;
  for (Vec2& x : system.state.position) x = {};
  degrees.write(q, system);
  EXPECT_EQ(system.state.position, before);
}

TEST(BodyDegrees, OfFreeSitesHaveTheDerivativesOfTheEnergy) { Check{random_polygons()}.run(); }

TEST(BodyDegrees, OfRigidBodiesDiscsAndFixedSitesHaveTheDerivativesOfTheEnergy) {
  Check check{random_polygons()};
  System<2>& system = check.system;
  add_disc_body(system, {1.1, 1.2}, 0.7);
  for (int b : {7, 0, 4, 5}) make_rigid(system, b);
  system.rigid.angle[1] = 2.5;
  place_sites(system);
  system.state.mobility[system.topology.begin[3] + 2] = Mobility::fixed;
  system.state.mobility[system.topology.begin[5] + 1] = Mobility::fixed;  // holds a rigid body
  int sites = 1;
  for (int b : {1, 2, 3, 6, 8}) sites += system.topology.body_size(b);
  EXPECT_EQ(BodyDegrees<2>(system).size(), 2 * (sites - 1) + 3 * 3);
  check.run();
}

/// Tethers between sites of one rigid body: blocks that fall on the same numbers.
TEST(BodyDegrees, OfARigidBodyWithInnerForcesHaveTheDerivativesOfTheEnergy) {
  Check check{random_polygons()};
  const std::vector<ShapeStiffness> stiffness = check.system.shape.stiffness;
  for (int b : {0, 1}) make_rigid(check.system, b);
  check.system.shape.stiffness = stiffness;
  check.field.external().tethers = {{2, {0.3, 0.4}, 2.0}};
  check.run();
}

TEST(BodyDegrees, OfRigidBodiesCarryTheirKineticEnergy) {
  System<2> system = random_polygons();
  make_rigid(system, 2);
  system.rigid.velocity[0] = {0.3, -0.2};
  system.rigid.spin[0] = 0.7;
  place_sites(system);
  double energy = 0;
  for (int i = 0; i < system.state.size(); ++i)
    energy += 0.5 * system.state.mass[i] * dot(system.state.velocity[i], system.state.velocity[i]);
  const double turning = 0.7 * gyration_radius(system.rigid, 0),
               m = BodyDegrees<2>(system).masses(system).back();
  EXPECT_NEAR(energy, 0.5 * m * (0.09 + 0.04 + turning * turning), 1e-14 * energy);
}

}  // namespace
}  // namespace supple
