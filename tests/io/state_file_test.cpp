#include <gmock/gmock.h>

#include <regex>

#include "supple/io/run/file_recorder.hpp"
#include "supple/io/state/state_file.hpp"
#include "supple/model/convert.hpp"
#include "tests/io/sample_run.hpp"
#include "tests/io/temporary_folder.hpp"

namespace supple {
namespace {

using namespace supple::testing;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr auto linked_pair = R"({
 "dt": 0.01, "cool_factor": 0.5, "steps": 100, "reset_force_each_step": false, "name": "ignored",
 "params": {"size_x": 500, "size_y": 400, "k": 20, "nu": 0.5, "k_t": 15, "nu_t": 0.4, "mu": 0.01,
  "central_repulsion_coefficient": 1, "applyingShear": true, "permanent_ratio_central": 0.5,
  "permanent_ratio_tangential": 0.25, "keep_viscosity_coefficients_constant": false},
 "initial": {"t": 0.5, "shear": 0.125, "shear_rate": -3,
  "spheres": [
   {"x": 150, "y": 200, "vx": -10, "vy": 6, "phi": -1.5, "omega": 0.3, "r": 60.0, "m": 1, "inertia": 1800.0},
   {"x": 262, "y": 380, "vx": 9, "vy": -4, "phi": -1.25, "omega": 0.25, "r": 70.0, "m": 1.3,
    "inertia": 3185.0},
   {"x": 200, "y": 10, "vx": 0, "vy": 0, "phi": 0, "omega": 0, "r": 60.0, "m": 1, "inertia": 1800.0}],
  "neighbors": [
   [{"j": 2, "type": "slip", "fp": 0, "eq": 0}, {"j": 1, "type": "permanent", "fp": 0.125, "eq": 130.0}],
   [{"j": 0, "type": "permanent", "fp": 0.25, "eq": 130.0}],
   [{"j": 0, "type": "slip", "fp": 0, "eq": 0}]]}})";

class StateFile : public TemporaryFolder {
 protected:
  InitialState read(const std::string& text) const {
    write_content(in_folder("state.json"), text);
    return read_state(in_folder("state.json"));
  }
  /// The error after replacing `from` (a regular expression, first match) in the linked pair.
  std::string error_with(const std::string& from, const std::string& to) const {
    const std::string text =
        std::regex_replace(linked_pair, std::regex(from), to, std::regex_constants::format_first_only);
    EXPECT_NE(text, linked_pair) << from;
    return file_error_of([&] { read(text); });
  }
};

/// A link that is longer than half the cell is about an image that no rule finds again.
TEST_F(StateFile, KeepsTheImagesOfLinks) {
  InitialState s = read(linked_pair);
  EXPECT_TRUE(system_of<2>(s).pairs.image.empty());
  system_of<2>(s).pairs.image.resize(2);
  const int row = system_of<2>(s).pairs.find(0, 1);
  system_of<2>(s).pairs.image[row] = {{1, -2, 0}, true};
  write_state_json(s, in_folder("again.json"));
  const InitialState again = read_state(in_folder("again.json"));
  EXPECT_EQ(system_of<2>(again).pairs.image, system_of<2>(s).pairs.image);
  EXPECT_THAT(error_with(R"("fp": 0.125,)", R"("fp": 0.125, "image": [0.5, 0],)"),
              HasSubstr("not a number of cells"));
}

