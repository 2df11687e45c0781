#include <gtest/gtest.h>

#include "supple/contact/neighbor_list.hpp"
#include "supple/geometry/closest_point.hpp"
#include "tests/support/corner_meshes.hpp"

namespace supple {
namespace {

using namespace testing;

/// Wherever a sphere touches a triangle, it has a row with one of its corners: over the middle of an
/// equilateral triangle these are farther away than half an edge.
TEST(RowsOfSurfaces, HoldACornerOfEveryTriangleThatASphereTouches) {
  System<3> system;
  system.box.length = {100, 100, 100};
  system.box.periodic = {false, false, false};
  TriangleMesh mesh{{{0, 0, 0}, {2, 0, 0}, {1, std::sqrt(3), 0}, {1, 1 / std::sqrt(3), 1.8}},
                    {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  add_surface(system, mesh, 0.1, {}, 1, std::vector<double>(4, 1), std::vector<double>(6, 1));
  add_sphere_body(system, {}, 0.1);
  RandomStream draw(3, Purpose::test);
  int touched = 0;
  for (int k = 0; k < 4000; ++k) {
    Vec3 p{draw.uniform(0, 2), draw.uniform(0, 1.8), draw.uniform(-0.3, 1)};
    if (k == 0) p = {1, 1 / std::sqrt(3), -0.1999};
    system.state.position[4] = p;
    NeighborList<3> list(1e-6, Meeting::facets);
    list.update(system);
    for (const auto& facet : system.topology.facet) {
      const Vec3 x[3] = {mesh.vertex[facet[0]], mesh.vertex[facet[1]], mesh.vertex[facet[2]]};
      if (!(norm(closest_on_triangle(p, x).from) < 0.2)) continue;
      ++touched;
      bool found = false;
      for (int row = 0; row < system.pairs.size(); ++row)
        for (const std::int32_t corner : facet) found = found || system.pairs.first[row] == corner;
      ASSERT_TRUE(found) << p[0] << ", " << p[1] << ", " << p[2];
    }
  }
  EXPECT_GT(touched, 1000);
}

}  // namespace
}  // namespace supple
