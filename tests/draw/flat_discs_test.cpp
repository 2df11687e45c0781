#include "supple/draw/scene/flat_discs.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "supple/core/random.hpp"
#include "supple/draw/scene/frame_scene.hpp"
#include "supple/draw/scene/layout.hpp"
#include "supple/model/evaluation.hpp"

namespace supple {
namespace {

Box<2> square(double strain) {
  Box<2> box;
  box.length = {10, 10};
  box.strain = strain;
  return box;
}

Scene scene_at(std::vector<Vec2> positions, std::vector<double> radius, double strain = 0) {
  Scene scene;
  scene.box = square(strain);
  scene.position = std::move(positions);
  scene.radius = std::move(radius);
  return scene;
}

double area(const std::vector<Vec2>& outline) {
  double twice = 0;
  for (std::size_t k = 0; k < outline.size(); ++k)
    twice += cross(outline[k], outline[(k + 1) % outline.size()]);
  return 0.5 * twice;
}

TEST(CellScene, LeansByTheStrainUntilAnImageCellFitsBetter) {
  EXPECT_DOUBLE_EQ(drawn_strain(square(0.2)), 0.2);
  EXPECT_NEAR(drawn_strain(square(-1.7)), 0.3, 1e-12);
  Box<2> walls = square(0.2);
  walls.periodic[flow] = false;
  EXPECT_EQ(drawn_strain(walls), 0);
}

TEST(CellScene, KeepsEveryDiscInsideTheLeaningCell) {
  const Box<2> box = square(0.4);
  std::vector<Vec2> positions;
  RandomStream draw(1, Purpose::test);
  for (int i = 0; i < 200; ++i) positions.push_back({draw.uniform(-15, 25), draw.uniform(-15, 25)});
  const std::vector<DrawnBody> discs =
      lay_out_bodies(scene_at(positions, std::vector<double>(200, 0.1), 0.4), 0);
  for (int i = 0; i < 200; ++i) {
    ASSERT_EQ(discs[i].body, i);
    const Vec2 x = positions[i] + discs[i].shift;
    const double along = x[0] - 0.4 * (x[1] - 5);
    EXPECT_TRUE(along >= 0 && along <= 10 && x[1] >= 0 && x[1] <= 10) << x[0] << " " << x[1];
    EXPECT_NEAR(norm(box.displacement(positions[i], x)), 0, 1e-12);  // by lattice vectors only
  }
}

TEST(CellScene, DrawsAContactAcrossABoundaryToTheImage) {
  for (const double strain : {0.0, 0.3, -1.4}) {
    // Side by side across the flow period; and one above the other across the sheared one.
    Scene scene =
        scene_at({{0.5, 5}, {9.7, 5}, {3, 0.4}, {3 + strain * 10, 9.6}}, std::vector<double>(4, 0.5), strain);
    scene.contacts = {{0, 1, 1, 0, ContactState::stick}, {2, 3, 1, 0, ContactState::slip}};
    const std::vector<ContactImage> lines = lay_out_contacts(scene, 0.5);
    ASSERT_GE(lines.size(), 4u);  // each shows at both sides
    for (const ContactImage& line : lines) EXPECT_NEAR(norm(line.to - line.from), 0.8, 1e-9);
  }
}

/// Six apart in a cell of ten, the nearest image is four away on the other side: the force says which of them
/// is linked, whichever comes first.
TEST(CellScene, DrawsALongLinkToItsOwnImage) {
  for (const double strain : {0.0, 0.3})
    for (const bool turned : {false, true}) {
      RunInfo<2> info;
      info.box = square(strain);
      info.radius = {0.5, 0.5};
      info.particle = {0, 0};
      Frame<2> frame;
      frame.strain = strain;
      frame.position = turned ? std::vector<Vec2>{{8, 5}, {2, 5}} : std::vector<Vec2>{{2, 5}, {8, 5}};
      ContactRow<2> link{0, 1, ContactState::permanent, 0, 0, -1, 0.25};
      for (const double side : {1., -1.}) {
        link.force = force_on_first(link.normal_force, link.tangential_force, Vec2{turned ? -side : side, 0});
        frame.contacts = {link};
        const std::vector<ContactImage> lines = lay_out_contacts(scene_of(info, frame), 0.5);
        ASSERT_FALSE(lines.empty());
        for (const ContactImage& line : lines)
          EXPECT_NEAR(norm(line.to - line.from), side > 0 ? 6 : 4, 1e-9) << turned << side;
      }
    }
}

TEST(CellScene, DrawsAContactInTheMiddleOnce) {
  Scene scene = scene_at({{5, 5}, {5.8, 5}}, {0.5, 0.5});
  scene.contacts = {{0, 1, 1, 0, ContactState::stick}};
  EXPECT_EQ(lay_out_contacts(scene, 0.5).size(), 1u);
}

TEST(CellScene, FlattensOverlappingDiscsAtTheirCommonChord) {
  const std::vector<FlatDisc> discs = flatten_discs(scene_at({{4, 5}, {5.4, 5}}, {1, 0.8}));
  const double chord = 4 + (1.4 * 1.4 + 1 - 0.64) / 2.8;
  for (const Vec2& x : discs[0].outline) EXPECT_LE(x[0], chord + 1e-12);
  for (const Vec2& x : discs[1].outline) EXPECT_GE(x[0], chord - 1e-12);
  EXPECT_EQ(std::count(discs[0].across.begin(), discs[0].across.end(), 1), 1);
  EXPECT_EQ(std::count(discs[1].across.begin(), discs[1].across.end(), 0), 1);
}

TEST(CellScene, TilesADenseCellWithoutOverlap) {
  std::vector<Vec2> positions;
  for (int i = 0; i < 100; ++i) positions.push_back({i % 10 + 0.03 * (i % 7), i / 10 + 0.05 * (i % 3)});
  const std::vector<FlatDisc> discs = flatten_discs(scene_at(positions, std::vector<double>(100, 0.9), 0.15));
  double sum = 0;
  for (int i = 0; i < 100; ++i) sum += area(discs[i].outline);
  EXPECT_NEAR(sum, 100, 1e-9);  // the discs cover the cell
}

/// Two discs that meet across the boundary, one of them a cell further to the left.
TEST(CellScene, FlattensADiscByTheImageOfItsNeighbour) {
  const std::vector<FlatDisc> discs = flatten_discs(scene_at({{-9.6, 5}, {9.6, 5}}, {0.6, 0.6}));
  EXPECT_NEAR(discs[0].outline[0][0], -9, 1e-12);
  for (const Vec2& x : discs[0].outline) EXPECT_GE(x[0], -10 - 1e-12);
  for (const Vec2& x : discs[1].outline) EXPECT_LE(x[0], 10 + 1e-12);
}

}  // namespace
}  // namespace supple
