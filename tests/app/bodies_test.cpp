/// The command on deformable particles.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "supple/io/run/run_file.hpp"
#include "tests/app/command.hpp"
#include "tests/paths.hpp"

namespace supple {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

class Bodies : public CommandTest {
 protected:
  /// Six octagons that jam in a second.
  void write_jamming(const std::string& output = "plot = false\nsnapshot = false\n") {
    write("jam.toml",
          "experiment = \"jamming\"\n[bodies]\nN = 6\nvertices = 8\n[jamming]\npacking_fraction = 0.5\n"
          "pressure = 1e-4\nstep = 0.01\n[output]\n" +
              output);
  }
  void make_jammed() {
    write_jamming();
    const Outcome run = supple("run jam.toml");
    ASSERT_EQ(run.code, 0) << run.err;
  }
  json shown(const std::string& run) { return json::parse(supple("show " + run + " --json").out); }
  double result(const json& run, const std::string& name) { return run["results"][name]["value"]; }
};

TEST_F(Bodies, JammingLeavesItsRunAndPictures) {
  write_jamming("");
  const Outcome run = supple("run jam.toml");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(entries(), 4);
  EXPECT_TRUE(exists("jam.h5") && exists("jam_pressure.png") && exists("jam_cell.png"));
  EXPECT_THAT(run.out, HasSubstr("6 particles (shell), 6 of them polygons, with 48 vertices"));
  EXPECT_THAT(run.out, HasSubstr("packing_fraction"));
  for (const std::string of_microgels : {" um", "G'", "discs", "Pa"})
    EXPECT_THAT(run.out, Not(HasSubstr(of_microgels)));
}

TEST_F(Bodies, ShowGivesResultsWithUnits) {
  make_jammed();
  const json run = shown("jam.h5");
  EXPECT_EQ(run["particles"], 6);
  EXPECT_EQ(run["polygons"], 6);
  EXPECT_EQ(run["vertices"], 48);
  EXPECT_EQ(run["family"], "shell");
  EXPECT_EQ(run["results"]["pressure"]["unit"], "k_a a0");
  EXPECT_GT(result(run, "pressure"), 1e-4);
  EXPECT_LT(result(run, "pressure"), 1.01e-4);
  EXPECT_GT(result(run, "packing_fraction"), 0.6);
  EXPECT_LE(result(run, "residual"), result(run, "tolerance"));
  EXPECT_LE(result(run, "rattlers"), 6);
  EXPECT_GT(result(run, "mean_contacts"), 2);
}

TEST_F(Bodies, SnapshotsAreColouredByANumber) {
  make_jammed();
  for (const std::string color : {"pressure", "shape_parameter", "contacts", "id"})
    EXPECT_EQ(supple("snapshot jam.h5 --color " + color + " -o " + color + ".svg").code, 0);
  EXPECT_NE(read_text(path("pressure.svg")), read_text(path("contacts.svg")));
  EXPECT_EQ(supple("snapshot jam.h5 --frame 0 -o first.pdf").code, 0);
  const Outcome wrong = supple("snapshot jam.h5 --color presure -o x.svg");
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("did you mean 'pressure'?"));
  EXPECT_FALSE(exists("x.svg"));
}

TEST_F(Bodies, ExportsAreReadByOthers) {
  make_jammed();
  for (const std::string to : {"xyz", "vtp", "csv", "packing"}) {
    const Outcome done = supple("export jam.h5 --to " + to);
    EXPECT_EQ(done.code, 0) << to << ": " << done.err;
    EXPECT_EQ(supple("export jam.h5 --to " + to).code, 4) << to << " overwrites";
  }
  EXPECT_THAT(read_text(path("jam.xyz")), testing::StartsWith("48\nLattice="));
  const std::string csv = read_text(path("jam.csv"));
  EXPECT_THAT(csv, testing::StartsWith("packing_fraction,pressure ["));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), RunFile(path("jam.h5").string()).rows("packing") + 1);
  const std::string read = "/usr/bin/python3 '" SUPPLE_SOURCE_DIR "/tests/io/read_vtp.py' '" +
                           path("jam_frames/frame0000000.vtp").string() + "' >'" +
                           path("mesh.json").string() + "'";
  ASSERT_EQ(std::system(read.c_str()), 0);
  EXPECT_EQ(json::parse(read_text(path("mesh.json")))["polygons"].size(), 6u);
  EXPECT_THAT(read_text(path("jam.pvd")), HasSubstr("jam_frames/frame0000000.vtp"));
  EXPECT_EQ(json::parse(read_text(path("jam_packing.json")))["particles"].size(), 6u);
}

