#include "supple/geometry/triangles_cross.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "supple/geometry/orientation.hpp"
#include "tests/support/meshes.hpp"

namespace supple {
namespace {

using Triangle = std::array<Vec3, 3>;

/// How two triangles meet, which must not depend on the order of their corners or on which is the first.
TriangleMeeting meet(const Triangle& a, const Triangle& b) {
  static constexpr int order[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  const TriangleMeeting first = meeting_of({a[0], a[1], a[2]}, {b[0], b[1], b[2]});
  for (const auto& i : order)
    for (const auto& j : order) {
      const Vec3 p[3] = {a[i[0]], a[i[1]], a[i[2]]}, q[3] = {b[j[0]], b[j[1]], b[j[2]]};
      EXPECT_EQ(meeting_of(p, q), first);
      EXPECT_EQ(meeting_of(q, p), first);
      EXPECT_EQ(triangles_cross(p, q), first == TriangleMeeting::crossing);
    }
  return first;
}

const Triangle floor_ = {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};

TEST(TrianglesCross, WhereAnEdgeGoesThroughTheOther) {
  EXPECT_EQ(meet(floor_, {{{1, 1, -1}, {1, 1, 1}, {9, 9, 1}}}), TriangleMeeting::crossing);
  EXPECT_EQ(meet(floor_, {{{1, 1, -1}, {1, 1.5, 1}, {1.5, 1, 1}}}), TriangleMeeting::crossing);
  EXPECT_EQ(meet(floor_, {{{1, -9, -9}, {1, 20, 9}, {1, -9, 9}}}), TriangleMeeting::crossing);
}

TEST(TrianglesCross, NotWhereTheyAreApart) {
  EXPECT_EQ(meet(floor_, {{{1, 1, 1}, {1, 2, 1}, {1, 1, 2}}}), TriangleMeeting::none);
  // Through the plane of the other beside it, and so that both reach the line of the planes apart.
  EXPECT_EQ(meet(floor_, {{{5, 5, -1}, {5, 6, 1}, {6, 5, 1}}}), TriangleMeeting::none);
  EXPECT_EQ(meet(floor_, {{{1, 6, -1}, {1, 5, 1}, {1, 7, 1}}}), TriangleMeeting::none);
}

TEST(TrianglesCross, NotWhereTheyTouch) {
  const Triangle touching[] = {
      {{{1, 1, 0}, {1, 2, 1}, {2, 1, 1}}},       // a corner on the face
      {{{1, 1, 0}, {2, 1, 0}, {1, 1, 1}}},       // an edge on the face
      {{{-1, 9, 0}, {9, -1, 0}, {1, 1, 1}}},     // an edge across the face
      {{{0, 0, 0}, {1, 1, 2}, {1, 2, 1}}},       // a common corner
      {{{0, 0, 0}, {9, 9, 1}, {9, 8, 2}}},       // the same, above the other
      {{{0, 0, 0}, {-1, -1, 1}, {-1, -2, -1}}},  // the same, through its plane behind the corner
      {{{0, 0, 0}, {4, 0, 0}, {0, 4, 1}}},       // a common edge
      {{{2, 0, -1}, {2, 0, 1}, {2, -3, 1}}},     // an edge that meets an edge
      {{{4, 0, -1}, {4, 0, 1}, {9, -3, 1}}},     // an edge through a corner
      {{{2, -1, 0}, {2, -1, 2}, {2, 0, 0}}},     // a corner on an edge
  };
  for (const Triangle& t : touching) EXPECT_EQ(meet(floor_, t), TriangleMeeting::none) << &t - touching;
}

TEST(TrianglesCross, BeyondACommonCorner) {
  EXPECT_EQ(meet(floor_, {{{0, 0, 0}, {2, 2, 1}, {2, 2, -1}}}), TriangleMeeting::crossing);
  EXPECT_EQ(meet(floor_, {{{0, 0, 0}, {9, 8, 1}, {9, 8, -1}}}), TriangleMeeting::crossing);
  EXPECT_EQ(meet(floor_, {{{0, 0, 0}, {-2, -2, 1}, {-2, -2, -1}}}), TriangleMeeting::none);
}

/// Two tetrahedra that form a star: each edge meets one of the other in its middle, so that no edge goes
/// through the inside of a face. 12 pairs of faces cross along half an edge.
TEST(TrianglesCross, AlsoWhereOnlyEdgesMeet) {
  const TriangleMesh mesh = testing::tetrahedron();
  int crossings = 0;
  for (const auto& [a, b, c] : mesh.face)
    for (const auto& [d, e, f] : mesh.face) {
      const Triangle p = {mesh.vertex[a], mesh.vertex[b], mesh.vertex[c]};
      const Triangle q = {-mesh.vertex[d], -mesh.vertex[e], -mesh.vertex[f]};
      const TriangleMeeting meeting = meet(p, q);
      EXPECT_NE(meeting, TriangleMeeting::overlap);
      crossings += meeting == TriangleMeeting::crossing;
    }
  EXPECT_EQ(crossings, 12);
}

TEST(TrianglesCross, InOnePlaneTheyOverlapOrNot) {
  for (const double z :
       {0.0, 0.5}) {  // one of a whole multiple of powers of two, so that all are in one plane
    const auto lift = [&](Triangle t) {
      for (Vec3& x : t) x[2] += z * (x[0] + 2 * x[1]);
      return t;
    };
    const auto meet_floor = [&](const Triangle& t) { return meet(lift(floor_), lift(t)); };
    EXPECT_EQ(meet_floor({{{1, 1, 0}, {9, 1, 0}, {1, 9, 0}}}), TriangleMeeting::overlap);
    EXPECT_EQ(meet_floor({{{1, 1, 0}, {1.5, 1, 0}, {1, 1.5, 0}}}), TriangleMeeting::overlap);  // inside
    EXPECT_EQ(meet_floor({{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}), TriangleMeeting::overlap);      // the same
    EXPECT_EQ(meet_floor({{{0, 0, 0}, {4, 0, 0}, {1, 1, 0}}}), TriangleMeeting::overlap);      // folded over
    EXPECT_EQ(meet_floor({{{0, 0, 0}, {9, 8, 0}, {8, 9, 0}}}), TriangleMeeting::overlap);
    EXPECT_EQ(meet_floor({{{-1, 3, 0}, {3, -1, 0}, {3, 3, 0}}}), TriangleMeeting::overlap);
    EXPECT_EQ(meet_floor({{{0, 0, 0}, {4, 0, 0}, {1, -3, 0}}}), TriangleMeeting::none);  // neighbours
    EXPECT_EQ(meet_floor({{{0, 0, 0}, {-4, 0, 0}, {0, -4, 0}}}), TriangleMeeting::none);
    EXPECT_EQ(meet_floor({{{4, 4, 0}, {5, 4, 0}, {4, 5, 0}}}), TriangleMeeting::none);
    EXPECT_EQ(meet_floor({{{2, 2, 0}, {5, 4, 0}, {4, 5, 0}}}), TriangleMeeting::none);  // a corner on an edge
  }
}

TEST(TrianglesCross, ATriangleWithoutAreaMeetsNothing) {
  EXPECT_EQ(meet(floor_, {{{1, 1, -1}, {1, 1, 1}, {1, 1, 3}}}), TriangleMeeting::none);
  EXPECT_EQ(meet(floor_, {{{1, 1, 0}, {1, 2, 0}, {1, 3, 0}}}), TriangleMeeting::none);
  EXPECT_EQ(meet(floor_, {{{1, 1, 0}, {1, 1, 0}, {1, 1, 0}}}), TriangleMeeting::none);
}

/// At random, with none, one or two common corners, at any size and place.
TEST(TrianglesCross, AsEdgesThatPierceTheOther) {
  RandomStream draw(1, Purpose::test);
  int crossings[3] = {};
  for (int trial = 0; trial < 30000; ++trial) {
    const double size = std::pow(10.0, draw.uniform(-20, 20));
    Vec3 shift, p[3], q[3];
    for (int d = 0; d < 3; ++d) shift[d] = size * draw.uniform(-100, 100);
    for (Vec3* x : {p, p + 1, p + 2, q, q + 1, q + 2})
      for (int d = 0; d < 3; ++d) (*x)[d] = shift[d] + size * draw.uniform(-1, 1);
    const int common = trial % 3;
    for (int k = 0; k < common; ++k) q[(trial + k) % 3] = p[(trial / 3 + k) % 3];
    const bool expected = testing::an_edge_pierces(p, q);
    EXPECT_EQ(triangles_cross(p, q), expected) << trial;
    EXPECT_EQ(triangles_cross(q, p), expected) << trial;
    EXPECT_NE(meeting_of(p, q), TriangleMeeting::overlap);
    crossings[common] += expected;
  }
  EXPECT_GT(crossings[0], 1000);
  EXPECT_GT(crossings[1], 500);
  EXPECT_EQ(crossings[2], 0);
}

TEST(Orientation, SignsAreZeroWhereRoundingCouldDecide) {
  EXPECT_EQ(side_of_line({0, 1}, {0, 0}, {1, 0}), 1);
  EXPECT_EQ(side_of_line({0, -1}, {0, 0}, {1, 0}), -1);
  EXPECT_EQ(side_of_plane({0, 0, 1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 1);
  EXPECT_EQ(side_of_plane({0, 0, -1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}), -1);
  RandomStream draw(2, Purpose::test);
  int zeros = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    Vec3 a, b, c;
    for (int d = 0; d < 3; ++d)
      a[d] = draw.uniform(-1, 1), b[d] = draw.uniform(-1, 1), c[d] = draw.uniform(-1, 1);
    EXPECT_EQ(side_of_plane(a, a, b, c), 0);
    EXPECT_EQ(side_of_plane(b, a, b, c), 0);
    EXPECT_EQ(side_of_plane(c, a, b, c), 0);
    // In the plane but for the rounding of its own coordinates, and off it by some more.
    const Vec3 inside = a + 0.3 * (b - a) + 0.4 * (c - a), normal = cross(b - a, c - a);
    zeros += side_of_plane(inside, a, b, c) == 0;
    if (norm(normal) < 0.1) continue;
    EXPECT_EQ(side_of_plane(inside + 1e-13 / norm(normal) * normal, a, b, c), 1);
    EXPECT_EQ(side_of_plane(inside - 1e-13 / norm(normal) * normal, a, b, c), -1);
  }
  EXPECT_GT(zeros, 950);
}

}  // namespace
}  // namespace supple