TEST_F(StateFile, ReadsTheLayoutOfThePackage) {
  const InitialState s = read(linked_pair);
  EXPECT_EQ(s.units.name, particleshear_units().name);
  EXPECT_EQ(system_of<2>(s).time, 0.5);
  EXPECT_EQ(system_of<2>(s).step, 0);
  EXPECT_EQ(system_of<2>(s).box.length, (Vec2{500, 400}));
  EXPECT_EQ(system_of<2>(s).box.strain, 0.125);
  EXPECT_EQ(system_of<2>(s).box.strain_rate, -3);
  EXPECT_EQ(system_of<2>(s).state.position[1], (Vec2{262, 380}));
  EXPECT_EQ(system_of<2>(s).state.velocity[0], (Vec2{-10, 6}));
  EXPECT_THAT(system_of<2>(s).state.angle, ElementsAre(-1.5, -1.25, 0));
  EXPECT_THAT(system_of<2>(s).state.spin, ElementsAre(0.3, 0.25, 0));
  EXPECT_THAT(system_of<2>(s).state.radius, ElementsAre(60, 70, 60));
  EXPECT_THAT(system_of<2>(s).state.mass, ElementsAre(1, 1.3, 1));
  EXPECT_THAT(system_of<2>(s).state.inertia, ElementsAre(1800, 3185, 1800));
  EXPECT_THAT(system_of<2>(s).state.mobility,
              ElementsAre(Mobility::free, Mobility::upper_plate, Mobility::lower_plate));

  const PairTable& pairs = system_of<2>(s).pairs;
  EXPECT_THAT(pairs.first, ElementsAre(0, 0));
  EXPECT_THAT(pairs.second, ElementsAre(1, 2)) << "in canonical order";
  EXPECT_THAT(pairs.begin, ElementsAre(0, 2, 2, 2));
  EXPECT_THAT(pairs.state, ElementsAre(ContactState::permanent, ContactState::slip));
  EXPECT_EQ(pairs.width, 2);
  EXPECT_THAT(pairs.history, ElementsAre(0.125, 0.25, 0, 0)) << "first toward second, then back";

  EXPECT_EQ(s.material.k, 20);
  EXPECT_EQ(s.material.nu_t, 0.4);
  EXPECT_EQ(s.material.permanent_ratio_tangential, 0.25);
  EXPECT_EQ(s.material.keep_viscosity_coefficients_constant, false);
  EXPECT_EQ(s.keys, (HeldKeys{{"box.plates", "capture"}}));
  EXPECT_FALSE(s.reset_force_each_step);
  EXPECT_FALSE(s.evaluation);
  EXPECT_EQ(s.protocol, (std::map<std::string, double>{{"dt", 0.01}, {"cool_factor", 0.5}, {"steps", 100}}));
}

TEST_F(StateFile, WhatIsWrittenIsReadBack) {
  InitialState s = read(linked_pair);
  s.protocol["f"] = 1 / 3.;
  Evaluation<2> evaluation;
  evaluation.force = {{0.1, 0.2}, {0.3, 0.4}, {0.5, 0.6}};
  evaluation.torque = {1, 2, 3};
  s.evaluation = evaluation;
  write_state_json(s, in_folder("copy.json"));
  const InitialState t = read_state(in_folder("copy.json"));
  EXPECT_EQ(system_of<2>(t).state.position, system_of<2>(s).state.position);
  EXPECT_EQ(system_of<2>(t).state.velocity, system_of<2>(s).state.velocity);
  EXPECT_EQ(system_of<2>(t).state.spin, system_of<2>(s).state.spin);
  EXPECT_EQ(system_of<2>(t).state.mobility, system_of<2>(s).state.mobility);
  EXPECT_EQ(system_of<2>(t).pairs.second, system_of<2>(s).pairs.second);
  EXPECT_EQ(system_of<2>(t).pairs.state, system_of<2>(s).pairs.state);
  EXPECT_EQ(system_of<2>(t).pairs.history, system_of<2>(s).pairs.history);
  EXPECT_EQ(system_of<2>(t).box.strain, system_of<2>(s).box.strain);
  EXPECT_EQ(t.material.k, s.material.k);
  EXPECT_EQ(t.material.keep_viscosity_coefficients_constant, s.material.keep_viscosity_coefficients_constant);
  EXPECT_EQ(t.reset_force_each_step, s.reset_force_each_step);
  EXPECT_EQ(t.protocol, s.protocol);
  EXPECT_EQ(evaluation_of<2>(t)->force, evaluation_of<2>(s)->force);
  EXPECT_EQ(evaluation_of<2>(t)->torque, evaluation_of<2>(s)->torque);
  EXPECT_THAT(file_error_of([&] { write_state_json(s, in_folder("copy.json")); }), HasSubstr("exists"));
}

TEST_F(StateFile, AStateInSIIsWrittenInTheUnitsOfThePackage) {
  InitialState s = read(linked_pair);
  convert(system_of<2>(s), particleshear_units(), si_units());
  s.units = si_units();
  *s.material.k *= 1e-6;
  *s.material.nu *= 1e-6;
  EXPECT_NEAR(system_of<2>(s).state.position[1][0], 262e-6, 1e-18);
  EXPECT_NEAR(system_of<2>(s).state.velocity[0][0], -10e-6, 1e-18);
  EXPECT_NEAR(system_of<2>(s).state.mass[1], 1.3e-6, 1e-18);
  EXPECT_NEAR(system_of<2>(s).state.inertia[0], 1800e-18, 1e-27);
  EXPECT_NEAR(system_of<2>(s).pairs.history[1], 0.25e-6, 1e-18);
  EXPECT_EQ(system_of<2>(s).state.spin[0], 0.3);
  write_state_json(s, in_folder("copy.json"));
  const InitialState t = read_state(in_folder("copy.json"));
  EXPECT_NEAR(system_of<2>(t).state.position[1][0], 262, 1e-12);
  EXPECT_NEAR(system_of<2>(t).state.inertia[0], 1800, 1e-10);
  EXPECT_NEAR(*t.material.k, 20, 1e-13);
  EXPECT_NEAR(*t.material.nu, 0.5, 1e-15);
}

