#include "supple/draw/canvas/canvas.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "supple/core/error.hpp"
#include "supple/draw/canvas/png.hpp"
#include "tests/io/temporary_folder.hpp"

namespace supple {
namespace {

using testing::content_of;
using ::testing::HasSubstr;
using ::testing::StartsWith;

void draw_sample(const std::string& path) {
  Canvas canvas(path, 72, 36, 200);
  canvas.circle({20, 18}, 10, {hex(0xEE7733), Pen{}});
  canvas.text({40, 18}, "G\u2032");
  canvas.finish();
}

int big_endian(const std::string& bytes, std::size_t at, int count) {
  int value = 0;
  for (int k = 0; k < count; ++k) value = 256 * value + static_cast<unsigned char>(bytes[at + k]);
  return value;
}

class CanvasTest : public testing::TemporaryFolder {};

TEST_F(CanvasTest, WritesPngOfTheSizeThatPointsAndResolutionGive) {
  draw_sample(in_folder("a.png"));
  const std::string bytes = content_of(in_folder("a.png"));
  ASSERT_THAT(bytes, StartsWith("\x89PNG\r\n\x1a\n"));
  EXPECT_EQ(big_endian(bytes, 16, 4), 200);
  EXPECT_EQ(big_endian(bytes, 20, 4), 100);
  EXPECT_THAT(bytes, HasSubstr("IEND"));
}

/// Cairo writes the time of day into both.
TEST_F(CanvasTest, VectorFormatsHaveTheSameBytesEachTime) {
  for (const char* ending : {"pdf", "ps"}) {
    const std::string first = in_folder("first.") + ending, second = in_folder("second.") + ending;
    draw_sample(first);
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));
    draw_sample(second);
    EXPECT_EQ(content_of(first), content_of(second)) << ending;
    EXPECT_EQ(content_of(first).find("CreationDate"), std::string::npos) << ending;
  }
}

TEST_F(CanvasTest, WritesJpegOfTheSameSize) {
  draw_sample(in_folder("a.jpg"));
  const std::string bytes = content_of(in_folder("a.jpg"));
  ASSERT_THAT(bytes, StartsWith("\xff\xd8\xff"));
  const std::size_t frame = bytes.find("\xff\xc0");  // start of frame: marker, length, bits, height, width
  ASSERT_NE(frame, std::string::npos);
  EXPECT_EQ(big_endian(bytes, frame + 5, 2), 100);
  EXPECT_EQ(big_endian(bytes, frame + 7, 2), 200);
  EXPECT_EQ(bytes.substr(bytes.size() - 2), "\xff\xd9");
}

TEST_F(CanvasTest, WritesVectorFormats) {
  for (const char* name : {"a.svg", "a.pdf", "a.ps"}) draw_sample(in_folder(name));
  EXPECT_THAT(content_of(in_folder("a.svg")), HasSubstr("width=\"72pt\" height=\"36pt\""));
  EXPECT_THAT(content_of(in_folder("a.svg")), HasSubstr("</svg>"));
  EXPECT_THAT(content_of(in_folder("a.pdf")), StartsWith("%PDF-"));
  EXPECT_THAT(content_of(in_folder("a.pdf")), HasSubstr("%%EOF"));
  EXPECT_THAT(content_of(in_folder("a.ps")), StartsWith("%!PS-Adobe"));
  EXPECT_THAT(content_of(in_folder("a.ps")), HasSubstr("%%EOF"));
}

TEST_F(CanvasTest, AnImageKeepsItsPixels) {
  const std::vector<std::uint32_t> part{0x102030, 0xffeedd, 0x010101, 0x00ff00};
  Canvas canvas(in_folder("a.png"), 6 * 72 / 200.0, 4 * 72 / 200.0, 200);
  canvas.image({2.2 * 72 / 200, 0.9 * 72 / 200}, {part.data(), 2, 2, 2}, 200);
  canvas.finish();
  std::vector<std::uint32_t> page(6 * 4, 0xffffff);
  page[1 * 6 + 2] = part[0];
  page[1 * 6 + 3] = part[1];
  page[2 * 6 + 2] = part[2];
  page[2 * 6 + 3] = part[3];
  EXPECT_EQ(content_of(in_folder("a.png")), encode_png({page.data(), 6, 4, 6}));
}

TEST_F(CanvasTest, LeavesNothingBesideTheFile) {
  draw_sample(in_folder("a.png"));
  EXPECT_EQ(files(), 1u);
  { Canvas abandoned(in_folder("b.png"), 10, 10); }
  EXPECT_EQ(files(), 1u);
}

TEST(Canvas, NamesTheValidEndingsForAnUnknownOne) {
  for (const char* name : {"a.gif", "a", "folder.png/a"}) {
    try {
      picture_format(name);
      FAIL() << name;
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::input);
      EXPECT_THAT(e.what(), HasSubstr(".png, .jpg, .svg, .pdf or .ps"));
    }
  }
  EXPECT_EQ(picture_format("A.PNG"), PictureFormat::png);
}

TEST_F(CanvasTest, FailsAsAFileErrorWhereItCannotWrite) {
  for (const std::string& path : {in_folder("missing/a.png"), in_folder("missing/a.svg")}) {
    try {
      draw_sample(path);
      FAIL() << path;
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::file);
      EXPECT_THAT(e.what(), HasSubstr(path));
    }
  }
}

TEST(Canvas, RefusesAPageThatIsTooLarge) { EXPECT_THROW(Canvas("a.png", 1e6, 1e6), Error); }

}  // namespace
}  // namespace supple
