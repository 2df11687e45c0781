#include "supple/io/run/images.hpp"

#include <gtest/gtest.h>

#include "supple/core/error.hpp"
#include "tests/io/temporary_folder.hpp"

namespace supple {
namespace {

using testing::content_of;

RunInfo two_discs() {
  RunInfo info;
  info.box.length = {1e-4, 1e-4};
  info.radius = {1e-5, 1e-5};
  info.particle = {0, 0};
  return info;
}

/// Strain grows with the frame, and asked-for frames are noted.
FrameSource source(std::int64_t count, std::vector<std::int64_t>& asked) {
  return {count, [&asked](std::int64_t k) {
            asked.push_back(k);
            Frame frame;
            frame.strain = 0.05 * static_cast<double>(k);
            frame.position = {{3e-5, 5e-5}, {4.5e-5, 5e-5}};
            frame.angle = {0, 0};
            frame.mobility.assign(2, Mobility::free);
            return frame;
          }};
}

class ImagesTest : public testing::TemporaryFolder {};

TEST_F(ImagesTest, AreNumberedEvenlySpacedAndOfOneSize) {
  std::vector<std::int64_t> asked;
  std::int64_t heard = 0;
  SnapshotOptions small;
  small.dots_per_inch = 40;
  EXPECT_EQ(draw_images(folder(), "png", two_discs(), source(9, asked), 3, small,
                        [&](std::int64_t done, std::int64_t total) {
                          heard = done;
                          EXPECT_EQ(total, 3);
                        }),
            3);
  EXPECT_EQ(heard, 3);
  EXPECT_EQ(files(), 3u);
  asked.erase(asked.begin(), asked.begin() + 3);  // the first round only looks for the common scale
  EXPECT_EQ(asked, (std::vector<std::int64_t>{0, 4, 8}));
  const auto size = [&](const char* name) { return content_of(in_folder(name)).substr(16, 8); };
  EXPECT_EQ(size("image0000000.png"), size("image0000001.png"));
  EXPECT_EQ(size("image0000000.png"), size("image0000002.png"));
}

TEST_F(ImagesTest, DrawEveryFrameWhereThereAreFewer) {
  std::vector<std::int64_t> asked;
  EXPECT_EQ(draw_images(folder(), "svg", two_discs(), source(2, asked), 200), 2);
  EXPECT_EQ(files(), 2u);
}

TEST(Images, RefuseUnknownEndingsRunsWithoutFramesAndMissingFolders) {
  std::vector<std::int64_t> asked;
  EXPECT_THROW(draw_images("/tmp", "gif", two_discs(), source(2, asked), 2), Error);
  EXPECT_THROW(draw_images("/tmp", "png", two_discs(), source(0, asked), 2), Error);
  EXPECT_TRUE(asked.empty());
  try {
    draw_images(::testing::TempDir() + "supple_no_such_folder", "png", two_discs(), source(2, asked), 2);
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::file);
  }
}

}  // namespace
}  // namespace supple
