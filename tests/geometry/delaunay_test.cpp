#include "supple/geometry/delaunay.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "supple/core/error.hpp"
#include "supple/core/random.hpp"
#include "supple/geometry/simplex.hpp"

namespace supple {
namespace {

template <int Dim>
std::vector<Vec<Dim>> random_points(int n, std::uint64_t seed) {
  RandomStream draw(seed, Purpose::test);
  std::vector<Vec<Dim>> points(static_cast<std::size_t>(n));
  for (auto& x : points)
    for (int d = 0; d < Dim; ++d) x[d] = draw.uniform(-1, 1);
  return points;
}

/// The points of a lattice of this many along each axis, of which many lie on one circle or sphere.
template <int Dim>
std::vector<Vec<Dim>> lattice(int side) {
  std::vector<Vec<Dim>> points;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j)
      for (int k = 0; k < (Dim == 3 ? side : 1); ++k) {
        Vec<Dim> x;
        x[0] = i;
        x[1] = j;
        if constexpr (Dim == 3) x[2] = k;
        points.push_back(x);
      }
  return points;
}

template <int Dim>
double volume(const std::vector<Vec<Dim>>& points, const std::array<std::int32_t, Dim + 1>& simplex) {
  Vec<Dim> x[Dim + 1];
  for (int k = 0; k <= Dim; ++k) x[k] = points[simplex[k]];
  return simplex_volume(x);
}

template <int Dim>
double enclosed_volume(const std::vector<Vec<Dim>>& points, const DelaunayMesh<Dim>& mesh) {
  double sum = 0;
  for (const auto& facet : mesh.hull) {
    Vec<Dim> x[Dim];
    for (int k = 0; k < Dim; ++k) x[k] = points[facet[k]];
    sum += facet_volume(x);
  }
  return sum;
}

/// Centre of the sphere through the corners: 2 (y_k . c) = y_k^2.
template <int Dim>
Vec<Dim> circumcentre(const std::vector<Vec<Dim>>& points, const std::array<std::int32_t, Dim + 1>& simplex) {
  Vec<Dim> x[Dim + 1];
  for (int k = 0; k <= Dim; ++k) x[k] = points[simplex[k]];
  const auto edges = simplex_edges(x);
  const Mat<Dim> inverse = inverse_of_edges(edges);
  Vec<Dim> c = x[Dim];
  for (int k = 0; k < Dim; ++k)
    for (int d = 0; d < Dim; ++d) c[d] += 0.5 * dot(edges.y[k], edges.y[k]) * inverse[k][d];
  return c;
}

/// Positive simplices that fill the hull, which looks outward; each facet belongs to two of them, or to one
/// and the hull; no point lies within a sphere.
template <int Dim>
void check(const std::vector<Vec<Dim>>& points, double expected_volume) {
  const DelaunayMesh<Dim> mesh = delaunay<Dim>(points);
  double sum = 0;
  std::map<std::set<std::int32_t>, int> sides;
  std::set<std::int32_t> used;
  for (const auto& simplex : mesh.simplex) {
    EXPECT_GT(volume(points, simplex), 0);
    sum += volume(points, simplex);
    used.insert(simplex.begin(), simplex.end());
    for (int k = 0; k <= Dim; ++k) {
      std::set<std::int32_t> facet(simplex.begin(), simplex.end());
      facet.erase(simplex[k]);
      ++sides[facet];
    }
  }
  for (const auto& facet : mesh.hull) ++sides[{facet.begin(), facet.end()}];
  for (const auto& [facet, count] : sides) EXPECT_EQ(count, 2);
  EXPECT_EQ(used.size(), points.size());
  EXPECT_NEAR(sum, expected_volume, 1e-12 * expected_volume);
  EXPECT_NEAR(enclosed_volume(points, mesh), expected_volume, 1e-12 * expected_volume);
  int inside = 0;
  for (const auto& simplex : mesh.simplex) {
    const Vec<Dim> centre = circumcentre(points, simplex);
    const double radius = norm(points[simplex[0]] - centre);
    for (const auto& x : points) inside += norm(x - centre) < radius * (1 - 1e-5);
  }
  EXPECT_EQ(inside, 0);
}

TEST(Delaunay, FillsTheHullOfRandomPointsWithEmptySpheres) {
  for (const std::uint64_t seed : {1, 2, 3, 4, 5})
    for (const int n : {3, 4, 5, 30, 300}) {
      SCOPED_TRACE(::testing::Message() << n << " points, seed " << seed);
      const auto plane = random_points<2>(n, seed);
      check<2>(plane, enclosed_volume(plane, delaunay<2>(plane)));
      if (n == 3) continue;
      const auto space = random_points<3>(n, seed);
      check<3>(space, enclosed_volume(space, delaunay<3>(space)));
    }
}

TEST(Delaunay, TakesManyPointsOnOneSphereOrInOnePlane) {
  check<2>(lattice<2>(9), 64);
  check<3>(lattice<3>(5), 64);
}

TEST(Delaunay, RefusesWhatFillsNothing) {
  const auto message = [](auto points) -> std::string {
    try {
      delaunay<std::extent_v<decltype(points.front().e)>>(points);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(message(std::vector<Vec2>{}), testing::HasSubstr("0 points"));
  EXPECT_THAT(message(std::vector<Vec2>{{0, 0}, {1, 1}, {2, 2}, {5, 5}}), testing::HasSubstr("on one line"));
  EXPECT_THAT(message(std::vector<Vec3>{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {3, 4, 1}, {2, 2, 1}}),
              testing::HasSubstr("in one plane"));
  EXPECT_THAT(message(std::vector<Vec2>{{0, 0}, {1, 0}, {0, 1}, {1, 1}, {1, 0}}),
              testing::HasSubstr("1 and 4 are the same"));
  EXPECT_THAT(message(std::vector<Vec2>{{0, 0}, {1, 0}, {0, NAN}}),
              testing::HasSubstr("2 has the coordinate nan"));
}

}  // namespace
}  // namespace supple
