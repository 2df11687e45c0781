#include "supple/io/export/trajectory.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "supple/core/error.hpp"
#include "supple/draw/scene/frame_scene.hpp"
#include "supple/io/export/vtp.hpp"
#include "tests/io/body_run.hpp"
#include "tests/io/count_of.hpp"
#include "tests/io/temporary_folder.hpp"

namespace supple {
namespace {

using testing::content_of;
using testing::count_of;

class Trajectory : public testing::TemporaryFolder {
 protected:
  /// With these times of the frames; the first body has gone on into the next cell.
  RunFile run_of(const std::vector<double>& times) {
    FileRecorder recorder(in_folder("run.h5"), testing::body_case("slump"), "", Existing::replace);
    recorder.begin(testing::body_info());
    for (std::size_t k = 0; k < times.size(); ++k) {
      Frame<2> frame = testing::body_frame(static_cast<int>(k));
      frame.time = times[k];
      for (int i = 0; i < 4; ++i) frame.position[i][0] += 10;
      frame.numbers["kinetic_energy"] = 0.125 * (1.0 + static_cast<double>(k));
      recorder.frame(frame);
    }
    recorder.finish("complete");
    return RunFile(in_folder("run.h5"));
  }
};

TEST_F(Trajectory, XyzHoldsEveryFrameWithItsCell) {
  export_xyz(run_of({0, 0.25, 0.5}), in_folder("a.xyz"));
  const std::string text = content_of(in_folder("a.xyz"));
  EXPECT_EQ(count_of(text, "Lattice="), 3);
  EXPECT_EQ(count_of(text, "\n"), 3 * (2 + 8));
  EXPECT_EQ(count_of(text, "Lattice=\"10 0 0 0 9.5 0 0 0 1.8\""), 1);  // the last cell is lower
  EXPECT_EQ(count_of(text, ":pressure:R:1"), 3);
  for (const char* of_all : {"kinetic_energy=0.125 ", "kinetic_energy=0.25 ", "kinetic_energy=0.375 "})
    EXPECT_EQ(count_of(text, of_all), 1) << of_all;
}

TEST_F(Trajectory, VtpIsACollectionOfFramesByTime) {
  export_vtp(run_of({0, 0.25, 0.5}), in_folder("a.pvd"));
  const std::string pvd = content_of(in_folder("a.pvd"));
  EXPECT_EQ(count_of(pvd, "timestep=\"0.5\""), 1);
  EXPECT_EQ(count_of(pvd, "file=\"a_frames/frame0000002.vtp\""), 1);
  EXPECT_EQ(count_of(content_of(in_folder("a_frames/frame0000002.vtp")), "Name=\"pressure\""), 1);
}

/// Whole bodies, put back into the cell of the frame.
TEST_F(Trajectory, EveryFileOfACollectionIsItsFrame) {
  const RunFile run = run_of({0, 0.25, 0.5});
  export_vtp(run, in_folder("a.pvd"));
  for (int k = 0; k < 3; ++k) {
    write_vtp(in_folder("one.vtp"), scene_of(run.info(), run.frame(k)), Existing::replace,
              Placement::in_cell);
    EXPECT_EQ(content_of(in_folder("a_frames/frame000000" + std::to_string(k) + ".vtp")),
              content_of(in_folder("one.vtp")));
  }
}

TEST_F(Trajectory, FramesWhoseTimesDoNotAscendAreNumbered) {
  for (const std::vector<double>& times : {std::vector<double>{0, 0, 0}, {3, 2, 5}, {0, std::nan(""), 7}}) {
    export_vtp(run_of(times), in_folder("a.pvd"), Existing::replace);
    const std::string pvd = content_of(in_folder("a.pvd"));
    for (const char* number : {"timestep=\"0\"", "timestep=\"1\"", "timestep=\"2\""})
      EXPECT_EQ(count_of(pvd, number), 1) << number << " in\n" << pvd;
  }
}

TEST_F(Trajectory, NothingIsOverwrittenUnlessAsked) {
  const RunFile run = run_of({0});
  export_vtp(run, in_folder("a.pvd"));
  std::filesystem::remove(in_folder("a.pvd"));
  EXPECT_THROW(export_vtp(run, in_folder("a.pvd")), Error);
  // Frames of a longer run, none of which this one would write.
  std::filesystem::rename(in_folder("a_frames/frame0000000.vtp"), in_folder("a_frames/frame0000005.vtp"));
  EXPECT_THROW(export_vtp(run, in_folder("a.pvd")), Error);
  EXPECT_NO_THROW(export_vtp(run, in_folder("a.pvd"), Existing::replace));
  EXPECT_FALSE(std::filesystem::exists(in_folder("a_frames/frame0000005.vtp")));
}

TEST_F(Trajectory, ARunWithoutFramesIsRefused) {
  const RunFile run = run_of({});
  EXPECT_THROW(export_xyz(run, in_folder("a.xyz")), Error);
  EXPECT_THROW(export_vtp(run, in_folder("a.pvd")), Error);
  EXPECT_EQ(files(), 1u);
}

}  // namespace
}  // namespace supple
