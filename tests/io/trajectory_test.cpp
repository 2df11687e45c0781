#include "supple/io/export/trajectory.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "supple/core/error.hpp"
#include "tests/io/body_run.hpp"
#include "tests/io/count_of.hpp"
#include "tests/io/temporary_folder.hpp"

namespace supple {
namespace {

using testing::content_of;
using testing::count_of;

class Trajectory : public testing::TemporaryFolder {
 protected:
  RunFile run_of(int frames, bool moves = true) {
    FileRecorder recorder(in_folder("run.h5"), testing::body_case("slump"), "", Existing::replace);
    recorder.begin(testing::body_info());
    for (int k = 0; k < frames; ++k) {
      Frame frame = testing::body_frame(k);
      if (!moves) frame.time = 0;
      recorder.frame(frame);
    }
    recorder.finish("complete");
    return RunFile(in_folder("run.h5"));
  }
};

TEST_F(Trajectory, XyzHoldsEveryFrameWithItsCell) {
  export_xyz(run_of(3), in_folder("a.xyz"));
  const std::string text = content_of(in_folder("a.xyz"));
  EXPECT_EQ(count_of(text, "Lattice="), 3);
  EXPECT_EQ(count_of(text, "\n"), 3 * (2 + 8));
  EXPECT_EQ(count_of(text, "Lattice=\"10 0 0 0 9.5 0 0 0 1.8\""), 1);  // the last cell is lower
  EXPECT_EQ(count_of(text, ":pressure:R:1"), 3);
}

TEST_F(Trajectory, VtpIsACollectionOfFramesByTime) {
  export_vtp(run_of(3), in_folder("a.pvd"));
  const std::string pvd = content_of(in_folder("a.pvd"));
  EXPECT_EQ(count_of(pvd, "timestep=\"0.5\""), 1);
  EXPECT_EQ(count_of(pvd, "file=\"a_frames/frame0000002.vtp\""), 1);
  EXPECT_EQ(count_of(content_of(in_folder("a_frames/frame0000002.vtp")), "Name=\"pressure\""), 1);
}

TEST_F(Trajectory, FramesThatShareATimeAreNumbered) {
  export_vtp(run_of(3, false), in_folder("a.pvd"));
  EXPECT_EQ(count_of(content_of(in_folder("a.pvd")), "timestep=\"2\""), 1);
}

TEST_F(Trajectory, NothingIsOverwrittenUnlessAsked) {
  const RunFile run = run_of(1);
  export_vtp(run, in_folder("a.pvd"));
  std::filesystem::remove(in_folder("a.pvd"));
  EXPECT_THROW(export_vtp(run, in_folder("a.pvd")), Error);
  EXPECT_NO_THROW(export_vtp(run, in_folder("a.pvd"), Existing::replace));
}

TEST_F(Trajectory, ARunWithoutFramesIsRefused) {
  const RunFile run = run_of(0);
  EXPECT_THROW(export_xyz(run, in_folder("a.xyz")), Error);
  EXPECT_THROW(export_vtp(run, in_folder("a.pvd")), Error);
  EXPECT_EQ(files(), 1u);
}

}  // namespace
}  // namespace supple