TEST_F(Bodies, FormatsOfDiscsAreRefused) {
  make_jammed();
  for (const std::string to : {"state", "text"}) {
    const Outcome refused = supple("export jam.h5 --to " + to);
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.err, HasSubstr("holds deformable particles"));
  }
  EXPECT_EQ(supple("run jam.toml -o text.h5 --set output.text=true").code, 2);
  EXPECT_EQ(entries(), 2);
}

/// energy and stress are those that an independent program found.
TEST_F(Bodies, AStoredPackingIsEvaluatedAsItIs) {
  const std::string file = SUPPLE_TEST_DATA "/packings/shells16_10_14.json";
  write("look.toml", "experiment = \"dynamics\"\n[initial]\npacking = \"" + file + "\"\n[time]\nsteps = 0\n");
  const Outcome done = supple("run look.toml");
  ASSERT_EQ(done.code, 0) << done.err;
  const json run = shown("look.h5"), expected = json::parse(read_text(file))["expected"];
  double energy = 0;
  for (const auto& [name, part] : expected["energy"].items()) energy += part.get<double>();
  const double unit = run["constants"]["pressure_unit"]["value"];
  const auto near = [](double found, double wanted) { EXPECT_NEAR(found, wanted, 1e-9 * std::abs(wanted)); };
  near(result(run, "energy"), energy);
  near(result(run, "pressure") * unit, expected["pressure"]);
  near(result(run, "contact_pressure") * unit, expected["pressure_contact"]);
  near(result(run, "stress_xx") * unit, expected["stress"][0][0]);
  near(result(run, "stress_yy") * unit, expected["stress"][1][1]);
  EXPECT_EQ(result(run, "vertex_contacts"), expected["vertex_contacts"]);
  EXPECT_EQ(run["particles"], 16);
  EXPECT_FALSE(run.contains("family"));
  EXPECT_FALSE(exists("look_energy.png"));
}

TEST_F(Bodies, TheCaseWinsOverAStoredPacking) {
  const std::string file = SUPPLE_TEST_DATA "/packings/shells16_10_14.json";
  write("look.toml", "experiment = \"dynamics\"\n[initial]\npacking = \"" + file +
                         "\"\n[time]\nsteps = 0\n[output]\nsnapshot = false\n");
  const auto energy = [&](const std::string& name, const std::string& set) {
    EXPECT_EQ(supple("run look.toml -o " + name + set).code, 0);
    return result(shown(name), "energy");
  };
  const json parts = json::parse(read_text(file))["expected"]["energy"];
  const double base = energy("a.h5", "");
  const double bend = parts["bend"], touch = parts["contact"], area = parts["area"];
  EXPECT_NEAR(energy("b.h5", " --set bodies.k_b=0.02"), base + bend, 1e-9 * bend);
  EXPECT_NEAR(energy("c.h5", " --set contact.k_c=3"), base + 2 * touch, 1e-8 * touch);
  EXPECT_NEAR(energy("d.h5", " --set bodies.k_a=2"), base + area, 1e-7 * area);
  EXPECT_EQ(RunFile(path("a.h5").string()).resolved_case().bodies.k_b, 0.01);
  EXPECT_NEAR(RunFile(path("a.h5").string()).resolved_case().bodies.k_a, 1, 1e-12);
}

TEST_F(Bodies, APackingOfARunStartsTheSameAgain) {
  make_jammed();
  ASSERT_EQ(supple("export jam.h5 --to packing").code, 0);
  const json before = shown("jam.h5");
  const std::string rest = " --set time.steps=0 --set output.snapshot=false";
  write("look.toml", "experiment = \"dynamics\"\nphysics = \"deformable\"\n");
  ASSERT_EQ(supple("run look.toml -o a.h5 --set initial.packing=jam_packing.json" + rest).code, 0);
  ASSERT_EQ(supple("run look.toml -o b.h5 --set initial.state=jam.h5" + rest).code, 0);
  EXPECT_NEAR(result(shown("a.h5"), "pressure"), result(before, "pressure"), 1e-9 * 1e-4);
  EXPECT_EQ(result(shown("b.h5"), "pressure"), result(before, "pressure"));
}

