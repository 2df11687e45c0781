/// What a continuation takes over, what it refuses, and what it must not lose.
#include "supple/io/run/run_file.hpp"
#include "supple/io/state/json_node.hpp"
#include "tests/io/continued_run.hpp"

namespace supple {
namespace {

using namespace supple::testing;
using ::testing::HasSubstr;

class AdoptedState : public ContinuedRun {
 protected:
  static double derived(const std::vector<Derived>& all, const std::string& name) {
    for (const Derived& d : all)
      if (d.name.name == name) return d.value;
    ADD_FAILURE() << name;
    return 0;
  }
  /// Discs in the layout of the package: 12 of r = 60 that move, in a cell of 500.
  std::string moving_discs() const {
    Json spheres = Json::array(), neighbors = Json::array();
    for (int i = 0; i < 12; ++i) {
      spheres.push_back({{"x", 120 * (i % 4) + 30 + 15 * (i % 3)},
                         {"y", 150 * (i / 4) + 40 + 20 * (i % 2)},
                         {"vx", 200 * ((7 * i) % 5 - 2)},
                         {"vy", 200 * ((3 * i) % 5 - 2)},
                         {"phi", 0},
                         {"omega", 0.3 * (i % 3 - 1)},
                         {"r", 60},
                         {"m", 1},
                         {"inertia", 1800}});
      neighbors.push_back(Json::array());
    }
    const Json root{
        {"dt", 0.005},
        {"steps", 250},
        {"cool_factor", 1},
        {"params",
         {{"size_x", 500},
          {"size_y", 500},
          {"k", 20},
          {"nu", 0.3},
          {"k_t", 15},
          {"nu_t", 0.2},
          {"mu", 0.4},
          {"central_repulsion_coefficient", 1},
          {"applyingShear", false},
          {"permanent_ratio_central", 1},
          {"permanent_ratio_tangential", 1},
          {"keep_viscosity_coefficients_constant", true}}},
        {"initial",
         {{"t", 0}, {"shear", 0}, {"shear_rate", 0}, {"spheres", spheres}, {"neighbors", neighbors}}}};
    write_content(in_folder("moving_state.json"), root.dump());
    return "moving_state.json";
  }
  std::vector<double> column(const std::string& run_name, const std::string& name) const {
    return RunFile(in_folder(run_name)).column("stress", name);
  }
};

Case dynamics(int steps, const std::string& more = "") {
  return case_of("experiment = \"dynamics\"\n[time]\nsteps = " + std::to_string(steps) + "\n" + more);
}

const std::string sheared = "[shear]\nrate = \"0.6*cos(3*t)\"\n[initial]\nkeep_time = true\n";

TEST_F(AdoptedState, TheStressWithoutJumpsGoesOnAcrossARestart) {
  const std::string start = moving_discs();
  record("whole.h5", dynamics(400, sheared), start);
  record("first.h5", dynamics(250, sheared), start);
  record("second.h5", dynamics(150, sheared), "first.h5");
  EXPECT_NE(load("first.h5").protocol.at("removed_stress"), 0) << "discs have crossed the period";
  for (const std::string name : {"shear_stress_external_corrected", "shear_stress_virial", "t", "strain"}) {
    const std::vector<double> all = column("whole.h5", name);
    EXPECT_EQ(std::vector<double>(all.begin() + 250, all.end()), column("second.h5", name)) << name;
  }
}

TEST_F(AdoptedState, AStateAsJsonKeepsTheLagOfItsVelocities) {
  const std::string start = moving_discs();
  record("whole.h5", dynamics(200, sheared), start);
  record("half.h5", dynamics(30, sheared), start);
  const std::string json = exported("half.h5");
  record("rest.h5", dynamics(170, sheared), json);
  const State<2> a = system_of<2>(load("whole.h5")).state, b = system_of<2>(load("rest.h5")).state;
  for (std::size_t i = 0; i < a.velocity.size(); ++i)  // 200 um/s; lost half a step: 1e-2 of it
    EXPECT_NEAR(norm(a.velocity[i] - b.velocity[i]), 0, 1e-10 * 200e-6) << i;
}

TEST_F(AdoptedState, FramesHaveTheVelocitiesOfTheirInstant) {
  const std::string start = moving_discs();
  MemoryRecorder r;
  const InitialState initial = load(start);
  run(dynamics(40), &initial, r);
  const double dt = 0.005;
  int compared = 0;
  for (std::size_t k = 1; k + 1 < r.frames.size(); ++k)
    for (std::size_t i = 0; i < 12; ++i) {
      // A leapfrog: x(t + dt) - x(t - dt) = 2 dt v(t), without drag, and where the disc was not wrapped.
      const Vec2 way = r.frames[k + 1].position[i] - r.frames[k - 1].position[i];
      if (norm(way) > 100e-6) continue;
      EXPECT_NEAR(norm(1 / (2 * dt) * way - r.frames[k].velocity[i]), 0, 1e-9 * 200e-6) << k << " " << i;
      ++compared;
    }
  EXPECT_GT(compared, 400);
  EXPECT_EQ(r.frames[0].velocity[1], 1e-6 * system_of<2>(initial).state.velocity[1]) << "as given";
}

TEST_F(AdoptedState, TimeStartsAtZeroUnlessAsked) {
  const std::string start = moving_discs();
  record("first.h5", dynamics(10), start);
  EXPECT_NEAR(system_of<2>(load("first.h5")).time, 0.05, 1e-15);
  record("pulse.h5", dynamics(10, "[shear]\nrate = \"t < 0.001 ? 2 : 0\"\n"), "first.h5");
  EXPECT_EQ(column("pulse.h5", "t").front(), 0);
  EXPECT_EQ(column("pulse.h5", "strain_rate").front(), 2);
  record("on.h5", dynamics(10, "[initial]\nkeep_time = true\n"), "first.h5");
  EXPECT_NEAR(column("on.h5", "t").front(), 0.05, 1e-15);
  EXPECT_EQ(system_of<2>(load("on.h5")).step, 20);
}

TEST_F(AdoptedState, KeysAboutOtherParticlesAreRefused) {
  const std::string start = moving_discs();
  for (const std::string key : {"width = \"1 mm\"", "height = 1e-3"})
    EXPECT_THAT(error_from(dynamics(2, "[box]\n" + key + "\n"), start),
                HasSubstr("it is 0.0005 in moving_state.json"));
  EXPECT_THAT(error_from(dynamics(2, "[material]\ndensity = 50\n"), start),
              HasSubstr("material.density = 50"));
  EXPECT_THAT(error_from(dynamics(2, "[particles]\nN = 13\n"), start),
              HasSubstr("particles.N = 13 (it is 12 in moving_state.json, whose particles are taken as they "
                        "are); leave the key away"));
  EXPECT_THAT(error_from(dynamics(2, "[particles]\nedge_fuzziness = 1\n"), start),
              HasSubstr("the particles are taken from moving_state.json"));
  EXPECT_EQ(error_from(dynamics(2, "[particles]\nN = 12\n[box]\nwidth = \"500 um\"\n"), start), "")
      << "as they are";
}

TEST_F(AdoptedState, TheFrequencyIsThatOfTheDiscsInEitherFidelity) {
  for (const std::string physics : {"documented", "particleshear-1.0.2"}) {
    const std::string of_discs =
        "[particles]\nN = 24\ncut_lines = 0\n[material]\ndensity = 300\nyoung_modulus = 5000\n";
    const std::string shear = "experiment = \"oscillatory_shear\"\n",
                      model = "physics = \"" + physics + "\"\n";
    const Case whole = case_of(shear + model + of_discs);
    const double frequency = derived(derive(whole, nullptr), "frequency");
    record("gel.h5", case_of("experiment = \"dynamics\"\n" + model + of_discs + "[time]\nsteps = 3\n"));
    for (const std::string& file : {std::string("gel.h5"), exported("gel.h5")}) {
      const InitialState initial = load(file);
      EXPECT_NEAR(derived(derive(case_of(shear), &initial), "frequency"), frequency, 1e-9 * frequency)
          << physics << " " << file;
    }
  }
}

TEST_F(AdoptedState, WhatTheCaseNamesIsApplied) {
  const std::string start = moving_discs();
  const auto adopted = [&](const std::string& more) {
    const InitialState initial = load("named.h5");
    return adopt_state(dynamics(1, more), &initial);
  };
  record("named.h5",
         dynamics(2,
                  "[material]\nelastic_law = \"hertz\"\nslip = \"freeze\"\nlever_arm = \"radius\"\n"
                  "friction = 0.3\n[box]\nplates = \"repulsive\"\n"),
         start);
  EXPECT_EQ(adopted("").material.elastic_law, "hertz");
  EXPECT_EQ(adopted("").material.slip, "freeze");
  EXPECT_EQ(adopted("").material.lever_arm, "radius");
  EXPECT_EQ(adopted("").material.friction, 0.3);
  EXPECT_EQ(adopted("").box.plates, "repulsive");
  const Case other = adopted("[material]\nelastic_law = \"linear\"\n[box]\nplates = \"none\"\n");
  EXPECT_EQ(other.material.elastic_law, "linear");
  EXPECT_EQ(other.material.slip, "freeze");
  EXPECT_EQ(other.box.plates, "none");
}

TEST_F(AdoptedState, KeysInJsonAreThoseThatAStateHolds) {
  const std::string start = moving_discs();
  Json root = Json::parse(content_of(in_folder(start)));
  const auto error_with = [&](const char* key, const Json& value) {
    root["case"] = Json{{key, value}};
    write_content(in_folder("changed_state.json"), root.dump());
    return file_error_of([&] { read_state(in_folder("changed_state.json")); });
  };
  EXPECT_EQ(error_with("material.slip", "freeze"), "");
  EXPECT_THAT(error_with("material.slip", "frozen"), HasSubstr("it must be one of \"clamp\""));
  EXPECT_THAT(error_with("material.sllip", "freeze"), HasSubstr("did you mean 'slip'"));
  EXPECT_THAT(error_with("shear.amplitude", 0.1), HasSubstr("shear.amplitude is no key that a state holds"));
  EXPECT_THAT(error_with("material.slip", Json::array()), HasSubstr("is no value of a key"));
}

}  // namespace
}  // namespace supple
