/// Which frames a run file keeps, and which numbers of them.
#include <gtest/gtest.h>

#include <cmath>

#include "supple/io/run/file_recorder.hpp"
#include "supple/io/run/run_file.hpp"
#include "tests/io/sample_run.hpp"
#include "tests/io/temporary_folder.hpp"

namespace supple {
namespace {

using testing::sample_frame;

constexpr int discs = 5;

class RunFrames : public testing::TemporaryFolder {
 protected:
  /// The run of these frames, all in one segment or each in one of its own.
  RunFile run_of(const std::vector<Frame<2>>& frames, FlushSpec flush) {
    FileRecorder to(in_folder("run.h5"), Case{}, "", Existing::replace, flush);
    to.begin(testing::sample_info(discs));
    for (const Frame<2>& frame : frames) to.frame(frame);
    to.finish("complete");
    return RunFile(in_folder("run.h5"));
  }
};

const FlushSpec one_segment{}, many_segments{0, 1};

/// A frame handed over again, at the end of a phase and the start of the next, say.
TEST_F(RunFrames, OfOneInstantAreOne) {
  Frame<2> moved = sample_frame(discs, 2);
  moved.position[3][0] += 1e-9;
  for (const FlushSpec& flush : {one_segment, many_segments}) {
    const RunFile run =
        run_of({sample_frame(discs, 1), sample_frame(discs, 2), sample_frame(discs, 2), moved, moved}, flush);
    ASSERT_EQ(run.frames(), 3);
    EXPECT_EQ(run.frame(1).position, sample_frame(discs, 2).position);
    EXPECT_EQ(run.frame(2).position, moved.position);
  }
}

TEST_F(RunFrames, HaveTheNumbersOfAllThatTheFirstOneHas) {
  Frame<2> later = sample_frame(discs, 2);
  later.numbers = {{"pressure", 7}, {"volume", 8}};
  for (const FlushSpec& flush : {one_segment, many_segments}) {
    const RunFile run = run_of({sample_frame(discs, 1), later}, flush);
    EXPECT_EQ(run.frame(0).numbers, sample_frame(discs, 1).numbers);
    const SystemNumbers numbers = run.frame(1).numbers;
    ASSERT_EQ(numbers.size(), 2u) << "kinetic_energy and pressure";
    EXPECT_EQ(numbers.at("pressure"), 7);
    EXPECT_TRUE(std::isnan(numbers.at("kinetic_energy"))) << "it is missing in the second frame";
  }
}

/// Force times length and force over length, per metre of depth: 1e-6 kg/m (1e-6 m)^2/s^2 and so on.
TEST_F(RunFrames, NumbersOfAllHaveTheUnitsOfTheRun) {
  run_of({sample_frame(discs, 1)}, one_segment);
  const h5::Group root = h5::open_file(in_folder("run.h5"));
  EXPECT_EQ(root.open_dataset("frames/system/kinetic_energy").text("unit"), "1e-18 J/m");
  EXPECT_EQ(root.open_dataset("frames/system/kinetic_energy").text("meaning"), "energy of motion");
  EXPECT_EQ(root.open_dataset("frames/system/pressure").text("unit"), "1e-06 Pa");
}

}  // namespace
}  // namespace supple
