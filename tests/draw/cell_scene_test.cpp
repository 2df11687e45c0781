#include "supple/draw/scene/cell_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "supple/core/random.hpp"
#include "supple/model/evaluation.hpp"

namespace supple {
namespace {

Box<2> square(double strain) {
  Box<2> box;
  box.length = {10, 10};
  box.strain = strain;
  return box;
}

Frame frame_at(std::vector<Vec2> positions) {
  Frame frame;
  frame.position = std::move(positions);
  return frame;
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
  const CellScene scene = lay_out_cell(box, std::vector<double>(200, 0.1), frame_at(positions), 0);
  for (int i = 0; i < 200; ++i) {
    const Vec2 x = scene.discs[i].centre;
    const double along = x[0] - 0.4 * (x[1] - 5);
    EXPECT_TRUE(along >= 0 && along <= 10 && x[1] >= 0 && x[1] <= 10) << x[0] << " " << x[1];
    EXPECT_NEAR(norm(box.displacement(positions[i], x)), 0, 1e-12);  // by lattice vectors only
  }
}

TEST(CellScene, DrawsAContactAcrossABoundaryToTheImage) {
  for (const double strain : {0.0, 0.3, -1.4}) {
    const Box<2> box = square(strain);
    // Side by side across the flow period; and one above the other across the sheared one.
    Frame frame = frame_at({{0.5, 5}, {9.7, 5}, {3, 0.4}, {3 + strain * 10, 9.6}});
    frame.contacts = {{0, 1, ContactState::stick, 0, 0, 1, 0}, {2, 3, ContactState::slip, 0, 0, 1, 0}};
    const CellScene scene = lay_out_cell(box, std::vector<double>(4, 0.5), frame, 0.5);
    ASSERT_GE(scene.lines.size(), 4u);  // each shows at both sides
    for (const SceneLine& line : scene.lines) EXPECT_NEAR(norm(line.to - line.from), 0.8, 1e-9);
  }
}

/// Six apart in a cell of ten, the nearest image is four away on the other side: the force says which of them
/// is linked.
TEST(CellScene, DrawsALongLinkToItsOwnImage) {
  for (const double strain : {0.0, 0.3}) {
    Frame frame = frame_at({{2, 5}, {8, 5}});
    ContactRow link{0, 1, ContactState::permanent, 0, 0, -1, 0.25};
    for (const double side : {1., -1.}) {
      link.force = force_on_first(link.normal_force, link.tangential_force, Vec2{side, 0});
      frame.contacts = {link};
      const CellScene scene = lay_out_cell(square(strain), std::vector<double>(2, 0.5), frame, 0.5);
      ASSERT_FALSE(scene.lines.empty());
      for (const SceneLine& line : scene.lines)
        EXPECT_NEAR(norm(line.to - line.from), side > 0 ? 6 : 4, 1e-9);
    }
  }
}

TEST(CellScene, DrawsAContactInTheMiddleOnce) {
  Frame frame = frame_at({{5, 5}, {5.8, 5}});
  frame.contacts = {{0, 1, ContactState::stick, 0, 0, 1, 0}};
  EXPECT_EQ(lay_out_cell(square(0), std::vector<double>(2, 0.5), frame, 0.5).lines.size(), 1u);
}

TEST(CellScene, FlattensOverlappingDiscsAtTheirCommonChord) {
  const CellScene scene =
      lay_out_cell(square(0), std::vector<double>{1, 0.8}, frame_at({{4, 5}, {5.4, 5}}), 0);
  const double chord = 4 + (1.4 * 1.4 + 1 - 0.64) / 2.8;
  for (const Vec2& x : scene.discs[0].outline) EXPECT_LE(x[0], chord + 1e-12);
  for (const Vec2& x : scene.discs[1].outline) EXPECT_GE(x[0], chord - 1e-12);
  EXPECT_EQ(std::count(scene.discs[0].across.begin(), scene.discs[0].across.end(), 1), 1);
  EXPECT_EQ(std::count(scene.discs[1].across.begin(), scene.discs[1].across.end(), 0), 1);
}

TEST(CellScene, TilesADenseCellWithoutOverlap) {
  std::vector<Vec2> positions;
  for (int i = 0; i < 100; ++i) positions.push_back({i % 10 + 0.03 * (i % 7), i / 10 + 0.05 * (i % 3)});
  const CellScene scene = lay_out_cell(square(0.15), std::vector<double>(100, 0.9), frame_at(positions), 0);
  double sum = 0;
  for (int i = 0; i < 100; ++i) sum += area(scene.discs[i].outline);
  EXPECT_NEAR(sum, 100, 1e-9);  // the discs cover the cell
}

}  // namespace
}  // namespace supple
