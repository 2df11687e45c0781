/// Runs with contacts of pairs of species, and runs that go on from them.
#include "supple/experiment/packing.hpp"
#include "supple/experiment/pairs_of_case.hpp"
#include "supple/io/run/run_file.hpp"
#include "tests/io/continued_run.hpp"
#include "tests/io/same_system.hpp"

namespace supple {
namespace {

using ::testing::HasSubstr;

class PairsRun : public testing::ContinuedRun {
 protected:
  static Case mixture(const std::string& more) {
    return testing::case_of(R"(
physics = "deformable"
[[species]]
name = "soft"
N = 6
vertices = 8
[[species]]
name = "stiff"
family = "disc"
N = 4
[contact]
k_c = 0.5
[contact.stiff.soft]
law = "adhesive"
attraction_range = 0.3
k_c = 3
[contact.stiff.stiff]
friction = 0.9
[material]
friction = 0.3
[particles]
permanent_links = false
[jamming]
packing_fraction = 0.6
[output]
images = 0
snapshot = false
plot = false
)" + more);
  }
  static Case dynamics(int steps, const std::string& more = "") {
    return testing::case_of(
        "experiment = \"dynamics\"\nphysics = \"deformable\"\n[time]\nstep = 0.01\nsteps = " +
        std::to_string(steps) + "\n[motion]\nkinetic_energy = 0.01\n" + more);
  }
};

TEST_F(PairsRun, GoesOnWithTheLawsOfThePairs) {
  Case whole = mixture("[time]\nstep = 0.01\nsteps = 60\n[shear]\nrate = \"0.01\"\n");
  whole.general.experiment = "dynamics";
  Case half = whole;
  half.time.steps = 30;
  record("whole.h5", whole);
  record("half.h5", half);
  const Case stored = RunFile(in_folder("half.h5")).resolved_case();
  ASSERT_EQ(stored.pairs.size(), 2u);
  EXPECT_TRUE(stored.is_given("contact.soft.stiff.k_c"));
  EXPECT_FALSE(stored.is_given("contact.stiff.stiff.k_c"));
  EXPECT_EQ(contact_laws(stored).of(0, 1).scale().stiffness, 3);
  EXPECT_EQ(contact_laws(stored).of(1, 1).scale().stiffness, 0.5);

  Case rest = testing::case_of(R"(
experiment = "dynamics"
physics = "deformable"
[time]
step = 0.01
steps = 30
[shear]
rate = "0.01"
[particles]
permanent_links = false
[output]
images = 0
snapshot = false
plot = false
[initial]
keep_time = true
)");
  rest.initial.state = "half.h5";
  record("rest.h5", rest, "half.h5");
  testing::expect_same(system_of<2>(load("rest.h5")), system_of<2>(load("whole.h5")));
  // The file of the second run says it again, for a third one.
  const Case last = RunFile(in_folder("rest.h5")).resolved_case();
  EXPECT_EQ(last.species.size(), 2u);
  EXPECT_EQ(contact_laws(last).of(1, 0).range(), 1.3);
  EXPECT_TRUE(last.is_given("contact.stiff.stiff.friction"));
  EXPECT_FALSE(last.is_given("contact.soft.stiff.friction"));
}

TEST_F(PairsRun, ContinuationMayChangeThemOrWhatTheyDoNotGive) {
  Case first = mixture("");
  first.general.experiment = "jamming";
  InitialState state;
  state.units = reduced_units();
  state.system = make_packing(first, nullptr, 0.3).system;
  state.keys = held_keys(first);
  state.contact = Harmonic{0.5, true};
  const auto laws = [&](const std::string& more) {
    Case c = testing::case_of("experiment = \"compression\"\n" + more);
    c.initial.state = "first.h5";
    c = adopt_state(c, &state);
    check(c, &state);
    make_packing(c, &state, 0);
    return contact_laws(c);
  };
  EXPECT_EQ(laws("").of(0, 1).scale().stiffness, 3);
  EXPECT_EQ(laws("").of(1, 1).scale().stiffness, 0.5);
  EXPECT_EQ(laws("[contact]\nk_c = 7\n").of(0, 1).scale().stiffness, 3);
  EXPECT_EQ(laws("[contact]\nk_c = 7\n").of(1, 1).scale().stiffness, 7);
  EXPECT_EQ(laws("[contact.soft.stiff]\nk_c = 8\n").of(0, 1).scale().stiffness, 8);
  EXPECT_EQ(laws("[contact.soft.stiff]\nk_c = 8\n").of(0, 1).range(), 1.3);
  EXPECT_EQ(laws("[contact.soft.soft]\nk_c = 9\n").of(0, 0).scale().stiffness, 9);
  EXPECT_EQ(laws("[bodies]\nk_a = 2\n").of(0, 1).scale().stiffness, 3);  // stiffnesses are of any particle
  EXPECT_THROW(laws("[contact.soft.sdiff]\nk_c = 9\n"), Error);
  system_of<2>(state).species.clear();
  try {
    laws("");
    ADD_FAILURE() << "no error";
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), HasSubstr("the particles to start from are of no species"));
  }
}

}  // namespace
}  // namespace supple
