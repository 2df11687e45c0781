#include "supple/draw/page/snapshot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "supple/core/error.hpp"
#include "supple/draw/scene/colors_apart.hpp"
#include "supple/draw/scene/frame_scene.hpp"
#include "tests/io/count_of.hpp"
#include "tests/io/temporary_folder.hpp"

namespace supple {
namespace {

using testing::content_of;
using testing::count_of;

/// Two crosslinked particles of two discs and a single disc, none near the boundary, in SI.
struct Sample {
  RunInfo<2> info;
  Frame<2> frame;

  Scene scene() const { return scene_of(info, frame); }

  Sample() {
    info.box.length = {500e-6, 500e-6};
    info.radius.assign(5, 30e-6);
    info.mass = info.inertia = std::vector<double>(5, 1);
    info.particle = {0, 0, 1, 1, 2};
    frame.time = 1.5e-3;
    frame.strain = 0.1;
    frame.position = {
        {150e-6, 200e-6}, {200e-6, 200e-6}, {250e-6, 200e-6}, {300e-6, 200e-6}, {250e-6, 300e-6}};
    frame.angle.assign(5, 0.3);
    frame.mobility.assign(5, Mobility::free);
    frame.contacts = {{0, 1, ContactState::permanent, 0, 0, 10, 1},
                      {2, 3, ContactState::permanent, 0, 0, -4, 1},
                      {1, 2, ContactState::slip, 0, 0, 6, 1}};
  }
};

/// Shapes with this colour of line in an SVG picture.
int strokes(const std::string& svg, const std::string& rgb_percent) {
  return count_of(svg, "stroke:rgb(" + rgb_percent + ")");
}
constexpr const char* link_color = "33.333333%,33.333333%,33.333333%";
constexpr const char* slip_color = "80%,6.666667%,26.666667%";
constexpr const char* stick_color = "0%,20%,66.666667%";

class SnapshotTest : public testing::TemporaryFolder {};

TEST_F(SnapshotTest, DrawsOneShapeForEachDiscAndOneLineForEachContact) {
  const Sample sample;
  SnapshotOptions options;
  for (int i = 0; i < 5; ++i) options.color.push_back({0.2 * i, 1, 0.5});
  draw_snapshot(in_folder("a.svg"), sample.scene(), options);
  const std::string svg = content_of(in_folder("a.svg"));
  for (int i = 0; i < 5; ++i)
    EXPECT_EQ(count_of(svg, "fill:rgb(" + std::to_string(20 * i) + "%,100%,50%)"), 1);
  EXPECT_EQ(strokes(svg, link_color), 2 + 2);  // in the legend: compressed, and in tension
  EXPECT_EQ(strokes(svg, slip_color), 1 + 1);
  EXPECT_EQ(strokes(svg, stick_color), 0);  // no such contact, no such entry
  EXPECT_EQ(count_of(svg, "stroke-dasharray"), 2);
}

TEST_F(SnapshotTest, HatchesWhatIsHeldAndThickensItsPlate) {
  Sample sample;
  const auto ink_strokes = [&] {
    draw_snapshot(in_folder("a.svg"), sample.scene());
    return strokes(content_of(in_folder("a.svg")), "13.333333%,13.333333%,13.333333%");
  };
  const int free = ink_strokes();
  sample.frame.mobility[4] = Mobility::fixed;
  EXPECT_GT(ink_strokes(), free + 5);
  sample.frame.mobility[4] = Mobility::lower_plate;
  EXPECT_GT(ink_strokes(), free + 5);
  EXPECT_EQ(count_of(content_of(in_folder("a.svg")), "stroke-width:3;"), 1);
}

TEST_F(SnapshotTest, HatchesAPolygonOnlyWhereAllOfItIsHeld) {
  Scene scene;
  scene.box.length = {10, 10};
  scene.begin = {0, 4};
  scene.position = {{3, 3}, {6, 3}, {4, 4}, {3, 6}};  // not convex: some lines cross its edge four times
  scene.radius.assign(4, 0.2);
  const auto lines = [&] {
    draw_snapshot(in_folder("a.svg"), scene);
    return strokes(content_of(in_folder("a.svg")), "13.333333%,13.333333%,13.333333%");
  };
  const int free = lines();
  scene.mobility.assign(4, Mobility::fixed);
  EXPECT_GT(lines(), free + 5);
  scene.mobility[2] = Mobility::free;
  EXPECT_LT(lines(), free + 10);  // the legend has its few
}

/// Two linked discs that overlap, one alone, and a triangle that touches the second.
Scene mixed_scene() {
  RunInfo<2> info;
  info.box.length = {10, 10};
  info.body_begin = {0, 1, 2, 3, 6};
  info.radius = {0.8, 0.8, 0.8, 0.2, 0.2, 0.2};
  info.particle = {0, 0, 1, 0, 0, 0};
  Frame<2> frame;
  frame.position = {{3, 5}, {4, 5}, {3, 8}, {5, 5}, {7, 4}, {7, 6}};
  frame.contacts = {{0, 1, ContactState::permanent, 0, 0, 1, 0}, {1, 3, ContactState::stick, 0, 0, 1, 0}};
  return scene_of(info, frame);
}

TEST_F(SnapshotTest, DrawsMicrogelDiscsAndPolygonsInOneCell) {
  const Scene scene = mixed_scene();
  const std::vector<Color> color = colors_apart(scene);
  EXPECT_EQ(color[0], color[1]);
  EXPECT_EQ(color[2], pale_gray);
  EXPECT_NE(color[3], pale_gray);
  EXPECT_NE(color[3], color[0]);
  SnapshotOptions options;
  options.color = {{0, 1, 0.5}, {0, 1, 0.5}, {0.2, 1, 0.5}, {0.4, 1, 0.5}};
  draw_snapshot(in_folder("a.svg"), scene, options);
  const std::string svg = content_of(in_folder("a.svg"));
  EXPECT_EQ(count_of(svg, "fill:rgb(0%,100%,50%)"), 2);
  EXPECT_EQ(count_of(svg, "fill:rgb(20%,100%,50%)"), 1);
  EXPECT_EQ(count_of(svg, "fill:rgb(40%,100%,50%)"), 1 + 3);
  EXPECT_EQ(strokes(svg, link_color), 1 + 1);
  EXPECT_EQ(strokes(svg, stick_color), 1 + 1);
  EXPECT_EQ(strokes(svg, "100%,100%,100%"), 1);  // links within a particle need no halo
}

TEST_F(SnapshotTest, WritesEveryFormat) {
  const Sample sample;
  for (const char* name : {"a.png", "a.jpg", "a.svg", "a.pdf", "a.ps"}) {
    draw_snapshot(in_folder(name), sample.scene());
    EXPECT_GT(content_of(in_folder(name)).size(), 1000u) << name;
  }
}

TEST_F(SnapshotTest, IsTheSamePageForEveryStrainThatRoomIsLeftFor) {
  Sample sample;
  SnapshotOptions options;
  options.strain_room = 0.2;
  std::vector<std::string> sizes;
  for (const double strain : {0.0, 0.2, -0.2}) {
    sample.frame.strain = strain;
    draw_snapshot(in_folder("a.png"), sample.scene(), options);
    sizes.push_back(content_of(in_folder("a.png")).substr(16, 8));
  }
  EXPECT_EQ(sizes[0], sizes[1]);
  EXPECT_EQ(sizes[0], sizes[2]);
}

TEST_F(SnapshotTest, DrawsARunWithoutContactsAndOneWithoutPeriodicity) {
  Sample sample;
  sample.frame.contacts.clear();
  sample.info.box.periodic = {false, false};
  EXPECT_NO_THROW(draw_snapshot(in_folder("a.png"), sample.scene()));
}

TEST(Snapshot, RefusesAFrameOfAnotherRun) {
  Sample sample;
  sample.frame.position.pop_back();
  EXPECT_THROW(draw_snapshot("a.png", sample.scene()), Error);
}

TEST(Snapshot, WidestLineIsTheStrongestForceInNewtonPerMetre) {
  Sample sample;
  sample.info.units = particleshear_units();
  sample.frame.contacts = {{0, 1, ContactState::stick, 0, 0, 3e12, 4e12}};
  EXPECT_NEAR(strongest_force(sample.scene()), 5, 1e-12);
}

TEST(ParticleColors, DifferBetweenNeighboursAndAreGreyForSingleDiscs) {
  // A ring of 27 touching particles of two discs, closed over the period, and one disc alone. Neighbours are
  // 8 numbers apart, so that colours given in turn would clash.
  Scene scene;
  scene.box.length = {54, 60};
  std::vector<std::int32_t>& particle = scene.particle;
  for (int i = 0; i < 54; ++i) {
    scene.position.push_back({i + 0.5, 30});
    particle.push_back(i / 2 * 8 % 27);
    scene.contacts.push_back({std::min(i, (i + 1) % 54), std::max(i, (i + 1) % 54), 1});
  }
  scene.position.push_back({10, 50});
  particle.push_back(27);
  scene.radius.assign(55, 0.6);
  const std::vector<Color> color = colors_apart(scene);
  for (int i = 0; i < 54; ++i) {
    const int next = (i + 1) % 54;
    EXPECT_EQ(color[i] == color[next], particle[i] == particle[next]) << i;
  }
  EXPECT_EQ(color[54], pale_gray);
}

TEST(ColorsApart, AreOfBodiesThatTouchInOneOfTheScenes) {
  Scene apart;
  for (int b = 0; b < 9; ++b) apart.position.push_back({3. * b, 0});
  apart.radius.assign(9, 1);
  Scene together = apart;
  together.contacts = {{0, 8, 1}};  // there are eight colours, so by number alone these have the same
  const std::vector<Color> one = colors_apart(apart), both = colors_apart(std::vector{apart, together});
  EXPECT_EQ(one[0], one[8]);
  EXPECT_NE(both[0], both[8]);
}

}  // namespace
}  // namespace supple
