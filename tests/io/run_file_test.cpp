#include <gmock/gmock.h>

#include <sys/wait.h>
#include <csignal>

#include "supple/core/version.hpp"
#include "supple/io/run/file_recorder.hpp"
#include "supple/io/run/run_file.hpp"
#include "tests/io/same_frame.hpp"
#include "tests/io/same_system.hpp"
#include "tests/io/sample_run.hpp"
#include "tests/io/temporary_folder.hpp"

namespace supple {
namespace {

namespace fs = std::filesystem;
using namespace supple::testing;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr int discs = 5, steps = 23;
/// A segment for every append.
constexpr FlushSpec always{0, 1};

Case sample_case() {
  Case c;
  c.general.seed = 77;
  c.material.friction = 0.1;
  c.particles.permanent_links = false;
  c.shear.rate = "sin(t)";
  return c;
}

class RunFileTest : public TemporaryFolder {
 protected:
  std::string path() const { return in_folder("run.h5"); }
  FileRecorder recorder(FlushSpec flush = {}, Existing existing = Existing::refuse) const {
    return {path(), sample_case(), "seed = 77 # resolved\n", existing, flush};
  }
};

/// Everything that record_sample wrote, up to `seen` steps.
void expect_sample(const RunFile& run, int seen) {
  EXPECT_EQ(run.experiment(), "oscillatory_shear");
  EXPECT_EQ(run.physics(), "documented");
  EXPECT_EQ(run.version(), version());
  EXPECT_EQ(run.seed(), 77);
  EXPECT_EQ(run.case_text(), "seed = 77 # resolved\n");
  const Case c = run.resolved_case();
  EXPECT_EQ(c.material.friction, 0.1);
  EXPECT_EQ(c.particles.permanent_links, false);
  EXPECT_EQ(c.shear.rate, "sin(t)");

  const RunInfo<2> info = run.info(), expected = sample_info(discs);
  EXPECT_EQ(info.units.name, "um mg s");
  EXPECT_EQ(info.units.length, 1e-6);
  EXPECT_EQ(info.box.length, expected.box.length);
  EXPECT_EQ(info.box.periodic, expected.box.periodic);
  EXPECT_EQ(info.radius, expected.radius);
  EXPECT_EQ(info.mass, expected.mass);
  EXPECT_EQ(info.inertia, expected.inertia);
  EXPECT_EQ(info.particle, expected.particle);
  EXPECT_EQ(info.body_begin, expected.body_begin);

  EXPECT_THAT(run.tables(), ::testing::UnorderedElementsAre("stress", "empty"));
  const auto columns = run.columns("stress");
  ASSERT_EQ(columns.size(), 3u);
  EXPECT_EQ(columns[1].name, "zeta") << "in the order they were declared";
  EXPECT_EQ(columns[1].unit, "Pa");
  EXPECT_EQ(columns[1].meaning, "later in the alphabet");
  ASSERT_EQ(run.rows("stress"), seen);
  EXPECT_EQ(run.rows("empty"), 0);
  const auto alpha = run.column("stress", "alpha");
  for (int k = 0; k < seen; ++k) EXPECT_EQ(alpha[static_cast<std::size_t>(k)], k / 7.);

  ASSERT_EQ(run.frames(), seen);
  for (int k = seen - 1; k >= 0; --k) expect_same(run.frame(k), sample_frame(discs, k));
  EXPECT_EQ(run.value("constants", "tau"), 1e-5);
}

void expect_sample_end(const RunFile& run) {
  const auto results = run.values("results");
  ASSERT_EQ(results.size(), 2u);
  EXPECT_EQ(results[0].name.name, "steps");
  EXPECT_EQ(results[0].value, steps - 1) << "the last value given stands";
  EXPECT_EQ(results[0].error, -1);
  EXPECT_EQ(results[1].error, 17);
  EXPECT_EQ(results[1].name.meaning, "G'");
  EXPECT_THAT(run.warnings(), ElementsAre("the first warning", "the last warning"));
  const auto [system, evaluation] = run.final_state();
  expect_same(system, sample_system(discs));
  const Evaluation<2> expected = sample_evaluation(discs);
  EXPECT_EQ(evaluation.force, expected.force);
  EXPECT_EQ(evaluation.torque, expected.torque);
  using E = EnergyParts;
  for (const auto part : {&E::terms, &E::elastic, &E::tangential, &E::wall, &E::external, &E::viscous_power,
                          &E::tangential_viscous_power, &E::sliding_power})
    EXPECT_EQ(evaluation.energy.*part, expected.energy.*part);
  EXPECT_EQ(evaluation.virial[1][0], expected.virial[1][0]);
}

TEST_F(RunFileTest, OneSegmentOrManyMakeTheSameRun) {
  for (const FlushSpec flush : {FlushSpec{}, always}) {
    FileRecorder to = recorder(flush, Existing::replace);
    record_sample(to, discs, steps);
    EXPECT_EQ(fs::exists(in_folder("run.h5.partial/segment-000005.h5")), flush.bytes == 1);
    to.finish("complete");
    EXPECT_FALSE(fs::exists(in_folder("run.h5.partial")));
    const RunFile run(path());
    EXPECT_EQ(run.status(), "complete");
    expect_sample(run, steps);
    expect_sample_end(run);
  }
}

TEST_F(RunFileTest, SegmentsOfARunGoingOnAreReadable) {
  FileRecorder to = recorder(always);
  record_sample(to, discs, steps);
  for (const std::string& name : {path(), in_folder("run.h5.partial")}) {
    const RunFile run(name);
    EXPECT_EQ(run.status(), "unfinished");
    expect_sample(run, steps);
    EXPECT_FALSE(run.has_final_state());
  }
}

TEST_F(RunFileTest, AKilledRunLeavesItsCompleteSegments) {
  const pid_t child = fork();
  if (child == 0) {
    FileRecorder to = recorder(always);
    record_sample(to, discs, steps);
    std::raise(SIGKILL);
  }
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status));
  write_content(in_folder("run.h5.partial/" + segment_name(2 * steps + 1) + ".tmp"), "half a segment");

