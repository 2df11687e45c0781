#include "supple/io/run/run_pictures.hpp"

#include <gmock/gmock.h>

#include "supple/core/error.hpp"
#include "tests/io/body_run.hpp"
#include "tests/io/count_of.hpp"
#include "tests/io/temporary_folder.hpp"

namespace supple {
namespace {

using testing::content_of;
using testing::count_of;

constexpr const char* lowest = "fill:rgb(99.607843%,98.431373%,91.372549%)";
constexpr const char* wall = "fill:rgb(60%,60%,60%)";

class BodyPictures : public testing::TemporaryFolder {
 protected:
  RunFile run_of(const std::string& experiment, int frames = 3, bool walls = false) {
    FileRecorder recorder(in_folder("run.h5"), testing::body_case(experiment), "", Existing::replace);
    RunInfo<2> info = testing::body_info();
    if (walls) info.box.periodic = {false, false};
    recorder.begin(info);
    for (int k = 0; k < frames; ++k) {
      Frame<2> frame = testing::body_frame(k);
      if (experiment == "slump" && k > 0) frame.length = {30, 10};
      recorder.frame(frame);
    }
    recorder.finish("complete");
    return RunFile(in_folder("run.h5"));
  }
  std::string snapshot(const RunFile& run, std::int64_t k, const std::string& color = "") {
    draw_frame(in_folder("a.svg"), run, k, {color});
    return content_of(in_folder("a.svg"));
  }
  static std::string size(const std::string& svg) { return svg.substr(svg.find("width="), 40); }
};

TEST_F(BodyPictures, ColoursAreTheNumbersOfTheFrame) {
  const RunFile run = run_of("jamming");
  EXPECT_EQ(body_colors(run, 0), (std::vector<std::string>{"id", "area", "contacts", "pressure"}));
  EXPECT_EQ(count_of(snapshot(run, 0, "pressure"), lowest), 1 + 4);  // the square bears none
  EXPECT_EQ(count_of(snapshot(run, 2, "id"), lowest), 0);
}

TEST_F(BodyPictures, SuggestTheColourThatWasMeant) {
  const RunFile run = run_of("jamming");
  const auto message = [&](const std::string& color) -> std::string {
    try {
      draw_frame(in_folder("b.svg"), run, 0, {color});
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::input);
      return e.what();
    }
    return "";
  };
  EXPECT_THAT(message("presure"), ::testing::HasSubstr("no colour 'presure'; did you mean 'pressure'?"));
  EXPECT_THAT(message("temperature"),
              ::testing::HasSubstr("choose from 'id', 'area', 'contacts', 'pressure'"));
  EXPECT_THROW(draw_frame(in_folder("b.svg"), run, 3), Error);
}

TEST_F(BodyPictures, AHeapHasNoLidAndLosesItsRightWall) {
  EXPECT_EQ(count_of(snapshot(run_of("uniaxial_compression", 2, true), 1), wall), 4);
  const RunFile heap = run_of("slump", 2, true);
  EXPECT_EQ(count_of(snapshot(heap, 0), wall), 3);
  EXPECT_EQ(count_of(snapshot(heap, 1), wall), 2);
}

TEST_F(BodyPictures, TheTitleOfACompressionIsTheStrainOfItsFrame) {
  FileRecorder recorder(in_folder("run.h5"), testing::body_case("uniaxial_compression"), "");
  recorder.begin(testing::body_info());
  for (int k = 0; k < 2; ++k) {
    Frame<2> frame = testing::body_frame(0);
    frame.step = k;
    frame.time = 0;  // nothing moves
    frame.numbers["uniaxial_strain"] = 0.1 * k;
    recorder.frame(frame);
  }
  recorder.finish("complete");
  const RunFile run(in_folder("run.h5"));
  const auto page = [&](std::int64_t k) {
    const std::string svg = snapshot(run, k);
    return svg.substr(svg.find("<rect"));  // behind the names of the surface
  };
  EXPECT_TRUE(page(0) == page(0));
  EXPECT_FALSE(page(0) == page(1));
}

TEST_F(BodyPictures, ImagesShareTheirPageAndTheirScales) {
  const RunFile run = run_of("slump", 5, true);
  EXPECT_EQ(draw_frames(folder(), "svg", run, 3, {"pressure"}), 3);
  std::string svg[3];
  for (int k = 0; k < 3; ++k) svg[k] = content_of(in_folder("image000000" + std::to_string(k) + ".svg"));
  EXPECT_EQ(size(svg[0]), size(svg[1]));
  EXPECT_EQ(size(svg[0]), size(svg[2]));
  EXPECT_EQ(count_of(svg[0], lowest), 1 + 4);  // 0 of 0 to 4e-3
  EXPECT_EQ(count_of(svg[2], lowest), 0);      // 2e-3 is no longer the least
  EXPECT_THROW(draw_frames(folder(), "bmp", run, 3), Error);
}

}  // namespace
}  // namespace supple
