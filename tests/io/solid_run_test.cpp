/// Runs of deformable particles in three dimensions, from their case to their file.

#include "supple/experiment/packing_record.hpp"
#include "supple/io/run/run_pictures.hpp"
#include "tests/io/continued_run.hpp"
#include "tests/io/same_system.hpp"

namespace supple {
namespace {

using namespace testing;
using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr const char* shells = R"(
experiment = "jamming"
seed = 4
[bodies]
dim = 3
N = 4
vertices = 12
[jamming]
pressure = 1e-3
packing_fraction = 0.05
)";

class SolidRun : public ContinuedRun {
 protected:
  /// The error of the command with this case.
  std::string error_of(const std::string& text) const {
    try {
      const Case c = case_of(text);
      check(c);
      derive(c, nullptr);
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::input);
      return e.what();
    }
    return "";
  }
};

TEST_F(SolidRun, ItsFileHoldsWhatItEndedWith) {
  const Case c = case_of(shells);
  MemoryRecorderOf<3> memory;
  run(c, nullptr, memory);
  record("run.h5", c);
  const RunFile file(in_folder("run.h5"));
  EXPECT_EQ(file.dimensions(), 3);
  EXPECT_EQ(file.status(), "complete");
  const auto [system, evaluation] = file.final_state<3>();
  drop_open(memory.last_system.pairs, memory.last_system.state.size());  // as files do
  expect_same(system, memory.last_system);
  EXPECT_TRUE(same_bits(evaluation.force, memory.last_evaluation.force));
  const RunInfo<3> info = file.info<3>();
  EXPECT_EQ(info.facet, system.topology.facet);
  EXPECT_EQ(info.body_begin, system.topology.begin);
  EXPECT_EQ(info.radius, system.state.radius);
  EXPECT_EQ(topology_of(info).facet_begin, system.topology.facet_begin);
  const Frame<3> last = file.frame<3>(file.frames() - 1);
  EXPECT_TRUE(same_bits(last.position, system.state.position));
  EXPECT_EQ(last.length, system.box.length);
  EXPECT_FALSE(last.contacts.empty());
  for (const ContactRow<3>& row : last.contacts) EXPECT_NEAR(norm(row.force), row.normal_force, 1e-15);
  for (const char* name : {"volume", "pressure", "stress_zz", "stress_xz", "contacts"})
    EXPECT_EQ(last.body.at(name).size(), 4u) << name;
}

/// By term, and of the whole: what the frame and the energy of the state say.
TEST_F(SolidRun, ResultsAddUp) {
  MemoryRecorderOf<3> r;
  run(case_of(shells), nullptr, r);
  const auto result = [&](const std::string& name) { return r.get("results", name); };
  const double sum =
      result("energy_volume") + result("energy_area") + result("energy_bending") + result("energy_contact");
  EXPECT_NEAR(sum, result("energy"), 1e-12 * result("energy"));
  EXPECT_GT(result("energy_volume"), 0);
  EXPECT_GT(result("energy_bending"), 0);
  EXPECT_NEAR((result("stress_xx") + result("stress_yy") + result("stress_zz")) / 3, result("pressure"),
              1e-12 * result("pressure"));
  EXPECT_NEAR(result("pressure"), 1.005e-3, 0.005e-3);
  EXPECT_NEAR(result("mean_shape_parameter"), 1.09, 0.03);
  const std::vector<double>& volume = r.frames.back().body.at("volume");
  double covered = 0;
  for (const double v : volume) covered += v;
  EXPECT_NEAR(covered / r.last_system.box.volume(), result("packing_fraction"), 1e-9);
  EXPECT_EQ(r.get("constants", "bodies"), 4);
  EXPECT_EQ(r.get("constants", "cell_depth"), r.get("constants", "cell_width"));
}