  const RunFile run(path());
  EXPECT_EQ(run.status(), "unfinished");
  expect_sample(run, steps);
}

TEST_F(RunFileTest, AFailedRunKeepsWhatItHad) {
  FileRecorder to = recorder();
  record_sample(to, discs, 3);
  to.finish("failed: not finite");
  const RunFile run(path());
  EXPECT_EQ(run.status(), "failed: not finite");
  expect_sample(run, 3);
}

TEST_F(RunFileTest, WithoutFinishTheLastSegmentHoldsTheRest) {
  {
    FileRecorder to = recorder();
    record_sample(to, discs, steps);
  }
  const RunFile run(path());
  expect_sample(run, steps);
  expect_sample_end(run);
}

TEST_F(RunFileTest, ARunThatNeverBeganLeavesNothing) {
  { FileRecorder to = recorder(); }
  recorder().finish("failed: bad input");
  EXPECT_TRUE(fs::is_empty(in_folder("")));
}

TEST_F(RunFileTest, NothingIsOverwrittenUnlessAsked) {
  write_content(path(), "precious");
  EXPECT_THAT(file_error_of([&] { recorder(); }), HasSubstr("run.h5 exists"));
  EXPECT_EQ(content_of(path()), "precious");
  FileRecorder to = recorder({}, Existing::replace);
  record_sample(to, discs, steps);
  EXPECT_EQ(content_of(path()), "precious") << "until the new run is complete";
  to.finish("complete");
  expect_sample(RunFile(path()), steps);
}

TEST_F(RunFileTest, AFileThatAppearsMeanwhileIsKept) {
  FileRecorder to = recorder();
  record_sample(to, discs, steps);
  write_content(path(), "precious");
  EXPECT_THAT(
      file_error_of([&] { to.finish("complete"); }),
      ::testing::AllOf(HasSubstr("run.h5 exists"), HasSubstr("is complete is in " + path() + ".partial")));
  EXPECT_EQ(content_of(path()), "precious");
  expect_sample_end(RunFile(in_folder("run.h5.partial")));
}

TEST_F(RunFileTest, TwoRunsDoNotShareAName) {
  FileRecorder first = recorder();
  EXPECT_THAT(file_error_of([&] { recorder(); }), HasSubstr("another run writes there"));
}

TEST_F(RunFileTest, AMissingFolderIsAnErrorBeforeTheRun) {
  EXPECT_THAT(file_error_of([&] { FileRecorder(in_folder("none/run.h5"), Case{}, ""); }),
              HasSubstr("there is no folder"));
}

TEST_F(RunFileTest, ErrorsTellWhatIsWrongWithAFile) {
  EXPECT_THAT(file_error_of([&] { RunFile(in_folder("none.h5")); }), HasSubstr("No such file"));
  write_content(in_folder("text.h5"), "not HDF5, but long enough to be some other kind of file");
  EXPECT_THAT(file_error_of([&] { RunFile(in_folder("text.h5")); }), HasSubstr("is not an HDF5 file"));
  h5::Group foreign = h5::create_file("foreign.h5");
  for (const std::string name : {"foreign.h5", "of_another_version.h5"}) {
    if (name != "foreign.h5") foreign.set("format", std::string("supple run 0"));
    h5::save(foreign, in_folder(name));
    EXPECT_THAT(file_error_of([&] { RunFile(in_folder(name)); }), HasSubstr("is not a run of Supple"));
  }

  FileRecorder to = recorder();
  record_sample(to, discs, steps);
  to.finish("complete");
  const std::string whole = content_of(path());
  write_content(in_folder("cut.h5"), whole.substr(0, whole.size() - 1000));
  EXPECT_THAT(file_error_of([&] { RunFile(in_folder("cut.h5")); }),
              HasSubstr("the file ends before its own data"));

  const RunFile run(path());
  EXPECT_THAT(file_error_of([&] { run.column("stress", "beta"); }), HasSubstr("t, zeta, alpha"));
  EXPECT_THAT(file_error_of([&] { run.columns("strain"); }), HasSubstr("stress"));
  EXPECT_THAT(file_error_of([&] { run.frame(steps); }), HasSubstr("no frame 23"));
  EXPECT_THAT(file_error_of([&] { run.value("results", "G"); }), HasSubstr("no number 'G'"));
}

