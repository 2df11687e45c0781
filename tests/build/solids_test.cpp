#include "supple/build/solids.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "supple/build/surfaces.hpp"
#include "supple/core/error.hpp"
#include "supple/geometry/simplex.hpp"

namespace supple {
namespace {

template <int Dim>
double element_volume(const SolidMesh<Dim>& mesh, std::size_t e) {
  Vec<Dim> x[Dim + 1];
  for (int k = 0; k <= Dim; ++k) x[k] = mesh.node[mesh.element[e][k]];
  return simplex_volume(x);
}

template <int Dim>
double distance(const SolidMesh<Dim>& mesh, const std::array<std::int32_t, 2>& bond) {
  return norm(mesh.node[bond[1]] - mesh.node[bond[0]]);
}

/// Elements are positive, fill the boundary, and meet each other or it at each of their sides; every node is
/// a corner of one, and those on the boundary are its corners.
template <int Dim>
void check_elements(const SolidMesh<Dim>& mesh, double volume) {
  EXPECT_NEAR(boundary_volume(mesh), volume, 1e-12 * volume);
  double sum = 0;
  std::map<std::set<std::int32_t>, int> sides;
  std::set<std::int32_t> nodes, outer;
  for (std::size_t e = 0; e < mesh.element.size(); ++e) {
    const auto& element = mesh.element[e];
    EXPECT_GT(element_volume(mesh, e), 0) << "element " << e;
    sum += element_volume(mesh, e);
    nodes.insert(element.begin(), element.end());
    for (int k = 0; k <= Dim; ++k) {
      std::set<std::int32_t> side(element.begin(), element.end());
      side.erase(element[k]);
      ++sides[side];
    }
  }
  for (const auto& facet : mesh.facet) {
    ++sides[{facet.begin(), facet.end()}];
    outer.insert(facet.begin(), facet.end());
  }
  EXPECT_NEAR(sum, volume, 1e-12 * volume);
  EXPECT_EQ(std::count_if(sides.begin(), sides.end(), [](const auto& side) { return side.second != 2; }), 0);
  EXPECT_EQ(nodes.size(), mesh.node.size());
  EXPECT_EQ(*nodes.begin(), 0);
  EXPECT_EQ(outer.size(), static_cast<std::size_t>(mesh.boundary));
  EXPECT_EQ(*outer.rbegin(), mesh.boundary - 1);
}

/// Smallest angle of all triangles [radian].
double smallest_angle(const SolidMesh<2>& mesh) {
  double least = std::numbers::pi;
  for (const auto& t : mesh.element)
    for (int k = 0; k < 3; ++k) {
      const Vec2 a = mesh.node[t[(k + 1) % 3]] - mesh.node[t[k]],
                 b = mesh.node[t[(k + 2) % 3]] - mesh.node[t[k]];
      least = std::min(least, std::atan2(cross(a, b), dot(a, b)));
    }
  return least;
}

std::string message_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(NetworkDisc, OfElevenHundredNodesIsThePublishedOne) {
  const SolidMesh<2> disc = network_disc(1100, 2.5, 1);
  EXPECT_EQ(disc.node.size(), 1100);
  EXPECT_EQ(disc.boundary, 100);
  EXPECT_EQ(disc.bond.size(), 3197);
  EXPECT_NEAR(coordination(disc), 5.81, 0.005);
}

TEST(NetworkDisc, IsATriangulationOfAPolygonOfThisArea) {
  for (const int nodes : {7, 12, 60, 100, 700})
    for (const std::uint64_t seed : {1, 2, 3}) {
      SCOPED_TRACE(::testing::Message() << nodes << " nodes, seed " << seed);
      const SolidMesh<2> disc = network_disc(nodes, 2.5, seed);
      check_elements(disc, 2.5);
      EXPECT_EQ(disc.node.size(), static_cast<std::size_t>(nodes));
      // Euler: nodes - edges + triangles = 1.
      EXPECT_EQ(nodes - static_cast<int>(disc.bond.size()) + static_cast<int>(disc.element.size()), 1);
      const double radius = norm(disc.node[0]);
      for (int k = 0; k < disc.boundary; ++k) {
        EXPECT_NEAR(norm(disc.node[k]), radius, 1e-12 * radius);
        EXPECT_NEAR(distance(disc, disc.facet[k]), distance(disc, disc.facet[0]), 1e-12 * radius);
        EXPECT_EQ(disc.facet[k], (std::array<std::int32_t, 2>{k, (k + 1) % disc.boundary}));
      }
      EXPECT_GT(smallest_angle(disc), 0.35);  // 20 degrees
    }
}

TEST(NetworkDisc, IsDisordered) {
  const SolidMesh<2> disc = network_disc(1100, 1, 4);
  std::vector<int> bonds(disc.node.size());
  for (const auto& [i, j] : disc.bond) ++bonds[i], ++bonds[j];
  const auto sixfold = std::count(bonds.begin() + disc.boundary, bonds.end(), 6);
  EXPECT_GT(sixfold, 300);
  EXPECT_LT(sixfold, 900);
}

TEST(NetworkBall, OfThePublishedNumberOfNodesHasThePublishedBonds) {
  const SolidMesh<3> ball = network_ball(3765, 2.5, 1);
  EXPECT_EQ(ball.node.size(), 3765);
  EXPECT_EQ(ball.bond.size(), 43334);
  EXPECT_NEAR(coordination(ball), 23.02, 0.005);
  check_elements(ball, 2.5);
}

TEST(NetworkBall, IsAClosedSurfaceFilledEvenly) {
  for (const int nodes : {13, 60, 500}) {
    const double wanted = nodes < 20 ? 10 : 18;
    SCOPED_TRACE(::testing::Message() << nodes << " nodes");
    const SolidMesh<3> ball = network_ball(nodes, 2.5, 7, wanted);
    check_elements(ball, 2.5);
    EXPECT_EQ(ball.facet.size(), static_cast<std::size_t>(2 * ball.boundary - 4));
    EXPECT_EQ(ball.bond.size(), static_cast<std::size_t>(std::lround(0.5 * wanted * nodes)));
    EXPECT_TRUE(std::is_sorted(ball.bond.begin(), ball.bond.end()));
    EXPECT_EQ(std::set(ball.bond.begin(), ball.bond.end()).size(), ball.bond.size());
    const double radius = norm(ball.node[0]), spacing = std::cbrt(2.5 / nodes);
    for (int i = 0; i < nodes; ++i) {
      if (i < ball.boundary) EXPECT_NEAR(norm(ball.node[i]), radius, 1e-12 * radius);
      else EXPECT_LT(norm(ball.node[i]), radius - 0.4 * spacing);
      for (int j = 0; j < i; ++j) EXPECT_GT(norm(ball.node[i] - ball.node[j]), 0.55 * spacing);
    }
    // The edges of the surface are bonds, and of all other pairs those that are nearest.
    std::set<std::array<std::int32_t, 2>> edges;
    for (const auto& f : ball.facet)
      for (int k = 0; k < 3; ++k)
        edges.insert({std::min(f[k], f[(k + 1) % 3]), std::max(f[k], f[(k + 1) % 3])});
    double longest = 0, shortest = 1e9;
    std::size_t at = 0;
    for (std::int32_t i = 0; i < nodes; ++i)
      for (std::int32_t j = i + 1; j < nodes; ++j) {
        const std::array<std::int32_t, 2> pair{i, j};
        const bool bound = at < ball.bond.size() && ball.bond[at] == pair;
        at += bound;
        if (edges.contains(pair)) EXPECT_TRUE(bound);
        else if (bound) longest = std::max(longest, distance(ball, pair));
        else shortest = std::min(shortest, distance(ball, pair));
      }
    EXPECT_LE(longest, shortest);
  }
}

TEST(NetworkBall, HasElementsOfOneSizeOfWhichFewAreFlat) {
  const SolidMesh<3> ball = network_ball(500, 1, 7, 18);
  const auto count = static_cast<double>(ball.element.size());
  double flat = 0, spread = 0;
  for (std::size_t e = 0; e < ball.element.size(); ++e) {
    const double volume = element_volume(ball, e);
    double longest = 0;
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < a; ++b)
        longest = std::max(longest, distance(ball, {ball.element[e][a], ball.element[e][b]}));
    // A regular tetrahedron has the volume longest^3/(6 sqrt 2).
    flat += volume * 6 * std::numbers::sqrt2 < 0.2 * std::pow(longest, 3);
    spread += std::pow(volume * count - 1, 2);
  }
  EXPECT_LT(flat, 0.03 * count);
  EXPECT_LT(std::sqrt(spread / count), 0.3);
}

TEST(Networks, RepeatFromTheirSeedAndDifferFromOthers) {
  const SolidMesh<2> disc = network_disc(100, 1, 5), again = network_disc(100, 1, 5),
                     other = network_disc(100, 1, 6);
  EXPECT_EQ(disc.node, again.node);
  EXPECT_EQ(disc.bond, again.bond);
  EXPECT_NE(disc.bond, other.bond);
  const SolidMesh<3> ball = network_ball(200, 1, 5), same = network_ball(200, 1, 5),
                     another = network_ball(200, 1, 6);
  EXPECT_EQ(ball.node, same.node);
  EXPECT_EQ(ball.bond, same.bond);
  EXPECT_NE(ball.bond, another.bond);
}

TEST(Networks, RefuseWhatCannotBe) {
  using testing::HasSubstr;
  EXPECT_THAT(message_of([] { network_disc(6, 1, 1); }), HasSubstr("take 7 or more"));
  EXPECT_THAT(message_of([] { network_disc(60, 0, 1); }), HasSubstr("positive"));
  EXPECT_THAT(message_of([] { network_ball(12, 1, 1, 8); }), HasSubstr("take 13 or more"));
  EXPECT_THAT(message_of([] { network_ball(60, -1, 1); }), HasSubstr("positive"));
  EXPECT_THAT(message_of([] { network_ball(60, 1, 1, 60); }), HasSubstr("from 6"));
  EXPECT_THAT(message_of([] { network_ball(60, 1, 1, 5); }), HasSubstr("from 6"));
}

std::vector<Vec2> regular_polygon(int n, const Vec2& centre) {
  std::vector<Vec2> ring;
  for (int k = 0; k < n; ++k)
    ring.push_back(centre +
                   Vec2{std::cos(2 * std::numbers::pi * k / n), std::sin(2 * std::numbers::pi * k / n)});
  return ring;
}

TEST(StarMesh, JoinsEveryFacetToTheCentroid) {
  const SolidMesh<2> polygon = star_mesh(regular_polygon(16, {3, -2}));
  check_elements(polygon, 8 * std::sin(std::numbers::pi / 8));
  EXPECT_EQ(polygon.boundary, 16);
  EXPECT_EQ(polygon.element.size(), 16);
  EXPECT_LT(norm(polygon.node.back() - Vec2{3, -2}), 1e-14);
  EXPECT_TRUE(polygon.bond.empty());

  TriangleMesh surface = geodesic_icosahedron(162, 2.5);
  for (Vec3& x : surface.vertex) x += Vec3{5, 6, 7};
  const SolidMesh<3> ball = star_mesh(surface);
  check_elements(ball, 2.5);
  EXPECT_EQ(ball.boundary, 162);
  EXPECT_EQ(ball.element.size(), 2 * 162 - 4);
  EXPECT_LT(norm(ball.node.back() - Vec3{5, 6, 7}), 1e-13);
}

TEST(StarMesh, TakesTheCentroidOfWhatIsEnclosedNotOfTheVertices) {
  const std::vector<Vec2> kite{{0, 0}, {1, -1}, {5, 0}, {1, 1}};
  EXPECT_LT(norm(star_mesh(kite).node.back() - Vec2{2, 0}), 1e-14);
  TriangleMesh tent{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 4}, {0.5, 0.5, 0}},
                    {{0, 4, 1}, {0, 2, 4}, {0, 1, 3}, {0, 3, 2}, {1, 4, 3}, {4, 2, 3}}};
  EXPECT_LT(norm(star_mesh(tent).node.back() - Vec3{0.25, 0.25, 1}), 1e-14);
}