TEST_F(Bodies, StatesOfOtherThingsAreRefused) {
  make_jammed();
  write("discs.toml",
        "experiment = \"dynamics\"\nphysics = \"documented\"\n[initial]\nstate = \"jam.h5\"\n[time]\nsteps = "
        "5\n");
  const Outcome discs = supple("run discs.toml");
  EXPECT_EQ(discs.code, 2);
  EXPECT_THAT(discs.err, HasSubstr("set physics = \"deformable\""));
  write_small_case();
  ASSERT_EQ(supple("run small.toml").code, 0);
  const Outcome bodies = supple("run jam.toml -o x.h5 --set initial.state=small.h5");
  EXPECT_EQ(bodies.code, 2);
  EXPECT_THAT(bodies.err, HasSubstr("holds discs of microgels"));
  EXPECT_EQ(supple("snapshot small.h5 --color pressure -o x.png").code, 2);
  EXPECT_EQ(supple("export small.h5 --to packing").code, 2);
  EXPECT_EQ(supple("export small.h5 --to xyz").code, 0);
}

TEST_F(Bodies, InitShowsOnlyWhatTheExperimentReads) {
  for (const std::string experiment : {"jamming", "compression", "uniaxial_compression", "slump"}) {
    ASSERT_EQ(supple("init " + experiment).code, 0);
    const std::string text = read_text(path(experiment + ".toml"));
    EXPECT_THAT(text, HasSubstr("[bodies]"));
    for (const std::string section : {"[material]", "[particles]", "[shear]"})
      EXPECT_THAT(text, Not(HasSubstr(section)));
    EXPECT_EQ(text.find("[slump]") != text.npos, experiment == "slump");
    const Outcome check = supple("check " + experiment + ".toml");
    EXPECT_EQ(check.code, 0) << check.err;
    EXPECT_THAT(check.out, HasSubstr(experiment + " of 64 particles (shell), seed 1"));
    EXPECT_THAT(check.out, Not(HasSubstr("warning")));
  }
}

TEST_F(Bodies, InitMakesAPairThatSlides) {
  ASSERT_EQ(supple("init friction").code, 0);
  const Outcome check = supple("check friction.toml");
  EXPECT_EQ(check.code, 0) << check.err;
  EXPECT_THAT(check.out, HasSubstr("friction of 2 particles (shell), seed 1"));
  EXPECT_THAT(check.out, Not(HasSubstr("warning")));
  EXPECT_EQ(supple("run friction.toml --set sliding.step=0.1").code, 0);
}

TEST_F(Bodies, InitKnowsTheDynamicsOfPolygons) {
  ASSERT_EQ(supple("init dynamics --physics deformable").code, 0);
  const std::string text = read_text(path("dynamics.toml"));
  EXPECT_THAT(text, HasSubstr("[bodies]"));
  EXPECT_THAT(text, Not(HasSubstr("young_modulus")));
  const Outcome check = supple("check dynamics.toml");
  EXPECT_EQ(check.code, 0) << check.err;
  EXPECT_THAT(check.out, Not(HasSubstr("warning")));
  EXPECT_THAT(supple("check dynamics.toml --set jamming.pressure=1e-3").err,
              HasSubstr("jamming.pressure has no effect"));
  EXPECT_EQ(supple("init jamming --physics documented").code, 2);
}

TEST_F(Bodies, RandomParticlesThatDoNotFitAreRefused) {
  ASSERT_EQ(supple("init uniaxial_compression").code, 0);
  const Outcome run = supple("run uniaxial_compression.toml --set uniaxial.packing_fraction=0.94");
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, HasSubstr("inside another one, or vertices of them are"));
}

TEST_F(Bodies, MotionsAreDrawn) {
  write("m.toml",
        "experiment = \"dynamics\"\nphysics = \"deformable\"\n[bodies]\nN = 6\nvertices = 8\n[jamming]\n"
        "packing_fraction = 0.4\n[motion]\nkinetic_energy = 1e-4\n[time]\nsteps = 50\n[output]\nframes = 5\n"
        "images = 2\n");
  const Outcome run = supple("run m.toml");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(exists("m_energy.png") && exists("m_cell.png") && exists("m_images/image0000001.png"));
}

}  // namespace
}  // namespace supple