TEST_F(StateFile, ReadsTheFinalStateOfARun) {
  FileRecorder to(in_folder("run.h5"), Case{}, "");
  record_sample(to, 5, 3);
  to.value(material_group, {"k", "", ""}, 1 / 3.);
  to.value(material_group, {"keep_viscosity_coefficients_constant", "", ""}, 1);
  to.finish("complete");
  const InitialState s = read_state(in_folder("run.h5"));
  EXPECT_EQ(s.units.name, particleshear_units().name);
  EXPECT_EQ(system_of<2>(s).pairs.history, sample_system(5).pairs.history);
  EXPECT_EQ(system_of<2>(s).step, sample_system(5).step);
  EXPECT_EQ(evaluation_of<2>(s)->force, sample_evaluation(5).force);
  EXPECT_EQ(s.material.k, 1 / 3.);
  EXPECT_EQ(s.material.keep_viscosity_coefficients_constant, true);
  EXPECT_FALSE(s.material.nu);
}

TEST_F(StateFile, ErrorsSayFileAndWhere) {
  EXPECT_THAT(file_error_of([&] { read_state(in_folder("none.json")); }), HasSubstr("No such file"));
  const std::string whole = linked_pair;
  const std::string truncated = file_error_of([&] { read(whole.substr(0, whole.size() / 2)); });
  EXPECT_THAT(truncated, HasSubstr("state.json"));
  EXPECT_THAT(truncated, HasSubstr("as a state (it ends too early, in line "));
  EXPECT_THAT(file_error_of([&] { read("[1, 2]"); }), HasSubstr("is not an object"));

  EXPECT_THAT(error_with("\"initial\"", "\"start\""), HasSubstr("state.json has no \"initial\""));
  EXPECT_THAT(error_with("\"m\": 1.3,\n", ""), HasSubstr("state.json: initial.spheres[1] has no \"m\""));
  EXPECT_THAT(error_with("\"r\": 60", "\"r\": -60"),
              HasSubstr("initial.spheres[0].r is -60.0, not positive"));
  EXPECT_THAT(error_with("\"m\": 1,", "\"m\": 0,"), HasSubstr("initial.spheres[0].m is 0, not positive"));
  EXPECT_THAT(error_with("\"vx\": 9", "\"vx\": 1e999"), HasSubstr("state.json"));
  EXPECT_THAT(error_with("\"vx\": 9", "\"vx\": \"fast\""),
              HasSubstr("initial.spheres[1].vx is not a number"));
  EXPECT_THAT(error_with("\"size_y\": 400", "\"size_y\": 0"), HasSubstr("params.size_y is 0, not positive"));
  EXPECT_THAT(error_with("\"applyingShear\": true", "\"applyingShear\": 1"),
              HasSubstr("is not true or false"));
}

TEST_F(StateFile, InconsistentNeighboursAreErrors) {
  EXPECT_THAT(error_with("\"j\": 2", "\"j\": 3"),
              HasSubstr("neighbors[0][0].j is not the number of another sphere"));
  EXPECT_THAT(error_with("\"j\": 2", "\"j\": 0"),
              HasSubstr("neighbors[0][0].j is not the number of another sphere"));
  EXPECT_THAT(error_with("\"j\": 2", "\"j\": 1.5"), HasSubstr("is not the number of another sphere"));
  EXPECT_THAT(error_with("\"slip\"", "\"glued\""), HasSubstr("is \"glued\", not stick, slip or permanent"));
  EXPECT_THAT(error_with("\"slip\"", "\"stick\""), HasSubstr("spheres 0 and 2 give different types"));
  EXPECT_THAT(error_with("\"eq\": 130", "\"eq\": 120"), HasSubstr("is not the sum of the radii"));
  EXPECT_THAT(error_with(",\\s*\\[\\{\"j\": 0, \"type\": \"slip\"[^]*$", ", []]}}"),
              HasSubstr("do not list each other"));
  EXPECT_THAT(error_with(",\\s*\\[\\{\"j\": 0, \"type\": \"slip\"[^]*$", "]}}"),
              HasSubstr("one list for each sphere"));
  EXPECT_THAT(
      error_with("\\{\"j\": 2", "{\"j\": 1, \"type\": \"permanent\", \"fp\": 0, \"eq\": 130}, {\"j\": 2"),
      HasSubstr("do not list each other exactly once"));
}

}  // namespace
}  // namespace supple
