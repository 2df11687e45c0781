#include "supple/observe/shape_measures.hpp"

#include <gmock/gmock.h>

#include <numbers>

#include "tests/support/polygons.hpp"

namespace supple {
namespace {

using std::numbers::pi;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

void add_square(System<2>& system, double x, double y, double width, double height) {
  const std::vector<double> four(4, 1);
  add_ring(system, {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}}, 0.1, {}, 1, four, four);
}

TEST(ShapeMeasures, ClosedForms) {
  System<2> system;
  system.box.length = {10, 10};
  add_square(system, 8, -3, 4, 2);
  add_disc_body(system, {1, 2}, 3);
  add_polygon(system, {5, 6}, 2.5, 7, 0.3, 1, {});
  const ShapeMeasures m = measure_shapes(system);
  EXPECT_THAT(m.area, ElementsAre(8, 9 * pi, ::testing::DoubleNear(2.5, 1e-14)));
  EXPECT_EQ(m.perimeter[0], 12);
  EXPECT_NEAR(m.perimeter[1], 6 * pi, 1e-14);
  EXPECT_NEAR(m.shape_parameter[0], 144 / (32 * pi), 1e-14);
  EXPECT_EQ(m.shape_parameter[1], 0);
  EXPECT_NEAR(m.shape_parameter[2], least_shape_parameter(7), 1e-14);
  EXPECT_NEAR(norm(m.centre[0] - Vec2{10, -2}), 0, 1e-14);
  EXPECT_EQ(m.centre[1], (Vec2{1, 2}));
  EXPECT_NEAR(norm(m.centre[2] - Vec2{5, 6}), 0, 1e-14);
}

TEST(ShapeMeasures, CentreOfAnLShape) {
  // Of area 2 x 2 + 1 x 1, centres (1, 1) and (2.5, 0.5).
  System<2> system;
  const std::vector<double> some(6, 1);
  add_ring(system, {{0, 0}, {3, 0}, {3, 1}, {2, 1}, {2, 2}, {0, 2}}, 0.1, {}, 1, some, some);
  const ShapeMeasures m = measure_shapes(system);
  EXPECT_EQ(m.area[0], 5);
  EXPECT_NEAR(m.centre[0][0], (4 * 1 + 2.5) / 5, 1e-15);
  EXPECT_NEAR(m.centre[0][1], (4 * 1 + 0.5) / 5, 1e-15);
}

TEST(ShapeMeasures, FindsBodiesInsideOthers) {
  System<2> system;
  system.box.length = {20, 20};
  system.box.strain = 0.25;
  add_square(system, 18, 19, 4, 4);           // across both periods: its lower part is 5 to the left
  add_square(system, 16.5, 2.5, 0.25, 0.25);  // in that part
  add_square(system, 12, 8, 1, 1);
  add_disc_body(system, {12.5, 8.5}, 0.1);  // in the one before
  add_square(system, 12.9, 8.95, 3, 0.5);   // overlaps it
  add_square(system, 5, 15, 1, 1);
  EXPECT_THAT(bodies_inside_others(system), ElementsAre(1, 2, 3, 4));
  for (int k = 4; k < 8; ++k) system.state.position[k] += Vec2{40 - 5, -20};
  EXPECT_THAT(bodies_inside_others(system), ElementsAre(1, 2, 3, 4)) << "another copy of the same";
  for (int k = 4; k < 8; ++k) system.state.position[k][0] += 5;
  EXPECT_THAT(bodies_inside_others(system), ElementsAre(2, 3, 4));
  testing::PackingDraw apart;
  apart.spacing = 3.2;
  EXPECT_THAT(bodies_inside_others(testing::random_polygons(apart)), IsEmpty());
}

}  // namespace
}  // namespace supple
