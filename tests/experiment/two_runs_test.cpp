/// Runs side by side in the threads of one process give the bits of the same runs alone.
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <optional>
#include <thread>
#include <vector>

#include "supple/core/error.hpp"
#include "supple/core/parallel.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/io/run/file_recorder.hpp"
#include "supple/io/run/run_file.hpp"
#include "supple/io/text/case_file.hpp"
#include "tests/io/temporary_folder.hpp"

namespace supple {
namespace {

/// Crosslinked discs; with this many there is enough for two threads.
Case discs(int count, const std::string& physics = "documented") {
  Case c;
  c.general.physics = physics;
  c.particles.discs = count;
  c.particles.permanent_links = count < 200;
  c.shear.relative_frequency = 0.2;
  c.shear.pre_periods = c.shear.post_periods = 0.05;
  c.shear.periods = 1;
  c.output.frames = 3;
  return c;
}

Case shells(int count, const std::string& contact) {
  Case c;
  c.general.experiment = "jamming";
  c.bodies.count = count;
  c.bodies.vertices = 10;
  c.contact.kind = contact;
  c.jamming.packing_fraction = 0.6;
  c.jamming.step = 0.01;
  c.jamming.pressure = 1e-4;
  resolve_family(c);
  return c;
}

/// Frictional, linked shells in an oscillating cell.
Case gel() {
  Case c = shells(9, "smooth");
  c.general.experiment = "oscillatory_shear";
  c.general.physics = "deformable";
  c.given.insert("physics");
  c.jamming.pressure = 1e-2;
  c.particles.cut_lines = 3;
  c.particles.avoid_height_spanning_particles = false;
  c.material.friction = 0.3;
  c.shear.amplitude = 0.05;
  c.shear.relative_frequency = 0.05;
  c.shear.pre_periods = c.shear.post_periods = 0;
  c.shear.periods = 1;
  c.output.frames = 5;
  resolve_family(c);
  return c;
}

using Bits = std::vector<std::uint64_t>;

/// Every number that a run tells, by its bits, but the processor time.
Bits bits_of(const MemoryRecorder& r) {
  Bits bits;
  const auto add = [&](double x) { bits.push_back(std::bit_cast<std::uint64_t>(x)); };
  for (const auto& [name, table] : r.tables)
    for (const auto& row : table.rows)
      for (const double x : row) add(x);
  for (const auto& [group, values] : r.values)
    for (const auto& v : values)
      if (v.name.name != "cpu_time") add(v.value), add(v.error);
  for (const Vec2& x : r.last_system.state.position) add(x[0]), add(x[1]);
  for (const Frame<2>& frame : r.frames)
    for (const Vec2& f : frame.force) add(f[0]), add(f[1]);
  return bits;
}

Bits result_of(const Case& c) {
  MemoryRecorder recorder;
  run(c, nullptr, recorder);
  return bits_of(recorder);
}

/// The results of all cases, each in a thread of its own, at once.
std::vector<Bits> side_by_side(const std::vector<Case>& cases) {
  std::vector<Bits> results(cases.size());
  std::vector<std::thread> threads;
  for (std::size_t k = 0; k < cases.size(); ++k)
    threads.emplace_back([&, k] { results[k] = result_of(cases[k]); });
  for (std::thread& t : threads) t.join();
  return results;
}

void expect_same_as_alone(const std::vector<Case>& cases) {
  std::vector<Bits> alone;
  for (const Case& c : cases) alone.push_back(result_of(c));
  for (int repeat = 0; repeat < 2; ++repeat) {
    const std::vector<Bits> together = side_by_side(cases);
    for (std::size_t k = 0; k < cases.size(); ++k) {
      EXPECT_GT(alone[k].size(), 400u);
      EXPECT_TRUE(together[k] == alone[k]) << "run " << k;
    }
  }
}

TEST(TwoRuns, OfDiscsAndShellsGiveTheBitsOfEachAlone) {
  expect_same_as_alone({discs(45), shells(9, "smooth")});
}

TEST(TwoRuns, OfEveryKindGiveTheBitsOfEachAlone) {
  expect_same_as_alone({discs(45), discs(45, "particleshear-1.0.2"), shells(9, "rough"), gel(), gel()});
}

/// Each with helpers of its own, which sleep when it has nothing for them.
TEST(TwoRuns, OnTwoThreadsEachGiveTheBitsOfEachAlone) {
  std::vector<Case> cases{discs(1100), shells(80, "rough")};
  cases[0].particles.packing_fraction = 0.8;
  cases[0].shear.periods = 1;
  cases[0].shear.relative_frequency = 2;
  cases[1].jamming.pressure = 1e-2;
  cases[1].jamming.step = 0.05;
  for (Case& c : cases) c.general.threads = 2;
  expect_same_as_alone(cases);
}

class TwoFiles : public testing::TemporaryFolder {};

TEST_F(TwoFiles, AreWrittenSideBySide) {
  const std::vector<Case> cases{discs(45), shells(9, "smooth")};
  const auto write = [&](std::size_t k) {
    FileRecorder recorder(in_folder(std::to_string(k) + ".h5"), cases[k],
                          write_case(cases[k], CaseStyle::resolved));
    run(cases[k], nullptr, recorder);
    recorder.finish("complete");
  };
  std::thread other(write, 1);
  write(0);
  other.join();
  for (std::size_t k = 0; k < cases.size(); ++k) {
    MemoryRecorder alone;
    run(cases[k], nullptr, alone);
    const RunFile file(in_folder(std::to_string(k) + ".h5"));
    EXPECT_EQ(file.frames(), alone.frames.size());
    EXPECT_EQ(file.frame(file.frames() - 1).position, alone.frames.back().position);
  }
}

/// Notes on how many threads loops are shared while an experiment runs.
class ThreadsSeen : public MemoryRecorder {
 public:
  void progress(const std::string&, std::int64_t, std::int64_t) override { most = thread_count(); }
  bool stop_requested() override { return most > 0; }
  int most = 0;
};

TEST(Threads, AreThoseOfTheCaseWhileItRuns) {
  for (Case c : {discs(45), shells(9, "rough")}) {
    ASSERT_EQ(thread_count(), 1);
    c.general.threads = 3;
    ThreadsSeen recorder;
    EXPECT_THROW(run(c, nullptr, recorder), Error);  // it is asked to stop
    EXPECT_EQ(recorder.most, 3);
    EXPECT_EQ(thread_count(), 1);
  }
}

TEST(Threads, OfOneThreadAreNoneOfAnother) {
  const WithThreads here(3);
  int there = 0;
  std::thread([&] { there = thread_count(); }).join();
  EXPECT_EQ(there, 1);
  EXPECT_EQ(thread_count(), 3);
}

}  // namespace
}  // namespace supple
