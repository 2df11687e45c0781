#include "supple/geometry/surface_crossings.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "supple/geometry/box_tree.hpp"
#include "tests/support/meshes.hpp"

namespace supple {
namespace {

using Pairs = std::vector<std::pair<std::int32_t, std::int32_t>>;

/// Boxes of very different sizes, some of them points, with a coordinate that many share.
std::vector<Extent> random_boxes(int n, int seed) {
  RandomStream draw(seed, Purpose::test);
  std::vector<Extent> boxes;
  for (int k = 0; k < n; ++k) {
    Vec3 low, high;
    const double size = k % 7 ? std::pow(10.0, draw.uniform(-4, -0.3)) : 0;
    for (int d = 0; d < 3; ++d) {
      low[d] = d == seed % 3 ? 0.5 : draw.uniform();
      high[d] = low[d] + size * draw.uniform();
    }
    boxes.push_back({low, high});
  }
  return boxes;
}

TEST(BoxTree, FindsThePairsThatAllPairsFind) {
  for (int n : {0, 1, 2, 4, 5, 9, 100, 400}) {
    const auto boxes = random_boxes(n, n), others = random_boxes(n / 2 + 1, n + 1);
    Pairs within, between, expected_within, expected_between;
    for (int i = 0; i < n; ++i) {
      for (int j = i + 1; j < n; ++j)
        if (boxes[i].overlaps(boxes[j])) expected_within.emplace_back(i, j);
      for (int j = 0; j < static_cast<int>(others.size()); ++j)
        if (boxes[i].overlaps(others[j])) expected_between.emplace_back(i, j);
    }
    const BoxTree tree(boxes);
    tree.for_pairs([&](int i, int j) { within.emplace_back(i, j); });
    tree.for_pairs_with(BoxTree(others), [&](int i, int j) { between.emplace_back(i, j); });
    std::sort(within.begin(), within.end());
    std::sort(between.begin(), between.end());
    EXPECT_EQ(within, expected_within);
    EXPECT_EQ(between, expected_between);
    if (n == 400) {
      EXPECT_GT(within.size(), 300u);
      EXPECT_GT(between.size(), 100u);
    }
  }
}

TEST(BoxTree, BoxesThatTouchOverlap) {
  int pairs = 0;
  BoxTree({{{0, 0, 0}, {1, 1, 1}}, {{1, 1, 1}, {2, 2, 2}}, {{2.5, 1, 1}, {3, 2, 2}}})
      .for_pairs([&](int i, int j) { pairs += 10 * i + j; });
  EXPECT_EQ(pairs, 1);
}

Pairs crossings(const std::vector<MeetingTriangles>& found) {
  Pairs pairs;
  for (const MeetingTriangles& m : found) {
    EXPECT_EQ(m.meeting, TriangleMeeting::crossing);
    pairs.emplace_back(m.first, m.second);
  }
  return pairs;
}

/// The same by looking at every pair.
Pairs all_pairs(const TriangleMesh& a, const TriangleMesh& b, bool same) {
  Pairs pairs;
  const auto gather = [](const TriangleMesh& mesh, std::size_t f, Vec3(&x)[3]) {
    for (std::size_t k = 0; k < 3; ++k) x[k] = mesh.vertex[mesh.face[f][k]];
  };
  for (std::size_t i = 0; i < a.face.size(); ++i)
    for (std::size_t j = same ? i + 1 : 0; j < b.face.size(); ++j) {
      Vec3 p[3], q[3];
      gather(a, i, p);
      gather(b, j, q);
      if (testing::an_edge_pierces(p, q)) pairs.emplace_back(i, j);
    }
  return pairs;
}

/// A sphere that is shaken more and more: nothing crosses at first, and from the first crossing on the same
/// triangles do as of all pairs.
TEST(SurfaceCrossings, OfAShakenSphereAreThoseOfAllPairs) {
  for (const auto& [vertices, seeds] : {std::pair{42, 12}, {162, 2}})
    for (int seed = 1; seed <= seeds; ++seed) {
      const TriangleMesh sphere = geodesic_icosahedron(vertices);
      const std::vector<Vec3> moves = testing::random_moves(sphere.vertex.size(), seed);
      const double edge = mean_edge(sphere);
      int sound = 0, crossed = 0;
      for (double size = 0; crossed < 4; size += 0.1 * edge) {
        TriangleMesh mesh = sphere;
        for (std::size_t v = 0; v < moves.size(); ++v) mesh.vertex[v] += size * moves[v];
        const Pairs expected = all_pairs(mesh, mesh, true);
        ASSERT_EQ(crossings(self_crossings({mesh.vertex, mesh.face})), expected) << seed << " " << size;
        ++(expected.empty() ? sound : crossed);
      }
      EXPECT_GT(sound, 2) << seed;
    }
}

TEST(SurfaceCrossings, OfTwoSurfacesAreThoseOfAllPairs) {
  const TriangleMesh star = testing::star(), ring = testing::torus(20, 9);
  for (int seed = 1; seed < 8; ++seed) {
    TriangleMesh moved = ring;
    const Vec3 shift = testing::random_moves(1, seed)[0];
    for (Vec3& x : moved.vertex) x += shift;
    const Pairs expected = all_pairs(star, moved, false);
    EXPECT_EQ(crossings(crossings_between({star.vertex, star.face}, {moved.vertex, moved.face})), expected);
    EXPECT_FALSE(expected.empty()) << seed;
  }
}

TEST(SurfaceCrossings, NothingWhereOneIsInsideTheOtherOrTheyAreApart) {
  const TriangleMesh large = geodesic_icosahedron(42, 8), small = geodesic_icosahedron(42, 1);
  EXPECT_TRUE(crossings_between({large.vertex, large.face}, {small.vertex, small.face}).empty());
  TriangleMesh away = small;
  for (Vec3& x : away.vertex) x[1] += 9;
  EXPECT_TRUE(crossings_between({away.vertex, away.face}, {small.vertex, small.face}).empty());
}

}  // namespace
}  // namespace supple
