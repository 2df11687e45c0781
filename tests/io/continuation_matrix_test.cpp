/// What a user can go on with: each experiment from each kind of file either goes on right or is refused with
/// a reason.
#include "supple/io/run/run_file.hpp"
#include "tests/io/continued_run.hpp"
#include "tests/io/same_system.hpp"

namespace supple {
namespace {

using namespace supple::testing;
using ::testing::HasSubstr;

/// Files of every kind, made once.
class ContinuationMatrix : public ContinuedRun {
 protected:
  /// Forces of `state` as a run finds them that does not move it.
  Evaluation<2> forces_from(const std::string& state, const std::string& more = "") const {
    const InitialState initial = load(state);
    MemoryRecorder recorder;
    run(case_of("experiment = \"dynamics\"\n[time]\nsteps = 0\n" + more), &initial, recorder);
    return recorder.last_evaluation;
  }
  void expect_same_forces(const std::string& run_name, const std::string& more) const {
    const InitialState whole = load(run_name);
    const Evaluation<2> of_run = forces_from(run_name, more), of_json = forces_from(exported(run_name), more);
    ASSERT_TRUE(whole.evaluation);
    double largest = 0;
    for (const Vec2& f : evaluation_of<2>(whole)->force) largest = std::max(largest, norm(f));
    EXPECT_GT(largest, 0);
    // Rounding of the JSON's numbers is that of a length of the cell, times the stiffness of a contact.
    const double stiff = whole.material.k ? *whole.material.k * system_of<2>(whole).box.length[0] : 1;
    EXPECT_EQ(system_of<2>(load(exported(run_name))).state.mobility, system_of<2>(whole).state.mobility)
        << run_name;
    for (std::size_t i = 0; i < of_run.force.size(); ++i) {
      EXPECT_EQ(of_run.force[i], evaluation_of<2>(whole)->force[i]) << run_name << " " << i;
      EXPECT_NEAR(norm(of_run.force[i] - of_json.force[i]) / stiff, 0, 1e-12) << run_name << " " << i;
    }
  }

