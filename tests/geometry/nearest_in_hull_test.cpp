#include "supple/geometry/nearest_in_hull.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "supple/core/random.hpp"

namespace supple {
namespace {

using Points = std::vector<Vec3>;

TEST(NearestInHull, ClosedForms) {
  EXPECT_TRUE(std::isinf(distance_to_hull(std::vector<Vec3>{})));
  EXPECT_NEAR(distance_to_hull(Points{{3, 4, 12}}), 13, 1e-12);
  EXPECT_NEAR(distance_to_hull(Points{{1, -2, 0}, {1, 5, 0}}), 1, 1e-12) << "within a segment";
  EXPECT_NEAR(distance_to_hull(Points{{1, 2, 0}, {1, 5, 0}}), std::sqrt(5), 1e-12) << "at its end";
  EXPECT_NEAR(distance_to_hull(Points{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}), 1 / std::sqrt(3), 1e-12);
  EXPECT_EQ(distance_to_hull(Points{{1, 0, 0}, {-2, 0, 0}}), 0) << "two opposite ones hold it between them";
  EXPECT_EQ(distance_to_hull(Points{{1, 1, 1}, {-1, 1, 1}, {0, -1, 1}, {0, 0, -1}}), 0) << "in a tetrahedron";
  EXPECT_NEAR(distance_to_hull(Points{{1, 1, 1}, {-1, 1, 1}, {0, -1, 1}, {0, 0, 1}}), 1, 1e-12)
      << "below its base";
  EXPECT_NEAR(distance_to_hull(Points{{2, 0, 0}, {2, 0, 0}, {2, 0, 0}}), 2, 1e-12)
      << "one point, three times";
}

/// A simplex about the origin holds it; without one of its corners the face opposite to that is nearest.
TEST(NearestInHull, InSixDimensions) {
  std::vector<Vec<6>> simplex;
  for (int d = 0; d < 6; ++d) {
    Vec<6> e{};
    e[d] = 1;
    simplex.push_back(e);
  }
  EXPECT_NEAR(distance_to_hull(simplex), 1 / std::sqrt(6), 1e-12);
  Vec<6> opposite;
  for (int d = 0; d < 6; ++d) opposite[d] = -0.1;
  simplex.push_back(opposite);
  EXPECT_EQ(distance_to_hull(simplex), 0);
  simplex.erase(simplex.begin());
  EXPECT_NEAR(distance_to_hull(simplex), 1 / std::sqrt(230), 1e-12) << "the plane -15 x_0 + x_1 + ... = 1";
}

/// The distance is the largest over all directions q of the least q.p: the planes that part the hull from the
/// origin.
TEST(NearestInHull, IsTheBestPlaneOfManyDirections) {
  Points directions;
  const int rings = 120;
  for (int i = 0; i < rings; ++i)
    for (int k = 0; k < 2 * rings; ++k) {
      const double theta = std::numbers::pi * (i + 0.5) / rings, phi = std::numbers::pi * k / rings;
      directions.push_back(
          {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)});
    }
  int outside = 0;
  for (int set = 0; set < 60; ++set) {
    RandomStream draw(5, Purpose::test, static_cast<std::uint64_t>(set));
    Points points(static_cast<std::size_t>(2 + set % 8));
    for (Vec3& p : points)
      for (int d = 0; d < 3; ++d) p[d] = draw.uniform(-1, 1) + (d == 0 ? 0.5 : 0);
    double best = 0;
    for (const Vec3& q : directions) {
      double least = 1e9;
      for (const Vec3& p : points) least = std::min(least, dot(q, p));
      best = std::max(best, least);
    }
    EXPECT_NEAR(distance_to_hull(points), best, 0.03) << set;
    EXPECT_GE(distance_to_hull(points), best - 1e-12) << set;
    outside += best > 0;
  }
  EXPECT_GT(outside, 15);
  EXPECT_LT(outside, 55);
}

}  // namespace
}  // namespace supple
