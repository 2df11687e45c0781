/// The command on deformable particles in three dimensions.
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/app/command.hpp"
#include "tests/paths.hpp"

namespace supple {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

class SurfaceCommand : public CommandTest {
 protected:
  /// The results of a run of zero steps that starts from the reference of this name.
  json results_of_reference(const std::string& name) {
    write(name + ".toml", "experiment = \"dynamics\"\n[initial]\npacking = \"" + reference_path(name) +
                              "\"\n[time]\nsteps = 0\n[output]\nsnapshot = false"
                              "\nplot = false\n");
    const Outcome run = supple("run " + name + ".toml");
    EXPECT_EQ(run.code, 0) << run.err;
    return shown(name + ".h5")["results"];
  }
  /// Every term has its energy, one without stiffness 0, and there are no others.
  static void expect_sum_of_terms(const json& results) {
    double sum = 0;
    for (const char* term : {"volume", "area", "bending", "tension", "contact"})
      sum += results[std::string("energy_") + term]["value"].get<double>();
    for (const char* term : {"energy_wall", "energy_external"})
      if (results.contains(term)) sum += results[term]["value"].get<double>();
    EXPECT_NEAR(sum, results["energy"]["value"].get<double>(), 1e-13);
  }
  static json expected_of(const std::string& name) {
    return json::parse(read_text(reference_path(name)))["expected"];
  }
  static std::string reference_path(const std::string& name) {
    return std::string(SUPPLE_TEST_DATA) + "/surfaces/" + name + ".json";
  }
  json shown(const std::string& run) { return json::parse(supple("show " + run + " --json").out); }
};

/// What an independent program found for each packing, from a run of zero steps that starts from its file:
/// energies by term, stress and pressure in the units of the file (tests/data/surfaces).
TEST_F(SurfaceCommand, ARunOfNoStepsHasTheNumbersOfTheReferences) {
  for (const std::string name : {"shells4_12_rough", "shells4_42_rough", "shells4_42_smooth"}) {
    SCOPED_TRACE(name);
    const json reference = expected_of(name), results = results_of_reference(name);
    const auto result = [&](const std::string& key) { return results[key]["value"].get<double>(); };

    double largest = 0;
    for (const auto& [term, energy] : reference["energy"].items())
      largest = std::max(largest, std::abs(energy.get<double>()));
    for (const auto& [term, energy] : reference["energy"].items())
      EXPECT_NEAR(result("energy_" + term), energy.get<double>(), 1e-10 * largest) << term;
    largest = 0;
    for (const auto& row : reference["stress"])
      for (const double s : row) largest = std::max(largest, std::abs(s));
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j)
        EXPECT_NEAR(result(std::string("stress_") + "xyz"[i] + "xyz"[j]), reference["stress"][i][j],
                    1e-10 * largest);
    EXPECT_NEAR(result("pressure"), reference["pressure"], 1e-10 * largest);
  }
}

/// Its vertices are thinner than edges need: it may be looked at, and not moved.
TEST_F(SurfaceCommand, ARunOfNoStepsWarnsOfUncoveredEdges) {
  const std::string thin = "shells4_12_rough";
  results_of_reference(thin);
  EXPECT_THAT(supple("show " + thin + ".h5").out, HasSubstr("particles have an edge longer"));
  results_of_reference("shells4_42_smooth");
  EXPECT_THAT(supple("show shells4_42_smooth.h5").out, testing::Not(HasSubstr("have an edge longer")));
  const Outcome moved = supple("run " + thin + ".toml --set time.steps=1 --force");
  EXPECT_EQ(moved.code, 2);
  EXPECT_THAT(moved.err, HasSubstr("take at least 0.707 of the longest edge"));
}

