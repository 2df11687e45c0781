/// Same case, same bits: on every run, for one and two threads, and for a run split in two through its file.
#include <gtest/gtest.h>

#include "supple/experiment/adopt_state.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/experiment/suspension.hpp"
#include "supple/io/run/file_recorder.hpp"
#include "supple/io/state/state_file.hpp"
#include "supple/io/text/case_file.hpp"
#include "tests/io/temporary_folder.hpp"

namespace supple {
namespace {

Case short_shear(int discs, const std::string& physics) {
  Case c;
  c.general.physics = physics;
  c.particles.discs = discs;
  c.shear.relative_frequency = 0.2;
  c.shear.pre_periods = 0.3;
  c.shear.periods = 1;
  c.shear.post_periods = 0.3;
  return c;
}

MemoryRecorder result_of(Case c, int threads = 1, const InitialState* initial = nullptr) {
  MemoryRecorder recorder;
  c.general.threads = threads;
  run(c, initial, recorder);
  return recorder;
}

void expect_same_bits(const System<2>& a, const System<2>& b) {
  EXPECT_EQ(a.state.position, b.state.position);
  EXPECT_EQ(a.state.velocity, b.state.velocity);
  EXPECT_EQ(a.state.angle, b.state.angle);
  EXPECT_EQ(a.state.spin, b.state.spin);
  EXPECT_EQ(a.state.mobility, b.state.mobility);
  EXPECT_EQ(a.box.strain, b.box.strain);
  EXPECT_EQ(a.time, b.time);
}

class Determinism : public testing::TemporaryFolder, public ::testing::WithParamInterface<const char*> {};

TEST_P(Determinism, RunsRepeat) {
  const Case c = short_shear(45, GetParam());
  const MemoryRecorder a = result_of(c), b = result_of(c);
  EXPECT_EQ(a.tables.at("stress").rows, b.tables.at("stress").rows);
  expect_same_bits(a.last_system, b.last_system);
}

TEST_P(Determinism, OtherSeedsGiveOtherRuns) {
  Case c = short_shear(45, GetParam());
  const MemoryRecorder a = result_of(c);
  c.general.seed = 2;
  EXPECT_NE(a.last_system.state.position, result_of(c).last_system.state.position);
}

TEST_P(Determinism, ThreadsChangeNothing) {
  Case c = short_shear(1100, GetParam());  // enough chunks of sites that two threads are used
  c.shear.pre_periods = c.shear.post_periods = 0.05;
  if (c.general.physics == "particleshear-1.0.2")
    c.shear.periods = 0.1;  // the documented fidelity wants a whole period
  c.particles.permanent_links = false;
  const MemoryRecorder one = result_of(c, 1), two = result_of(c, 2);
  EXPECT_EQ(one.tables.at("stress").rows, two.tables.at("stress").rows);
  expect_same_bits(one.last_system, two.last_system);
}

TEST_P(Determinism, ARunSplitInTwoThroughItsFileIsTheWholeRun) {
  const auto recorded = [&](const Case& c, const InitialState* initial, const std::string& name) {
    FileRecorder recorder(in_folder(name), adopt_state(c, initial), write_case(c, CaseStyle::resolved));
    run(c, initial, recorder);
    recorder.finish("complete");
    return read_state(in_folder(name));
  };
  const InitialState start = recorded(short_shear(45, GetParam()), nullptr, "start.h5");
  Case c = short_shear(45, GetParam());
  c.general.experiment = "dynamics";
  c.shear.rate = "2000*cos(3000*t)";
  c.initial.keep_time = true;
  c.initial.state = "start.h5";
  const auto steps = [&](std::int64_t n) {
    c.time.steps = n;
    c.given = {"time.steps"};
    return c;
  };
  const InitialState whole = recorded(steps(120), &start, "whole.h5");
  const InitialState half = recorded(steps(50), &start, "half.h5");
  const InitialState split = recorded(steps(70), &half, "split.h5");
  expect_same_bits(system_of<2>(whole), system_of<2>(split));
  EXPECT_EQ(system_of<2>(whole).pairs.history.empty(), false);
}

INSTANTIATE_TEST_SUITE_P(Physics, Determinism, ::testing::Values("documented", "particleshear-1.0.2"),
                         [](const auto& p) { return std::string(p.index ? "package" : "documented"); });

}  // namespace
}  // namespace supple
