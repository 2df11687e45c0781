#include "supple/geometry/facet.hpp"

#include <gtest/gtest.h>

#include "supple/core/random.hpp"

namespace supple {
namespace {

/// Against points all over the triangle.
TEST(FacetCoveringRadius, IsTheFarthestThatAPointIsFromTheNearestCorner) {
  RandomStream draw(4, Purpose::test);
  int acute = 0;
  for (int k = 0; k < 300; ++k) {
    Vec3 x[3];
    for (Vec3& p : x) p = {draw.uniform(-1, 1), draw.uniform(-1, 1), draw.uniform(-1, 1)};
    const double radius = facet_covering_radius(x);
    double farthest = 0, longest = 0;
    constexpr int n = 60;
    for (int i = 0; i <= n; ++i)
      for (int j = 0; i + j <= n; ++j) {
        const Vec3 p = x[0] + (1.0 * i / n) * (x[1] - x[0]) + (1.0 * j / n) * (x[2] - x[0]);
        farthest = std::max(farthest, std::min({norm(p - x[0]), norm(p - x[1]), norm(p - x[2])}));
      }
    for (int i = 0; i < 3; ++i) longest = std::max(longest, norm(x[(i + 1) % 3] - x[i]));
    ASSERT_LE(farthest, radius * (1 + 1e-12));
    ASSERT_LE(radius, longest / std::sqrt(3) * (1 + 1e-12));
    ASSERT_GE(radius, 0.5 * longest * (1 - 1e-12));
    if (radius > 0.501 * longest) {
      ASSERT_LT(radius - farthest, 0.03 * longest) << "more than is needed";
      ++acute;
    }
  }
  EXPECT_GT(acute, 50);
}

TEST(FacetCoveringRadius, OfKnownTriangles) {
  const Vec3 even[3] = {{0, 0, 0}, {2, 0, 0}, {1, std::sqrt(3), 0}};
  EXPECT_NEAR(facet_covering_radius(even), 2 / std::sqrt(3), 1e-15);
  const Vec3 right[3] = {{0, 0, 0}, {3, 0, 0}, {0, 0, 4}};
  EXPECT_NEAR(facet_covering_radius(right), 2.5, 1e-15);
  const Vec3 line[3] = {{0, 0, 0}, {3, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(facet_covering_radius(line), 1.5);
  const Vec2 edge[2] = {{1, 1}, {4, 5}};
  EXPECT_EQ(facet_covering_radius(edge), 2.5);
}

}  // namespace
}  // namespace supple