/// Runs of microgel discs, and runs written before there were bodies, have neither.
TEST_F(RunFileTest, FramesWithoutBodiesHaveTheCellOfTheRun) {
  for (const FlushSpec flush : {FlushSpec{}, always}) {
    FileRecorder to = recorder(flush, Existing::replace);
    RunInfo<2> info = sample_info(discs);
    info.body_begin.clear();
    to.begin(info);
    for (int k = 0; k < 3; ++k) {
      Frame<2> frame = sample_frame(discs, k);
      frame.length = {};
      frame.body.clear();
      to.frame(frame);
    }
    to.finish("complete");
    const RunFile run(path());
    EXPECT_TRUE(run.info().body_begin.empty());
    EXPECT_TRUE(run.frame(2).body.empty());
    EXPECT_EQ(run.frame(2).length, (Vec2{500, 400}));
    EXPECT_FALSE(h5::open_file(path()).has("frames/body"));
    EXPECT_FALSE(h5::open_file(path()).has("discs/body_begin"));
  }
}

TEST_F(RunFileTest, AllFramesHaveTheSameNumbersOfBodies) {
  FileRecorder to = recorder(always);
  to.begin(sample_info(discs));
  to.frame(sample_frame(discs, 0));
  Frame<2> other = sample_frame(discs, 1);
  other.body["more"] = {1, 2};
  EXPECT_THROW(to.frame(other), Error);
  other.body.erase("more");
  other.body.erase("zeal");
  EXPECT_THROW(to.frame(other), Error);
  other.body["zeal"] = {1};
  EXPECT_THROW(to.frame(other), Error);
  to.frame(sample_frame(discs, 1));
}

/// A run in reduced units has numbers without units.
TEST_F(RunFileTest, ReducedUnitsHaveNoNames) {
  FileRecorder to = recorder();
  RunInfo<2> info = sample_info(discs);
  info.units = reduced_units();
  to.begin(info);
  to.frame(sample_frame(discs, 0));
  to.finish("complete");
  const h5::Group root = h5::open_file(path());
  for (const char* name : {"discs/radius", "frames/position", "frames/time", "frames/spin", "frames/length"})
    EXPECT_FALSE(root.open_dataset(name).has_attribute("unit")) << name;
}

/// What a Python user sees, without Supple.
TEST_F(RunFileTest, H5pyReadsIt) {
  FileRecorder to = recorder(always);
  record_sample(to, discs, steps);
  to.finish("complete");
  write_content(in_folder("read.py"), R"(
import h5py, sys
with h5py.File(sys.argv[1]) as f:
    assert f.attrs['sign_of_stress'] == b'compression positive'
    assert f.attrs['status'] == b'complete' and f.attrs['seed'] == 77
    assert f['case'].asstr()[()].startswith('seed = 77')
    assert f['case'].attrs['material.friction'] == 0.1
    stress = f['tables/stress']
    assert list(stress) == ['t', 'zeta', 'alpha'], list(stress)
    assert stress['zeta'].shape == (23,) and stress['zeta'][7] == 7 / 3
    assert stress['zeta'].attrs['unit'] == b'Pa'
    frames = f['frames']
    assert frames['position'].shape == (23, 5, 2)
    assert frames['position'].attrs['unit'] == b'1e-06 m'
    assert frames['position'][2, 1, 0] == 201 / 3
    begin, count = frames['contact_begin'][3], frames['contact_count'][3]
    assert frames['contact_normal_force'][begin:begin + count].tolist() == [0, 1 / 3, 2 / 3]
    assert frames['length'].shape == (23, 2) and frames['length'].attrs['unit'] == b'1e-06 m'
    pressure = frames['body/pressure']
    assert pressure.shape == (23, 2) and pressure[7, 1] == -7 / 41
    assert pressure.attrs['unit'].endswith(b'Pa') and b'mean normal' in pressure.attrs['meaning']
    assert frames['body/zeal'].shape == (23, 2)
    assert f['discs/body_begin'][()].tolist() == [0, 2, 5]
    g = f['results/storage_modulus']
    assert g[()] == 565 and g.attrs['error'] == 17 and g.attrs['unit'] == b'Pa'
    assert f['warnings'].asstr()[1] == 'the last warning'
    assert f['final_state/sites/position'].shape == (5, 2)
    assert f['discs/radius'].attrs['unit'] == b'1e-06 m'
)");
  const std::string log = in_folder("log");
  EXPECT_EQ(
      std::system(("/usr/bin/python3 " + in_folder("read.py") + " " + path() + " >" + log + " 2>&1").c_str()),
      0)
      << content_of(log);
}

}  // namespace
}  // namespace supple