/// A particle alone, at rest.
TEST_F(SurfaceCommand, ARunOfNoStepsHasTheNumbersOfSingleParticles) {
  for (const std::string name : {"single_shell_42", "single_floppy_42", "single_droplet_42"}) {
    SCOPED_TRACE(name);
    const json reference = expected_of(name), results = results_of_reference(name);
    EXPECT_NEAR(results["energy"]["value"], reference["energy"], 1e-12);
    expect_sum_of_terms(results);
    EXPECT_NEAR(results["mean_shape_parameter"]["value"], reference["shape_parameter"], 1e-10);
    EXPECT_LT(results["residual"]["value"], 1e-12);
  }
}

/// The example of docs/packing_json.md moves.
TEST_F(SurfaceCommand, ThePackingOfTheDocumentRuns) {
  const std::string text = read_text(std::string(SUPPLE_SOURCE_DIR) + "/docs/packing_json.md"),
                    fence = "```json\n";
  const auto begin =
      text.find(fence, text.find("## Surfaces and a sphere in a sheared cell\n")) + fence.size();
  write("example.json", text.substr(begin, text.find("```", begin) - begin));
  write("move.toml",
        "experiment = \"dynamics\"\n[initial]\npacking = \"example.json\"\n[time]\nsteps = 50\n");
  const Outcome run = supple("run move.toml");
  EXPECT_EQ(run.code, 0) << run.err;
  const json results = shown("move.h5")["results"];
  EXPECT_GT(results["energy_contact"]["value"], 0);
  expect_sum_of_terms(results);
  write("box.json",
        R"({"k_v": 1, "k_a": 1, "k_b": 0, "k_c": 1, "contact": "rough", "box": [2, 2, 2], "gravity": 0.1,
    "periodic": [false, false, false], "particles": [{"sigma": 1, "x": [[0.4, 0.3, 1]]}]})");
  write("box.toml", "experiment = \"dynamics\"\n[initial]\npacking = \"box.json\"\n[time]\nsteps = 0\n");
  EXPECT_EQ(supple("run box.toml").code, 0);
  const json walled = shown("box.h5")["results"];
  EXPECT_GT(walled["energy_wall"]["value"], 0);
  EXPECT_NE(walled["energy_external"]["value"], 0);
  expect_sum_of_terms(walled);
}

TEST_F(SurfaceCommand, AreJammedShownDrawnAndExported) {
  write("jam.toml",
        "experiment = \"jamming\"\n[bodies]\ndim = 3\nN = 4\nvertices = 12\n[jamming]\n"
        "packing_fraction = 0.05\npressure = 1e-3\n");
  const Outcome run = supple("run jam.toml");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(exists("jam.h5") && exists("jam_pressure.png") && exists("jam_cell.png"));
  EXPECT_THAT(run.out, HasSubstr("4 particles (shell), 4 of them surfaces, with 48 vertices"));
  const json j = shown("jam.h5");
  EXPECT_EQ(j["surfaces"], 4);
  EXPECT_EQ(j["results"]["pressure"]["unit"], "k_v v0");
  for (const char* command : {"snapshot jam.h5 --view x --color pressure -o x.png", "export jam.h5 --to vtp",
                              "export jam.h5 --to xyz", "export jam.h5 --to csv",
                              "export jam.h5 --to contacts", "export jam.h5 --to packing"}) {
    const Outcome done = supple(command);
    EXPECT_EQ(done.code, 0) << command << done.err;
  }
  EXPECT_EQ(supple("export jam.h5 --to state").code, 2);
  EXPECT_THAT(supple("snapshot jam.h5 --view top -o y.png").err, HasSubstr("top"));
  EXPECT_EQ(supple("snapshot jam.h5 --view x --color pressure --edges -o edges.png").code, 0);
  EXPECT_NE(read_text(path("edges.png")), read_text(path("x.png")));
}

TEST_F(SurfaceCommand, MistakesAreErrorsBeforeAnythingIsWritten) {
  write("jam.toml", "experiment = \"jamming\"\n[bodies]\ndim = 3\nvertices = 50\n");
  const Outcome run = supple("run jam.toml");
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, AllOf(HasSubstr("jam.toml"), HasSubstr("bodies.vertices = 50"), HasSubstr("take 42")));
  EXPECT_EQ(entries(), 1);
}

}  // namespace
}  // namespace supple
