#include "supple/draw/page/snapshot.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "supple/core/error.hpp"
#include "supple/draw/canvas/color.hpp"
#include "tests/io/count_of.hpp"
#include "tests/io/sample_scene.hpp"
#include "tests/io/temporary_folder.hpp"

namespace supple {
namespace {

using testing::content_of;
using testing::count_of;

/// A square, a disc and a triangle that touches both, away from the boundary.
Scene middle_scene() {
  Scene scene;
  scene.box.length = {10, 10};
  scene.begin = {0, 4, 5, 8};
  scene.position = {{3, 3}, {5, 3}, {5, 5}, {3, 5}, {8, 4}, {5.7, 3}, {6.8, 4}, {5.7, 5}};
  scene.radius = {0.4, 0.4, 0.4, 0.4, 0.9, 0.4, 0.4, 0.4};
  scene.contacts = {{1, 5, 0.2}, {2, 7, 0.2}, {4, 6, 0.1}};
  return scene;
}

constexpr const char* contact_color = "80%,6.666667%,26.666667%";
constexpr const char* wall_color = "60%,60%,60%";

class PolygonSnapshot : public testing::TemporaryFolder {
 protected:
  std::string svg(const Scene& scene, const SnapshotOptions& options = {}) {
    draw_snapshot(in_folder("a.svg"), scene, options);
    return content_of(in_folder("a.svg"));
  }
  static int fills(const std::string& svg, const std::string& rgb) {
    return count_of(svg, "fill:rgb(" + rgb + ")");
  }
  static int strokes(const std::string& svg, const std::string& rgb) {
    return count_of(svg, "stroke:rgb(" + rgb + ")");
  }
};

TEST_F(PolygonSnapshot, FillsThePolygonAndItsVertices) {
  SnapshotOptions options;
  options.scalar =
      BodyScalar{"shape", "", {0, 1, std::numeric_limits<double>::quiet_NaN()}, std::pair(0.0, 2.0)};
  const std::string picture = svg(middle_scene(), options);
  EXPECT_EQ(fills(picture, "99.607843%,98.431373%,91.372549%"),
            1 + 4);  // lowest colour: polygon and four vertices
  EXPECT_EQ(fills(picture, "60.784314%,82.352941%,88.235294%"), 1);      // middle: the disc
  EXPECT_EQ(fills(picture, "86.666667%,86.666667%,86.666667%"), 1 + 3);  // grey: no number
}

TEST_F(PolygonSnapshot, ColoursBodiesThatTouchDifferentlyWhereThereIsNoNumber) {
  const std::string picture = svg(middle_scene());
  std::multiset<int> shapes;  // of each colour
  for (const Color& c : area_palette) {
    const int count =
        fills(picture, fmt::format("{:.8g}%,{:.8g}%,{:.8g}%", 100 * c.red, 100 * c.green, 100 * c.blue));
    if (count > 0) shapes.insert(count);
  }
  EXPECT_EQ(shapes, (std::multiset<int>{1 + 4, 1, 1 + 3}));
}

TEST_F(PolygonSnapshot, DrawsEachContactAndExplainsTheirWidth) {
  Scene scene = middle_scene();
  EXPECT_EQ(strokes(svg(scene), contact_color), 3 + 2);
  scene.contacts.clear();
  EXPECT_EQ(strokes(svg(scene), contact_color), 0);
}

TEST_F(PolygonSnapshot, MakesContactsAsWideAsTheirForce) {
  SnapshotOptions options;
  options.full_force = 0.4;
  const std::string picture = svg(middle_scene(), options);
  const auto widths = [&] {
    std::vector<double> found;
    const std::string key = "stroke-width:";
    std::size_t at = 0;
    while ((at = picture.find(contact_color, at + 1)) != std::string::npos)
      found.push_back(std::stod(picture.substr(picture.rfind(key, at) + key.size())));
    return found;
  }();
  ASSERT_EQ(widths.size(), 5u);
  EXPECT_NEAR(widths[0], widths[3], 1e-5);  // the legend shows 0.4 rounded below, 0.2, and half of it
  EXPECT_NEAR(widths[1], widths[3], 1e-5);
  EXPECT_NEAR(widths[2], 0.5 * widths[3], 1e-5);
  EXPECT_NEAR(widths[4], 0.5 * widths[3], 1e-5);
}

TEST_F(PolygonSnapshot, DrawsTheWallsOfACellThatIsNotPeriodic) {
  Scene scene = middle_scene();
  EXPECT_EQ(fills(svg(scene), wall_color), 0);
  scene.box.periodic = {true, false};
  EXPECT_EQ(fills(svg(scene), wall_color), 2);
  scene.box.periodic = {false, false};
  EXPECT_EQ(fills(svg(scene), wall_color), 4);
  scene.walls = Walls{.bottom = true};
  const std::string picture = svg(scene);
  EXPECT_EQ(fills(picture, wall_color), 1);
  EXPECT_EQ(count_of(picture, "stroke-dasharray"), 3);  // open sides
}

TEST_F(PolygonSnapshot, RepeatsABodyAcrossTheBoundary) {
  Scene scene = middle_scene();
  scene.contacts.clear();
  const std::string inside = svg(scene);
  for (Vec2& x : scene.position) x[0] -= 3.2;  // the square sticks out to the left
  const std::string across = svg(scene);
  const std::string first = "46.666667%,66.666667%,86.666667%";
  EXPECT_EQ(fills(inside, first), 1 + 4);
  EXPECT_EQ(fills(across, first), 1 + 4 + 1 + 2);  // of the image at the right side two vertices show
}

TEST_F(PolygonSnapshot, SmoothBodiesHaveNoDiscsOnTheirVertices) {
  Scene scene = middle_scene();
  scene.contacts.clear();
  const std::string first = "46.666667%,66.666667%,86.666667%";
  EXPECT_EQ(fills(svg(scene), first), 1 + 4);
  scene.boundary = Boundary::smooth;
  EXPECT_EQ(fills(svg(scene), first), 1);
}

TEST_F(PolygonSnapshot, WritesEveryFormat) {
  SnapshotOptions options;
  options.scalar = BodyScalar{"pressure P", "", {1e-7, 0, 2.5e-7}};
  for (const char* name : {"a.png", "a.jpg", "a.svg", "a.pdf", "a.ps"}) {
    draw_snapshot(in_folder(name), testing::sample_scene(), options);
    EXPECT_GT(content_of(in_folder(name)).size(), 1000u) << name;
  }
}

TEST_F(PolygonSnapshot, IsTheSamePageForEveryStrainThatRoomIsLeftFor) {
  Scene scene = middle_scene();
  SnapshotOptions options;
  options.strain_room = 0.2;
  std::vector<std::string> sizes;
  for (const double strain : {0.0, 0.2, -0.2}) {
    scene.box.strain = strain;
    draw_snapshot(in_folder("a.png"), scene, options);
    sizes.push_back(content_of(in_folder("a.png")).substr(16, 8));
  }
  EXPECT_EQ(sizes[0], sizes[1]);
  EXPECT_EQ(sizes[0], sizes[2]);
}

TEST_F(PolygonSnapshot, DrawsAnEmptyCell) {
  Scene scene;
  scene.box.length = {3, 2};
  EXPECT_NO_THROW(svg(scene));
}

TEST_F(PolygonSnapshot, RefusesNumbersThatDoNotFit) {
  SnapshotOptions options;
  options.scalar = BodyScalar{"shape", "", {1, 2}};
  EXPECT_THROW(svg(middle_scene(), options), Error);
  options.scalar = BodyScalar{"shape", "", {1, 2, 3}, std::pair(1.0, 1.0)};
  EXPECT_THROW(svg(middle_scene(), options), Error);
  EXPECT_EQ(files(), 0u);
}

}  // namespace
}  // namespace supple
