#include <gtest/gtest.h>

#include "supple/core/error.hpp"
#include "supple/io/run/file_recorder.hpp"
#include "supple/io/run/run_pictures.hpp"
#include "tests/io/temporary_folder.hpp"

namespace supple {
namespace {

using testing::content_of;

class ImagesTest : public testing::TemporaryFolder {
 protected:
  /// Two discs, in a cell whose strain grows by so much with each frame.
  RunFile two_discs(int frames, double strain = 0) {
    RunInfo<2> info;
    info.box.length = {1e-4, 1e-4};
    info.radius = {1e-5, 1e-5};
    info.mass = info.inertia = {1, 1};
    info.particle = {0, 0};
    FileRecorder recorder(in_folder("run.h5"), Case{}, "", Existing::replace);
    recorder.begin(info);
    for (int k = 0; k < frames; ++k) {
      Frame<2> frame;
      frame.step = k;
      frame.time = k;
      frame.strain = strain * k;
      frame.position = {{3e-5, 5e-5}, {4.5e-5, 5e-5}};
      frame.velocity = frame.force = {{0, 0}, {0, 0}};
      frame.angle = frame.spin = frame.torque = {0, 0};
      frame.mobility.assign(2, Mobility::free);
      recorder.frame(frame);
    }
    recorder.finish("complete");
    return RunFile(in_folder("run.h5"));
  }
  std::string image(int k, const std::string& ending) {
    return content_of(in_folder("image000000" + std::to_string(k) + "." + ending));
  }
};

TEST_F(ImagesTest, AreNumberedAndOfOneSize) {
  std::int64_t heard = 0;
  EXPECT_EQ(draw_frames(folder(), "png", two_discs(9, 0.05), 3, {},
                        [&](std::int64_t done, std::int64_t total) {
                          heard = done;
                          EXPECT_EQ(total, 3);
                        }),
            3);
  EXPECT_EQ(heard, 3);
  EXPECT_EQ(files(), 1u + 3u);
  const auto size = [&](int k) { return image(k, "png").substr(16, 8); };
  EXPECT_EQ(size(0), size(1));
  EXPECT_EQ(size(0), size(2));
}

/// Many frames take a while to be looked over: a stop is not to wait for that.
TEST_F(ImagesTest, AStopIsHeardBeforeTheFirstIsDrawn) {
  const auto stop = [](std::int64_t done, std::int64_t) {
    if (done == 0) throw Error(ErrorKind::interrupted, "stop");
  };
  EXPECT_THROW(draw_frames(folder(), "svg", two_discs(5), 5, {}, stop), Error);
  EXPECT_EQ(files(), 1u);
}

TEST_F(ImagesTest, AreEvenlySpaced) {
  const RunFile run = two_discs(9);
  draw_frames(folder(), "png", run, 3);
  for (const int k : {0, 1, 2})
    for (const int frame : {0, 4, 8}) {
      draw_frame(in_folder("alone.png"), run, frame);
      EXPECT_EQ(image(k, "png") == content_of(in_folder("alone.png")), frame == 4 * k) << k << " " << frame;
    }
}

TEST_F(ImagesTest, DrawEveryFrameWhereThereAreFewer) {
  EXPECT_EQ(draw_frames(folder(), "svg", two_discs(2), 200), 2);
  EXPECT_EQ(files(), 1u + 2u);
}

TEST_F(ImagesTest, RefuseUnknownEndingsRunsWithoutFramesAndMissingFolders) {
  EXPECT_THROW(draw_frames(folder(), "gif", two_discs(2), 2), Error);
  EXPECT_THROW(draw_frames(folder(), "png", two_discs(0), 2), Error);
  EXPECT_EQ(files(), 1u);
  try {
    draw_frames(in_folder("no_such_folder"), "png", two_discs(2), 2);
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::file);
  }
}

}  // namespace
}  // namespace supple
