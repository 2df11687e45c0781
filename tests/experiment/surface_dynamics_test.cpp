#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "supple/core/error.hpp"
#include "supple/experiment/body_motion.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/experiment/surfaces_of_case.hpp"
#include "supple/observe/summary.hpp"
#include "tests/experiment/error_of.hpp"

namespace supple {
namespace {

Case moving_shells(const std::string& kind = "rough") {
  Case c;
  c.general.experiment = "dynamics";
  c.general.physics = "deformable";
  c.bodies.dimensions = 3;
  c.bodies.count = 10;
  c.bodies.vertices = 12;
  c.contact.kind = kind;
  c.jamming.packing_fraction = 0.2;
  c.motion.kinetic_energy = 1e-3;
  c.time.steps = 400;
  c.output.frames = 2;
  return c;
}

/// Each component of each site has as much energy as another, whatever its mass; in all exactly what was
/// asked for, without net momentum.
TEST(SurfaceDynamics, VelocitiesAreDrawnByEquipartition) {
  System<3> system;
  system.box.length = {100, 100, 100};
  const int sites = 6000;
  for (int k = 0; k < sites; ++k)
    add_sphere_body(system, {1.0 * (k % 20), 1.0 * (k / 20 % 20), k / 400.0}, 0.5);
  for (int k = 0; k < sites; k += 2) system.state.mass[k] = 8;
  draw_velocities(system, 0.3, 5);
  EXPECT_LT(norm(momenta(system).linear), 1e-10);
  EXPECT_NEAR(kinetic_energy(system).total(), 0.3 * sites, 1e-10 * sites);
  for (const int parity : {0, 1})
    for (int d = 0; d < 3; ++d) {
      double energy = 0, fourth = 0;
      for (int k = parity; k < sites; k += 2) {
        const double twice = system.state.mass[k] * std::pow(system.state.velocity[k][d], 2);
        energy += 0.5 * twice / (sites / 2);
        fourth += twice * twice / (sites / 2);
      }
      EXPECT_NEAR(energy, 0.1, 0.01) << parity << d;  // 0.1 sqrt(2/3000) = 0.0026
      EXPECT_NEAR(fourth / (4 * energy * energy), 3, 0.7) << "as of a Gaussian";
    }
  System<3> again = system;
  draw_velocities(again, 0.3, 5);
  EXPECT_EQ(again.state.velocity, system.state.velocity);
  draw_velocities(again, 0.3, 6);
  EXPECT_NE(again.state.velocity, system.state.velocity);
}

TEST(SurfaceDynamics, RowsSayTimeEnergiesAndPressure) {
  Packing<3> packing = packing_of(moving_shells(), surfaces_apart(moving_shells()), Places::apart);
  draw_velocities(packing.system, 0.2, 1);
  Mover dynamics(*packing.field);
  const Evaluation<3>& out = dynamics.evaluate_energies(packing.system);
  const std::vector<double> row = motion_row(packing, out);
  ASSERT_EQ(row.size(), motion_columns(packing).size());
  const double kinetic = 0.2 * 120;
  EXPECT_NEAR(row[1], kinetic, 1e-12);
  EXPECT_NEAR(row[3], kinetic + out.energy.stored(), 1e-12);
  // Apart and undeformed they make the pressure of a gas of vertices.
  const double volume = packing.system.box.volume();
  EXPECT_NEAR(row[4] * packing.pressure_unit * volume,
              2 * kinetic / 3 + (out.virial[0][0] + out.virial[1][1] + out.virial[2][2]) / 3, 1e-10);
}

class SurfaceDynamicsRun : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Contacts, SurfaceDynamicsRun, ::testing::Values("rough", "smooth"),
                         [](const auto& i) { return std::string(i.param); });

TEST_P(SurfaceDynamicsRun, KeepsItsEnergyAndRecordsTheMotion) {
  const Case c = moving_shells(GetParam());
  MemoryRecorderOf<3> r;
  run(c, nullptr, r);
  const std::vector<double> time = r.column("motion", "time"), total = r.column("motion", "total_energy"),
                            kinetic = r.column("motion", "kinetic_energy");
  ASSERT_EQ(time.size(), 401u);
  EXPECT_NEAR(time.back(), 400 * r.get("constants", "time_step"), 1e-9);
  EXPECT_NEAR(kinetic.front(), 120 * 1e-3, 1e-12);
  EXPECT_LT(kinetic.back(), 0.9 * kinetic.front()) << "shapes take part";
  for (const double e : total) EXPECT_NEAR(e, total.front(), 1e-4 * kinetic.front());
  EXPECT_FALSE(r.frames.empty());
  EXPECT_EQ(r.last_system.step, 400);
  EXPECT_GT(r.get("results", "kinetic_energy"), 0);
}

TEST_P(SurfaceDynamicsRun, WithDragComesToRest) {
  Case c = moving_shells(GetParam());
  c.motion.damping = 4;
  MemoryRecorderOf<3> r;
  run(c, nullptr, r);
  const std::vector<double> total = r.column("motion", "total_energy");
  for (std::size_t k = 1; k < total.size(); ++k) EXPECT_LE(total[k], total[k - 1] * (1 + 1e-12));
  EXPECT_LT(r.column("motion", "kinetic_energy").back(), 1e-3 * 120 * 1e-3);
}

TEST(SurfaceDynamics, RefusesShear) {
  Case c = moving_shells();
  c.shear.rate = "0.1";
  EXPECT_THAT(error_of(c), ::testing::HasSubstr("bodies.dim = 3"));
}

}  // namespace
}  // namespace supple
