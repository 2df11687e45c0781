/// Shear of rigid polygons, alone and among deformable particles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "supple/core/error.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/io/text/case_file.hpp"
#include "supple/model/rigid.hpp"

namespace supple {
namespace {

constexpr const char* rigid = R"(
[bodies]
family = "rough_disc"
N = 9
vertices = 10
)";

constexpr const char* mixture = R"(
[[species]]
family = "shell"
N = 4
vertices = 12
[[species]]
family = "rough_disc"
N = 4
vertices = 10
diameter = 0.9
[[species]]
family = "disc"
N = 2
)";

Case sheared(const std::string& particles, const std::vector<std::string>& overrides = {}) {
  Case c = read_case_text(R"(
experiment = "oscillatory_shear"
physics = "deformable"
[jamming]
pressure = 1e-2
step = 1e-2
packing_fraction = 0.4
[particles]
cut_lines = 3
avoid_height_spanning_particles = false
[material]
friction = 0.3
[shear]
amplitude = 0.05
relative_frequency = 0.05
pre_periods = 0
periods = 2
post_periods = 0
)" + particles,
                          "rigid.toml", overrides);
  resolve_family(c);
  return c;
}

MemoryRecorder result_of(const Case& c, const InitialState* initial = nullptr) {
  MemoryRecorder recorder;
  run(c, initial, recorder);
  return recorder;
}

class RigidShear : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(AloneAndMixed, RigidShear, ::testing::Values(rigid, mixture));

TEST_P(RigidShear, EnergyBalanceClosesAndConvergesWithTheStep) {
  const MemoryRecorder coarse = result_of(sheared(GetParam()));
  EXPECT_GT(coarse.get("results", "links"), 0);
  EXPECT_FALSE(coarse.last_system.rigid.empty());
  const double residual = coarse.get("results", "energy_residual");
  EXPECT_LT(residual, 1e-3);
  const double finer =
      result_of(sheared(GetParam(), {"time.step_factor=0.25"})).get("results", "energy_residual");
  EXPECT_LT(finer, 3e-4);
  EXPECT_LT(finer, 0.6 * residual);
  for (const char* channel : {"lost_viscous", "lost_tangential", "lost_background", "elastic", "tangential"})
    EXPECT_GT(coarse.tables.at("energy").column(channel).back(), 0) << channel;
}

/// From rest to rest the work of the account is that of the stress, which shares no number with it. In a slow
/// shear: the virial and the boundary differ by the change of sum m y v_x.
TEST_P(RigidShear, WorkOfTheBoundaryIsThatOfTheStress) {
  const MemoryRecorder r = result_of(sheared(
      GetParam(), {"shear.pre_periods=0.1", "shear.post_periods=0.1", "shear.relative_frequency=0.02"}));
  const std::vector<double> stress = r.tables.at("stress").column("shear_stress_total"),
                            strain = r.tables.at("stress").column("strain");
  double work = 0;
  for (std::size_t k = 1; k < strain.size(); ++k)
    work += 0.5 * (stress[k] + stress[k - 1]) * (strain[k] - strain[k - 1]);
  work *= r.last_system.box.volume() * r.get("constants", "pressure_unit");
  const MemoryRecorder::Table& energy = r.tables.at("energy");
  const double booked = energy.column("work_images").back() + energy.column("work_shear_rate").back();
  EXPECT_GT(booked, 0);
  EXPECT_NEAR(work, booked, 0.03 * booked);
}

/// Between plates that hold vertices and rigid particles: the balance closes with their work, what they and
/// the images beyond them exert is what does the work, and in a slow shear it is the stress of the sample.
TEST_P(RigidShear, PlatesDoTheWorkOfTheirStress) {
  const std::vector<std::string> between_plates{"box.plates=capture", "shear.pre_periods=0.1",
                                                "shear.post_periods=0.1", "shear.relative_frequency=0.02"};
  const MemoryRecorder r = result_of(sheared(GetParam(), between_plates));
  EXPECT_LT(r.get("results", "energy_residual"), 1e-3);
  const MemoryRecorder::Table& energy = r.tables.at("energy");
  EXPECT_GT(std::abs(energy.column("work_plates").back()), 1e-6);
  const std::vector<double> stress = r.tables.at("stress").column("shear_stress_plates"),
                            strain = r.tables.at("stress").column("strain");
  double work = 0;
  for (std::size_t k = 1; k < strain.size(); ++k)
    work += 0.5 * (stress[k] + stress[k - 1]) * (strain[k] - strain[k - 1]);
  work *= r.last_system.box.volume() * r.get("constants", "pressure_unit");
  const double booked = energy.column("work_plates").back() + energy.column("work_images").back();
  EXPECT_GT(booked, 0);
  EXPECT_NEAR(work, booked, 0.03 * booked);
  const double plates = r.get("results", "storage_modulus_plates"),
               virial = r.get("results", "storage_modulus_virial");
  // Layers of rigid particles on the plates bear the stress without strain, and are in the virial with less.
  if (GetParam() == rigid) EXPECT_GT(plates, virial);
  else EXPECT_NEAR(plates, virial, 0.15 * virial);
}

