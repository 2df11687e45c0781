#include "supple/build/surfaces.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <numeric>

#include "supple/core/error.hpp"

namespace supple {
namespace {

double area(const TriangleMesh& mesh) {
  const std::vector<double> areas = face_areas(mesh);
  return std::accumulate(areas.begin(), areas.end(), 0.0);
}

/// [deformable.md, section 1]: an icosahedron has 1.0984, geodesic spheres of 42 and 162 vertices 1.0241 and
/// 1.0059.
TEST(Surfaces, GeodesicSpheresHaveTheirShapeParameters) {
  for (const auto& [vertices, expected] :
       {std::pair{12, 1.0984}, {42, 1.0241}, {162, 1.0059}, {642, 1.0015}}) {
    const TriangleMesh mesh = geodesic_icosahedron(vertices, 2.5);
    EXPECT_EQ(static_cast<int>(mesh.vertex.size()), vertices);
    EXPECT_EQ(static_cast<int>(mesh.face.size()), 2 * vertices - 4);
    EXPECT_NEAR(enclosed_volume(mesh), 2.5, 1e-14);
    EXPECT_NEAR(surface_shape_parameter(area(mesh), 2.5), expected, 5e-5);
    for (const Vec3& x : mesh.vertex) EXPECT_NEAR(norm(x), norm(mesh.vertex[0]), 1e-15);
  }
}

TEST(Surfaces, OtherNumbersOfVerticesAreRefusedWithTheNearest) {
  for (const auto& [vertices, nearest] : {std::pair{3, "take 12"}, {40, "take 42"}, {60, "take 42"}}) try {
      geodesic_icosahedron(vertices);
      FAIL() << vertices;
    } catch (const Error& e) {
      EXPECT_NE(std::string(e.what()).find(nearest), std::string::npos) << e.what();
    }
}

/// Gauss and Bonnet for polyhedra, and Steiner: a convex body whose hinges turn by theta has the mean
/// curvature sum l theta/2; of a sphere 4 pi R.
TEST(Surfaces, HingesOfASphereTurnAsItsCurvatureSays) {
  const TriangleMesh mesh = geodesic_icosahedron(642);
  const auto hinges = hinges_of(mesh);
  const std::vector<double> angles = hinge_angles(mesh);
  ASSERT_EQ(hinges.size(), 3 * mesh.face.size() / 2);
  double curvature = 0;
  for (std::size_t h = 0; h < hinges.size(); ++h) {
    EXPECT_GT(angles[h], 0);
    curvature += 0.5 * angles[h] * norm(mesh.vertex[hinges[h][1]] - mesh.vertex[hinges[h][0]]);
  }
  EXPECT_NEAR(curvature, 4 * std::numbers::pi * norm(mesh.vertex[0]), 0.003 * curvature);
}

TEST(Surfaces, PreferredAreasFollowTheShapeParameter) {
  System<3> system;
  ShapeSpec spec{.area = 2, .length = 3, .bending = 0.1, .tension = 0.5};
  spec.shape_parameter = 1.2;
  add_surface(system, geodesic_icosahedron(42, 1.7), 1.5, spec);
  const Shape& shape = system.shape;
  const double s0 = std::accumulate(shape.rest_facet.begin(), shape.rest_facet.end(), 0.0);
  EXPECT_NEAR(surface_shape_parameter(s0, shape.rest_volume[0]), 1.2, 1e-13);
  EXPECT_NEAR(shape.stiffness[0].volume, 2 / (1.7 * 1.7), 1e-14);
  EXPECT_NEAR(shape.stiffness[0].facet, 3 * (80 / s0) * (80 / s0), 1e-10);
  EXPECT_NEAR(shape.stiffness[0].tension * s0, 0.5, 1e-14);
  EXPECT_NEAR(system.state.radius[7], 0.75 * mean_edge(geodesic_icosahedron(42, 1.7)), 1e-14);
}

TEST(Surfaces, OpenOrTurnedOverOnesAreRefused) {
  TriangleMesh open = geodesic_icosahedron(12), turned = open, inward = open;
  open.face.pop_back();
  std::swap(turned.face[3][0], turned.face[3][1]);
  for (auto& f : inward.face) std::swap(f[0], f[1]);
  for (const TriangleMesh& mesh : {open, turned, inward}) {
    System<3> system;
    EXPECT_THROW(add_surface(system, mesh, 1, ShapeSpec{}), Error);
    EXPECT_EQ(system.state.size(), 0);
  }
}

}  // namespace
}  // namespace supple
