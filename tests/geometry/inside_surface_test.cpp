#include <gtest/gtest.h>

#include "supple/geometry/inside.hpp"
#include "tests/support/corner_meshes.hpp"

namespace supple {
namespace {

using namespace testing;

double whole_angle(const Vec3& p, const TriangleMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.face) {
    const Vec3 x[3] = {mesh.vertex[a], mesh.vertex[b], mesh.vertex[c]};
    sum += solid_angle(p, x);
  }
  return sum;
}

TEST(WindingNumber, OfAnLShapedBeamIsThatOfItsCrossSection) {
  const std::vector<Vec2> ring{{2, 2}, {0, 2}, {0, 0}, {4, 0}, {4, 4}, {2.3, 4}};
  const TriangleMesh mesh = prism_mesh(ring, 3);
  RandomStream draw(3, Purpose::test);
  int inside = 0;
  for (int k = 0; k < 5000; ++k) {
    const Vec3 p{draw.uniform(-1, 5), draw.uniform(-1, 5), draw.uniform(-1, 4)};
    const bool expected = is_inside(Vec2{p[0], p[1]}, ring) && 0 < p[2] && p[2] < 3;
    ASSERT_EQ(winding_number(p, mesh.vertex, mesh.face), expected);
    ASSERT_NEAR(whole_angle(p, mesh), expected ? 4 * std::numbers::pi : 0, 1e-9);
    inside += expected;
  }
  EXPECT_GT(inside, 500);
  EXPECT_LT(inside, 4500);
}

TEST(WindingNumber, IsMinusOneWhereTrianglesLookInward) {
  TriangleMesh mesh = geodesic_icosahedron(42);
  EXPECT_TRUE(is_inside(Vec3{0.1, 0, 0.2}, mesh.vertex, mesh.face));
  EXPECT_FALSE(is_inside(Vec3{0.1, 0, 1.2}, mesh.vertex, mesh.face));
  for (auto& face : mesh.face) std::swap(face[0], face[1]);
  EXPECT_EQ(winding_number(Vec3{0.1, 0, 0.2}, mesh.vertex, mesh.face), -1);
}

/// A corner of a cube is seen under an eighth of all directions from the cube's centre.
TEST(SolidAngle, OfASideOfACubeFromItsCentre) {
  const Vec3 x[3] = {{1, 1, 1}, {-1, 1, 1}, {-1, -1, 1}};
  EXPECT_NEAR(solid_angle({0, 0, 0}, x), 4 * std::numbers::pi / 12, 1e-14);
  EXPECT_NEAR(solid_angle({0, 0, 2}, x), -4 * std::numbers::pi / 12, 1e-14);
}

/// The meshes of the tests are closed and look outward.
TEST(Meshes, EncloseWhatTheyShould) {
  EXPECT_NEAR(enclosed_volume(box_mesh({2, 3, 4})), 24, 1e-13);
  EXPECT_NEAR(enclosed_volume(ell_mesh()), 3 * (8 + 0.5 * 2 * (2 + 1.7)), 1e-13);
  for (const TriangleMesh& mesh : {box_mesh({2, 3, 4}), ell_mesh(), dented_sphere(162, 0.7, 0.9),
                                   star_mesh(42, 0.4, 3), saddle_mesh(2, 0.8), saddle_mesh(3, 0.8)}) {
    EXPECT_GT(enclosed_volume(mesh), 1);
    EXPECT_EQ(2 * hinges_of(mesh).size(), 3 * mesh.face.size());
  }
}

}  // namespace
}  // namespace supple