TEST_F(SolidRun, GoesOnFromItsFile) {
  record("run.h5", case_of(shells));
  const std::string tighter = "experiment = \"jamming\"\n[jamming]\npressure = 2e-3\n";
  record("next.h5", case_of(tighter), "run.h5");
  const RunFile next(in_folder("next.h5"));
  EXPECT_EQ(next.dimensions(), 3);
  EXPECT_EQ(next.resolved_case().bodies.dimensions, 3);
  EXPECT_NEAR(next.value("results", "pressure"), 2.01e-3, 0.01e-3);
  EXPECT_THAT(error_from(case_of("experiment = \"slump\"\n"), "run.h5"),
              AllOf(HasSubstr("bodies.dim = 3 with experiment = \"slump\""), HasSubstr("jamming")));
}

TEST_F(SolidRun, ReadAsOfTwoDimensionsItIsAnError) {
  record("run.h5", case_of(shells));
  const RunFile file(in_folder("run.h5"));
  for (const auto& read :
       {std::function<void()>([&] { file.info(); }), {[&] { file.frame(0); }}, {[&] { file.final_state(); }}})
    EXPECT_THAT(file_error_of(read), HasSubstr("is a run in three dimensions"));
}

TEST_F(SolidRun, IsDrawnFromAnyDirection) {
  record("run.h5", case_of(shells));
  const RunFile file(in_folder("run.h5"));
  draw_frame(in_folder("a.png"), file, 0);
  draw_frame(in_folder("b.png"), file, 0, {"pressure", "30,10"});
  EXPECT_NE(content_of(in_folder("a.png")), content_of(in_folder("b.png")));
  EXPECT_EQ(draw_frames(folder(), "png", file, 1, {"volume", "z"}), 1);
  EXPECT_THROW(draw_frame(in_folder("d.png"), file, 0, {"area"}), Error);
  EXPECT_THROW(draw_frame(in_folder("d.png"), file, 0, {"", "above"}), Error);
}

TEST_F(SolidRun, MistakesInItsCaseAreNamed) {
  const std::string head = "experiment = \"jamming\"\n[bodies]\ndim = 3\n";
  EXPECT_THAT(error_of(head + "vertices = 43\n"),
              AllOf(HasSubstr("bodies.vertices = 43"), HasSubstr("take 42")));
  EXPECT_THAT(error_of(head + "family = \"disc\"\n"), HasSubstr("\"sphere\""));
  EXPECT_THAT(error_of("experiment = \"jamming\"\n[bodies]\nfamily = \"sphere\"\n"),
              HasSubstr("bodies.dim = 3"));
  EXPECT_THAT(error_of(head + "A0 = 1.001\n"), HasSubstr("geodesic sphere"));
  EXPECT_THAT(error_of(head + "N = 1\n[jamming]\npacking_fraction = 0.3\n"), HasSubstr("raise bodies.N"));
  EXPECT_THAT(error_of("experiment = \"uniaxial_compression\"\n[bodies]\ndim = 3\n"),
              HasSubstr("it is done in two dimensions"));
  EXPECT_THAT(error_of("experiment = \"jamming\"\n[bodies]\ndim = 4\n"), HasSubstr("dim"));
}

/// Numbers that a run tells before it begins are those of its packing, but for the error of covered volumes.
TEST_F(SolidRun, NumbersBeforeItAreThoseOfItsStart) {
  for (const std::string more : {"", "family = \"sphere\"\n", "family = \"droplet\"\nsize_ratio = 2\n"}) {
    const Case c = case_of("experiment = \"jamming\"\n[bodies]\ndim = 3\nN = 8\n" + more +
                           "[jamming]\npacking_fraction = 0.2\n");
    const Packing<3> apart = make_packing<3>(c, nullptr, 0.2, set_apart),
                     random = make_packing<3>(c, nullptr, 0.2);
    EXPECT_NEAR(apart.covered_area, random.covered_area, 2e-4 * random.covered_area) << more;
    EXPECT_NEAR(random.covered_area / random.cell.volume(), 0.2, 4e-5) << more;
    EXPECT_EQ(apart.cell.length, random.cell.length);
    EXPECT_EQ(apart.pressure_unit, random.pressure_unit);
    EXPECT_EQ(apart.system.state.radius, random.system.state.radius);
  }
}

}  // namespace
}  // namespace supple