TEST(StarMesh, RefusesShapesThatTheCentroidDoesNotSee) {
  using testing::HasSubstr;
  const std::vector<Vec2> angle{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}};
  EXPECT_THAT(message_of([&] { star_mesh(angle); }),
              testing::AllOf(HasSubstr("edge 2, from vertex 2 to vertex 3"), HasSubstr("star-shaped")));
  std::vector<Vec2> twice = regular_polygon(5, {});
  twice = {twice[0], twice[2], twice[4], twice[1], twice[3]};
  EXPECT_THAT(message_of([&] { star_mesh(twice); }), HasSubstr("more than once"));
  std::vector<Vec2> clockwise = regular_polygon(5, {});
  std::reverse(clockwise.begin(), clockwise.end());
  EXPECT_THAT(message_of([&] { star_mesh(clockwise); }), HasSubstr("counter-clockwise"));
  EXPECT_THAT(message_of([&] { star_mesh(std::vector<Vec2>{{0, 0}, {1, 0}}); }), HasSubstr("2 vertices"));
  EXPECT_THAT(message_of([&] {
                star_mesh(std::vector<Vec2>{{0, 0}, {1, 0}, {NAN, 1}});
              }),
              HasSubstr("vertex 2"));

  TriangleMesh dented = geodesic_icosahedron(42, 1);
  dented.vertex[20] = -0.7 * dented.vertex[20];
  EXPECT_THAT(message_of([&] { star_mesh(dented); }),
              testing::ContainsRegex("triangle [0-9]+, from vertices"));
  TriangleMesh open = geodesic_icosahedron(42, 1);
  open.face.pop_back();
  EXPECT_THAT(message_of([&] { star_mesh(open); }), HasSubstr("the surface of an elastic solid"));
}

TEST(AffineModulus, OfThreeDirectionsIsThatOfTheTriangularLattice) {
  // A regular hexagon of springs: every bond within it belongs to it whole, those of its edge by half.
  SolidMesh<2> hexagon = star_mesh(regular_polygon(6, {}));
  for (int i = 0; i < 6; ++i) hexagon.bond.push_back({i, 6});
  for (int i = 0; i < 3; ++i) hexagon.bond.push_back({i, i + 1});
  EXPECT_NEAR(affine_modulus(hexagon, 3.0), 3 * 2 / std::sqrt(3), 1e-14);
}

}  // namespace
}  // namespace supple