  void make_files() const {
    record("jam.h5", case_of(R"(experiment = "jamming"
[bodies]
N = 8
vertices = 8
[contact]
kind = "smooth"
[jamming]
packing_fraction = 0.5
step = 0.01
pressure = 1e-3)"));
    record("rigid.h5", case_of(R"(experiment = "jamming"
[bodies]
family = "rough_disc"
N = 8
vertices = 8
[jamming]
packing_fraction = 0.5
step = 0.01
pressure = 1e-3)"));
    record("linked.h5", case_of(R"(experiment = "oscillatory_shear"
physics = "deformable"
[bodies]
N = 6
vertices = 8
[particles]
cut_lines = 0
[jamming]
packing_fraction = 0.4
step = 0.02
pressure = 1e-2
[shear]
relative_frequency = 0.2
pre_periods = 0
periods = 1
post_periods = 0)"));
    record("box.h5", case_of(R"(experiment = "uniaxial_compression"
[bodies]
N = 6
vertices = 8
[contact]
k_p = 2
[uniaxial]
strain = 0.02
step = 0.01)"));
    record("heap.h5", case_of(R"(experiment = "slump"
[bodies]
N = 5
vertices = 8
[contact]
floor_friction = 0.3
[slump]
gravity = 1e-3
width = 3
settle_time = 12
spread_time = 2)"));
    // The package's velocities follow the shear rate when forces are evaluated: it rests.
    for (const std::string physics : {"documented", "particleshear-1.0.2"})
      record(physics == "documented" ? "gel.h5" : "package.h5",
             case_of("experiment = \"dynamics\"\nphysics = \"" + physics + R"("
[material]
elastic_law = "plateau"
tensile_law = "saturating"
[particles]
N = 24
cut_lines = 0
[box]
plates = "none"
[shear]
rate = ")" + (physics == "documented" ? "2000*cos(3000*t)" : "0") +
                     R"("
[time]
steps = 60)"));
    record("plates.h5", case_of(R"x(experiment = "dynamics"
[particles]
N = 24
cut_lines = 0
[shear]
rate = "2000*cos(3000*t)"
[time]
steps = 60)x"));
  }
};

TEST_F(ContinuationMatrix, EachStateActsAsItDid) {
  make_files();
  for (const std::string file : {"jam.h5", "rigid.h5", "box.h5", "heap.h5", "package.h5"})
    expect_same_forces(file, "");
  // Dashpots see the flow of this instant: where the rate jumps, its change acts on them at once.
  for (const std::string file : {"gel.h5", "plates.h5"})
    expect_same_forces(file, "[initial]\nkeep_time = true\n[shear]\nrate = \"2000*cos(3000*t)\"\n");
}

TEST_F(ContinuationMatrix, LinksGoOnInAStateAndAreNotLostInAPacking) {
  make_files();
  const InitialState whole = load("linked.h5");
  ASSERT_GT(system_of<2>(whole).links.size(), 0u);
  ASSERT_TRUE(whole.evaluation);
  const Evaluation<2> again = forces_from("linked.h5", "[shear]\nrate = \"1e-9 + t\"\n");
  for (std::size_t i = 0; i < again.force.size(); ++i)
    EXPECT_EQ(again.force[i], evaluation_of<2>(whole)->force[i]) << i;
  try {
    exported("linked.h5");
    FAIL();
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), HasSubstr("crosslinked"));
  }
}

TEST_F(ContinuationMatrix, EachExperimentGoesOnOrSaysWhyNot) {
  make_files();
  const std::string linked = "holds crosslinked particles", microgel = "holds discs of microgels",
                    periodic = "is periodic", walls = "lies between walls", open = "lies under gravity",
                    made = "is prepared already", other = "is about discs of microgels";
  // One column for each experiment; empty: it goes on.
  const std::vector<std::string> experiments{"oscillatory_shear",    "dynamics", "jamming",    "compression",
                                             "uniaxial_compression", "slump",    "preparation"};
  const std::map<std::string, std::vector<std::string>> matrix{
      {"gel.h5", {"", "", microgel, microgel, microgel, microgel, made}},
      {"package.h5", {"", "", microgel, microgel, microgel, microgel, made}},
      {"jam.h5", {"", "", "", "", periodic, "", other}},
      {"rigid.h5", {"", "", "", "", periodic, "", other}},
      {"box.h5", {walls, "", walls, walls, "", "", other}},
      {"heap.h5", {walls, "", walls, walls, open, "", other}},
      {"linked.h5", {"", linked, linked, linked, periodic, linked, other}}};
  for (const auto& [run_name, reasons] : matrix)
    for (const std::string& file : run_name == "linked.h5" ? std::vector{run_name}  // no JSON holds links
                                                           : std::vector{run_name, exported(run_name)})
      for (std::size_t k = 0; k < experiments.size(); ++k) {
        const std::string error =
            error_from(case_of("experiment = \"" + experiments[k] + "\"\n" +
                               (experiments[k] == "dynamics" ? "[time]\nsteps = 3\n" : "")),
                       file);
        if (reasons[k].empty()) EXPECT_EQ(error, "") << file << " to " << experiments[k];
        else EXPECT_THAT(error, HasSubstr(reasons[k])) << file << " to " << experiments[k];
      }
}

/// Contact kind, elastic and tensile law, plates, friction, stiffness: a case that says nothing of them
/// changes none, whatever experiment goes on.
TEST_F(ContinuationMatrix, WhateverGoesOnKeepsTheLawsOfItsState) {
  make_files();
  int continuations = 0, kept = 0;
  for (const std::string file :
       {"gel.h5", "package.h5", "plates.h5", "jam.h5", "rigid.h5", "linked.h5", "box.h5", "heap.h5"}) {
    const HeldKeys held = laws_of(held_keys(RunFile(in_folder(file)).resolved_case()));
    const InitialState initial = load(file);
    for (const std::string& experiment : experiment_names()) {
      Case c = case_of("experiment = \"" + experiment + "\"\n");
      c.initial.state = file;
      try {
        c = adopt_state(c, &initial);
      } catch (const Error&) {  // such particles are not for this experiment
        continue;
      }
      ++continuations;
      const HeldKeys now = laws_of(held_keys(c));
      for (const auto& [key, value] : held)
        if (const auto at = now.find(key); at != now.end()) {
          EXPECT_EQ(shown(at->second), shown(value)) << file << " to " << experiment << ": " << key;
          ++kept;
        }
      if (file == "jam.h5") {
        EXPECT_EQ(c.contact.kind, "smooth") << experiment;
      }
      if (file == "gel.h5") {
        EXPECT_EQ(c.material.elastic_law + " " + c.material.tensile_law + " " + c.box.plates,
                  "plateau saturating none")
            << experiment;
      }
    }
  }
  EXPECT_GE(continuations, 30);
  EXPECT_GE(kept, 300);
}

TEST_F(ContinuationMatrix, ARunSplitInTwoHasTheBitsOfTheWhole) {
  make_files();
  for (const std::string file :
       {"jam.h5", "rigid.h5", "box.h5", "heap.h5", "gel.h5", "plates.h5", "package.h5"}) {
    const auto steps = [&](int n) {
      return case_of("experiment = \"dynamics\"\n[initial]\nkeep_time = true\n[time]\nsteps = " +
                     std::to_string(n));
    };
    record("whole.h5", steps(40), file);
    record("first.h5", steps(15), file);
    record("second.h5", steps(25), "first.h5");
    const InitialState a = load("whole.h5"), b = load("second.h5");
    EXPECT_EQ(system_of<2>(a).state.position, system_of<2>(b).state.position) << file;
    EXPECT_EQ(system_of<2>(a).state.velocity, system_of<2>(b).state.velocity) << file;
    EXPECT_EQ(system_of<2>(a).time, system_of<2>(b).time) << file;
    EXPECT_EQ(system_of<2>(a).step, system_of<2>(b).step) << file;
    EXPECT_EQ(evaluation_of<2>(a)->force, evaluation_of<2>(b)->force) << file;
    EXPECT_EQ(a.keys, b.keys) << file;
    EXPECT_EQ(a.protocol, b.protocol) << file << ": the sum of removed jumps, too";
    EXPECT_EQ(a.environment.stands, b.environment.stands) << file;
  }
}

/// With friction.
TEST_F(ContinuationMatrix, AShearedRunSplitInTwoHasTheBitsOfTheWhole) {
  make_files();
  for (const std::string file : {"jam.h5", "rigid.h5"}) {
    const auto steps = [&](int n) {
      return case_of(
          "experiment = \"dynamics\"\n[initial]\nkeep_time = true\n[shear]\nrate = "
          "\"0.05 + 0*t\"\n[material]\nfriction = 0.3\n[time]\nstep = 0.05\nsteps = " +
          std::to_string(n));
    };
    record("whole.h5", steps(150), file);
    record("first.h5", steps(70), file);
    record("second.h5", steps(80), "first.h5");
    const InitialState a = load("whole.h5"), b = load("second.h5");
    EXPECT_GT(system_of<2>(a).lag, 0);
    EXPECT_FALSE(system_of<2>(a).touches.rows.empty());
    expect_same(system_of<2>(a), system_of<2>(b));
    EXPECT_EQ(evaluation_of<2>(a)->force, evaluation_of<2>(b)->force) << file;
  }
}

TEST_F(ContinuationMatrix, AHeapKeepsItsWallsWeightFrictionAndDrag) {
  make_files();
  for (const std::string& file : {std::string("heap.h5"), exported("heap.h5")}) {
    const InitialState initial = load(file);
    EXPECT_FALSE(initial.environment.stands[flow][1]) << "the right wall was taken away";
    EXPECT_FALSE(initial.environment.stands[gradient][1]);
    EXPECT_EQ(initial.environment.gravity, (Vec3{0, -1e-3}));
    const Case c = adopt_state(case_of("experiment = \"dynamics\"\n"), &initial);
    EXPECT_EQ(c.contact.floor_friction, 0.3);
    EXPECT_NEAR(c.motion.damping, std::sqrt(1e-3), 1e-15);
    EXPECT_EQ(c.general.physics, "deformable");
  }
}

TEST_F(ContinuationMatrix, MotionThatTheCaseNamesIsGivenBetweenWallsThatHold) {
  make_files();
  for (const std::string& file : {std::string("box.h5"), exported("box.h5")}) {
    // Faster than the pressure of the box, which alone would carry the particles away.
    record("moved.h5", case_of(R"(experiment = "dynamics"
[motion]
kinetic_energy = 1e-3
[time]
steps = 3000)"),
           file);
    const System<2> s = system_of<2>(load("moved.h5"));
    EXPECT_NE(s.state.velocity[0], Vec2{});
    for (const Vec2& x : s.state.position)
      for (int d = 0; d < 2; ++d) {
        EXPECT_GT(x[d], -0.1) << file;
        EXPECT_LT(x[d], s.box.length[d] + 0.1) << file;
      }
  }
}

}  // namespace
}  // namespace supple
