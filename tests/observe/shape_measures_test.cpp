#include "supple/observe/shape_measures.hpp"

#include <gmock/gmock.h>

#include <numbers>

#include "tests/support/polygons.hpp"
#include "tests/support/surfaces.hpp"

namespace supple {
namespace {

using std::numbers::pi;
using ::testing::ElementsAre;

void add_square(System<2>& system, double x, double y, double width, double height) {
  const std::vector<double> four(4, 1);
  add_ring(system, {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}}, 0.1, {}, 1, four,
           four);
}

TEST(ShapeMeasures, ClosedForms) {
  System<2> system;
  system.box.length = {10, 10};
  add_square(system, 8, -3, 4, 2);
  add_disc_body(system, {1, 2}, 3);
  add_polygon(system, {5, 6}, 2.5, 7, 0.3, 1, {});
  const ShapeMeasures<2> m = measure_shapes(system);
  EXPECT_THAT(m.volume, ElementsAre(8, 9 * pi, ::testing::DoubleNear(2.5, 1e-14)));
  EXPECT_EQ(m.surface[0], 12);
  EXPECT_NEAR(m.surface[1], 6 * pi, 1e-14);
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
  const ShapeMeasures<2> m = measure_shapes(system);
  EXPECT_EQ(m.volume[0], 5);
  EXPECT_NEAR(m.centre[0][0], (4 * 1 + 2.5) / 5, 1e-15);
  EXPECT_NEAR(m.centre[0][1], (4 * 1 + 0.5) / 5, 1e-15);
}

/// Discs have no shape parameter: they would pull the mean down.
TEST(ShapeMeasures, TheMeanShapeParameterIsThatOfThePolygons) {
  System<2> system;
  add_disc_body(system, {1, 2}, 3);
  EXPECT_FALSE(mean_shape_parameter(measure_shapes(system)));
  add_square(system, 8, -3, 1, 1);
  add_square(system, 8, 3, 4, 2);
  add_disc_body(system, {10, 20}, 3);
  EXPECT_NEAR(*mean_shape_parameter(measure_shapes(system)), 0.5 * (16 / (4 * pi) + 144 / (32 * pi)), 1e-14);
}

TEST(ShapeMeasures, ClosedFormsInThreeDimensions) {
  System<3> system;
  system.box.length = {10, 10, 10};
  testing::add_mesh(system, testing::box_mesh({2, 3, 4}), 0.1, {100, -20, 5});
  add_sphere_body(system, {1, 2, 3}, 2);
  testing::add_mesh(system, geodesic_icosahedron(42, 2.5), 0.1, {7, 8, 9});
  const ShapeMeasures<3> m = measure_shapes(system);
  EXPECT_NEAR(m.volume[0], 24, 1e-13);
  EXPECT_NEAR(m.surface[0], 52, 1e-13);
  EXPECT_NEAR(m.shape_parameter[0], std::pow(52, 1.5) / (6 * std::sqrt(pi) * 24), 1e-14);
  EXPECT_NEAR(norm(m.centre[0] - Vec3{101, -18.5, 7}), 0, 1e-13);
  EXPECT_NEAR(m.volume[1], 32 * pi / 3, 1e-13);
  EXPECT_NEAR(m.surface[1], 16 * pi, 1e-13);
  EXPECT_EQ(m.shape_parameter[1], 0);
  EXPECT_EQ(m.centre[1], (Vec3{1, 2, 3}));
  EXPECT_NEAR(m.volume[2], 2.5, 1e-13);
  EXPECT_NEAR(m.shape_parameter[2], 1.0241, 5e-5);
  EXPECT_NEAR(norm(m.centre[2] - Vec3{7, 8, 9}), 0, 1e-13);
  EXPECT_NEAR(*mean_shape_parameter(m), 0.5 * (m.shape_parameter[0] + m.shape_parameter[2]), 1e-15);
}

/// An L-shaped beam is the box of (4, 2, 3) and the trapezium between x = 2 .. 4 and 2.3 .. 4 above it.
TEST(ShapeMeasures, CentreOfAnLShapedBeam) {
  System<3> system;
  testing::add_mesh(system, testing::ell_mesh(), 0.1);
  const ShapeMeasures<3> m = measure_shapes(system);
  const double box = 4 * 2 * 3, square = 1.7 * 2 * 3, wedge = 0.5 * 0.3 * 2 * 3;
  EXPECT_NEAR(m.volume[0], box + square + wedge, 1e-13);
  const double x = (2 * box + 3.15 * square + 2.2 * wedge) / m.volume[0];
  const double y = (1 * box + 3 * square + (2 + 2.0 / 3) * wedge) / m.volume[0];
  EXPECT_NEAR(norm(m.centre[0] - Vec3{x, y, 1.5}), 0, 1e-13);
}

}  // namespace
}  // namespace supple
