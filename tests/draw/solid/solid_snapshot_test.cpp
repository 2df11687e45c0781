#include "supple/draw/solid/solid_snapshot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "supple/core/error.hpp"
#include "tests/draw/solid/scenes.hpp"
#include "tests/io/count_of.hpp"
#include "tests/io/temporary_folder.hpp"

namespace supple {
namespace {

using namespace testing;
using ::testing::HasSubstr;

class SolidSnapshotTest : public TemporaryFolder {
 protected:
  std::string drawn(const std::string& name, const SolidScene& scene,
                    const SolidSnapshotOptions& options = {}) {
    draw_solid_snapshot(in_folder(name), scene, options);
    return content_of(in_folder(name));
  }
};

SolidScene two_particles() {
  SolidScene scene = empty_cell();
  add_mesh(scene, geodesic_icosahedron(42, 30), {4, 4, 4});
  add_ball(scene, {7, 7, 7}, 2);
  return scene;
}

int big_endian(const std::string& bytes, std::size_t at) {
  int value = 0;
  for (int k = 0; k < 4; ++k) value = 256 * value + static_cast<unsigned char>(bytes[at + k]);
  return value;
}

TEST_F(SolidSnapshotTest, WritesEveryFormatWithTheSameBytesEachTime) {
  SolidSnapshotOptions options;
  options.scalar = BodyScalar{"pressure", "", {1, 2}};
  options.edges = TriangleEdges::drawn;
  options.cell_size = 60;
  for (const Images images : {Images::whole, Images::cut})
    for (const std::string ending : {".png", ".jpg", ".svg", ".pdf", ".ps"}) {
      SolidScene scene = two_particles();
      scene.images = images;
      const std::string bytes = drawn("a" + ending, scene, options);
      EXPECT_GT(bytes.size(), 1000u);
      // Cairo counts the surfaces of a process in the names of SVG.
      const std::string again = drawn("b" + ending, scene, options);
      EXPECT_TRUE(again == bytes || ending == ".svg") << ending;
    }
}

TEST_F(SolidSnapshotTest, EdgesOfTheCellAreHiddenWhereTheyAreBehind) {
  const auto edges = [&](const SolidScene& scene, const char* view) {
    SolidSnapshotOptions options;
    options.view = view_of(view);
    options.cell_size = 60;
    const std::string svg = drawn("a.svg", scene, options);
    options.cell = CellFrame::hidden;
    return count_of(svg, "stroke-width:0.8") - count_of(drawn("a.svg", scene, options), "stroke-width:0.8");
  };
  SolidScene scene = empty_cell();
  add_ball(scene, {5, 5, 5}, 0.1);
  EXPECT_EQ(edges(scene, "33,12"), 12);
  scene.sphere[0] = {{11, 5, 0}, 1, 0};  // touches one edge and lies before two of the lower ones
  EXPECT_EQ(edges(scene, "0,0"), 14);
  scene.sphere[0].centre[0] = -2;  // behind all of them
  EXPECT_EQ(edges(scene, "0,0"), 12);
  scene.images = Images::cut;
  scene.sphere[0] = {{5, 5, 5}, 5, 0};  // hides the far corner and a part of each edge from there
  EXPECT_EQ(edges(scene, "corner"), 12);
  scene.sphere[0].radius = 20;  // fills the cell
  EXPECT_EQ(edges(scene, "corner"), 9);
}

TEST_F(SolidSnapshotTest, ParticlesOfVectorFormatsAreOneImageOfTheStatedResolution) {
  SolidSnapshotOptions options;
  options.cell_size = 72;
  options.view = view_of("z");
  SolidScene scene = two_particles();
  scene.images = Images::cut;  // 72 points and a rim of 2 on either side
  const std::string svg = drawn("a.svg", scene, options);
  EXPECT_EQ(count_of(svg, "<image "), 1);
  EXPECT_THAT(svg, HasSubstr("width=\"317\" height=\"317\""));  // 76/72 * 300
  options.image_dots_per_inch = 100;
  EXPECT_THAT(drawn("a.svg", scene, options), HasSubstr("width=\"106\" height=\"106\""));
}

TEST_F(SolidSnapshotTest, PagesWithTheSameRoomAreTheSame) {
  SolidScene scene = two_particles();
  SolidSnapshotOptions options;
  options.dots_per_inch = 72;
  Bounds room = extent_of(scene, options.view);
  scene.box.strain = 0.4;
  room.include(extent_of(scene, options.view));
  const auto size = [&](double strain, bool with_room) {
    scene.box.strain = strain;
    options.room = with_room ? std::optional(room) : std::nullopt;
    const std::string png = drawn("a.png", scene, options);
    return std::pair(big_endian(png, 16), big_endian(png, 20));
  };
  EXPECT_EQ(size(0, true), size(0.4, true));
  EXPECT_NE(size(0, false), size(0.4, false));
  scene.box.length *= 0.9;
  options.scale_length = 10;
  EXPECT_EQ(size(0, true), size(0.4, true));
}

TEST_F(SolidSnapshotTest, TheExtentIsThatOfCellAndParticles) {
  SolidScene scene = two_particles();
  const auto expect = [&](double left, double right, double down, double up) {
    const Bounds e = extent_of(scene, view_of("y"));
    EXPECT_NEAR(e.low[0], left, 1e-12);
    EXPECT_NEAR(e.high[0], right, 1e-12);
    EXPECT_NEAR(e.low[1], down, 1e-12);
    EXPECT_NEAR(e.high[1], up, 1e-12);
  };
  expect(-5, 5, -5, 5);
  scene.sphere[0].centre = {9, 5, -1};
  expect(-5, 6, -8, 5);
  scene.images = Images::cut;
  expect(-5, 5, -5, 5);
}

TEST_F(SolidSnapshotTest, TheTitleSaysTimeAndStrainAndTheLegendTheNumber) {
  SolidScene scene = two_particles();
  SolidSnapshotOptions options;
  options.cell_size = 60;
  const std::string bare = drawn("a.svg", scene, options);
  scene.box.strain = 0.25;
  const std::string strained = drawn("a.svg", scene, options);
  EXPECT_GT(count_of(strained, "<use "), count_of(bare, "<use ") + 4);
  options.scalar = BodyScalar{"pressure", "", {1, 2}};
  const std::string numbered = drawn("a.svg", scene, options);
  EXPECT_GT(count_of(numbered, "<use "), count_of(strained, "<use ") + 8);
}

std::string error_of(const SolidScene& scene, const SolidSnapshotOptions& options,
                     const std::string& path = "a.png") {
  try {
    draw_solid_snapshot(path, scene, options);
  } catch (const Error& e) {
    return e.what();
  }
  return "no error";
}

TEST(SolidSnapshot, SaysWhatIsWrong) {
  const SolidScene scene = two_particles();
  const auto error = [&](auto&& spoil) {
    SolidSnapshotOptions options;
    spoil(options);
    return error_of(scene, options);
  };
  using Options = SolidSnapshotOptions;
  EXPECT_THAT(error_of(empty_cell(), {}), HasSubstr("no particles"));
  EXPECT_THAT(error_of(scene, {}, "a.stl"), HasSubstr(".png, .jpg, .svg, .pdf or .ps"));
  EXPECT_THAT(error([](Options& o) { o.cell_size = 0; }), HasSubstr("size of the cell on the page is 0"));
  EXPECT_THAT(error([](Options& o) { o.dots_per_inch = -3; }), HasSubstr("pixels in an inch is -3"));
  EXPECT_THAT(error([](Options& o) { o.image_dots_per_inch = NAN; }), HasSubstr("pixels in an inch is nan"));
  EXPECT_THAT(error([](Options& o) { o.cell_size = 1e6; }), HasSubstr("smaller picture"));
  EXPECT_THAT(error([](Options& o) { o.color = {red}; }), HasSubstr("1 numbers or colours for 2 bodies"));
  EXPECT_THAT(error([](Options& o) { o.scalar = BodyScalar{"p", "", {1, 2, 3}}; }), HasSubstr("3 numbers"));
  EXPECT_THAT(error([](Options& o) {
                o.scalar = BodyScalar{"p", "", {1, 2}, {{2, 1}}};
              }),
              HasSubstr("range"));
  EXPECT_THAT(error([](Options& o) { o.view = {0, 100}; }), HasSubstr("elevation 100"));
}

}  // namespace
}  // namespace supple