TEST(RigidShear, PlatesStayInAStateAndAreLeftBehindElsewhere) {
  const MemoryRecorder first = result_of(sheared(mixture, {"box.plates=capture", "shear.periods=1"}));
  const auto on_plates = [](const System<2>& s) {
    return std::count_if(s.state.mobility.begin(), s.state.mobility.end(), is_plate);
  };
  const auto held = on_plates(first.last_system);
  EXPECT_GT(held, 3);
  InitialState state;
  state.system = first.last_system;
  state.units = reduced_units();
  const auto held_after = [&](const std::string& text) {
    Case c = read_case_text(text, "next.toml", {});
    resolve_family(c);
    return on_plates(result_of(c, &state).last_system);
  };
  const std::string dynamics =
      "experiment = \"dynamics\"\nphysics = \"deformable\"\n[time]\nsteps = 5\n"
      "[shear]\nrate = \"0.01 + 0*t\"\n";
  EXPECT_GE(held_after(dynamics + "[box]\nplates = \"capture\""), held);
  EXPECT_EQ(held_after(dynamics + "[box]\nplates = \"none\""), 0);
  system_of<2>(state).links.clear();  // which would be refused
  EXPECT_EQ(held_after("experiment = \"jamming\"\n[jamming]\npressure = 1e-2\nstep = 1e-2\n"), 0);
}

TEST(RigidShear, DeformableParticlesHavePlatesOnlyWhereTheCaseSaysSo) {
  EXPECT_EQ(sheared(mixture).box.plates, "none");
  EXPECT_EQ(sheared(mixture, {"box.plates=capture"}).box.plates, "capture");
  EXPECT_EQ(Case().box.plates, "capture");
  try {
    derive(sheared(mixture, {"box.plates=repulsive"}), nullptr);
    FAIL();
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("only discs are repelled"), std::string::npos) << e.what();
  }
}

/// The same smooth polygons of many vertices, once stiff and once rigid.
TEST(RigidShear, StiffPolygonsHaveTheModuliOfRigidOnes) {
  Case jam = read_case_text(R"(
experiment = "jamming"
[bodies]
N = 6
vertices = 24
k_l = 4
k_b = 2
[contact]
kind = "smooth"
k_c = 2e-3
[jamming]
pressure = 3e-5
step = 1e-2
packing_fraction = 0.4)",
                            "jam.toml", {});
  resolve_family(jam);
  const MemoryRecorder jammed = result_of(jam);
  InitialState deformable, of_rigid;
  deformable.system = of_rigid.system = jammed.last_system;
  deformable.units = of_rigid.units = reduced_units();
  for (int b = 0; b < 6; ++b) make_rigid(system_of<2>(of_rigid), b);
  Case c = read_case_text(R"(
experiment = "oscillatory_shear"
physics = "deformable"
[bodies]
k_l = 4
k_b = 2
[contact]
kind = "smooth"
k_c = 2e-3
[material]
friction = 0.2
[shear]
amplitude = 0.01
relative_frequency = 0.2
pre_periods = 0
periods = 3
post_periods = 0)",
                          "shear.toml", {});
  resolve_family(c);
  const MemoryRecorder soft = result_of(c, &deformable), hard = result_of(c, &of_rigid);
  for (const char* modulus : {"storage_modulus_virial", "dissipated_modulus"}) {
    const double a = soft.get("results", modulus) * soft.get("constants", "pressure_unit"),
                 b = hard.get("results", modulus) * hard.get("constants", "pressure_unit");
    EXPECT_NEAR(a, b, 0.03 * b) << modulus;
    EXPECT_GT(b, 0);
  }
}

}  // namespace
}  // namespace supple
