/// Surfaces in each other, across each other and across themselves: small figures, and every pair of
/// triangles tried.
#include <gmock/gmock.h>

#include <set>

#include "supple/geometry/facet.hpp"
#include "supple/geometry/inside.hpp"
#include "supple/geometry/line_chord.hpp"
#include "supple/geometry/star_surface.hpp"
#include "supple/geometry/surface_crossings.hpp"
#include "supple/observe/soundness.hpp"
#include "tests/support/surfaces.hpp"

namespace supple {
namespace {

using namespace testing;
using ::testing::ElementsAre;

System<3> empty_cell(double length) {
  System<3> system;
  system.box.length = {length, length, length};
  return system;
}

TEST(SurfaceSoundness, FindsBodiesInsideOthers) {
  System<3> system = empty_cell(20);
  system.box.strain = 0.25;
  add_mesh(system, box_mesh({4, 4, 4}), 10, {18, 19, 18});  // across all periods: up there 5 to the left
  add_mesh(system, box_mesh({0.2, 0.2, 0.2}), 10, {16.5, 1.5, 1});  // in that part
  add_mesh(system, box_mesh({1, 1, 1}), 10, {12, 8, 5});
  add_sphere_body(system, {12.5, 8.4, 5.6}, 0.1);                   // in the one before
  add_mesh(system, box_mesh({3, 0.5, 0.5}), 10, {12.9, 8.9, 5.8});  // overlaps it
  add_mesh(system, box_mesh({1, 1, 1}), 10, {5, 15, 3});
  add_mesh(system, box_mesh({0.6, 0.3, 0.3}), 10, {11.7, 8.2, 5.2});  // overlaps it from the other side
  const Soundness found = look_at(system, Outline::smooth);
  EXPECT_THAT(found.unsound, ElementsAre(0, 1, 1, 1, 1, 0, 1));
  EXPECT_EQ(found.inside, 5);
  EXPECT_EQ(found.crossing, 3);
  EXPECT_TRUE(found.has_areas());
  RandomStream draw(5, Purpose::test);
  for (int k = 0; k < 60; ++k) {  // pairs lie across the periods in all ways
    const Vec3 by{draw.uniform(-40, 40), draw.uniform(-40, 40), draw.uniform(-40, 40)};
    System<3> moved = system;
    for (Vec3& x : moved.state.position) x += by;
    EXPECT_EQ(look_at(moved, Outline::smooth).unsound, found.unsound);
    EXPECT_EQ(look_at(moved, Outline::smooth).what(), found.what());
  }
  for (int k = 8; k < 16; ++k) system.state.position[k] += Vec3{40 - 5, -20, 60};
  EXPECT_EQ(look_at(system, Outline::smooth).inside, 5) << "another copy of the same";
  for (int k = 8; k < 16; ++k) system.state.position[k][0] += 5;
  EXPECT_EQ(look_at(system, Outline::smooth).inside, 4);
}

/// A cross of two bars: no vertex of either is inside the other.
TEST(SurfaceSoundness, FindsBarsThatCrossAndSpheresInEachOther) {
  System<3> system = empty_cell(20);
  add_mesh(system, box_mesh({10, 1, 1}), 0.1, {5, 9, 9});
  add_mesh(system, box_mesh({0.6, 10, 0.6}), 0.1, {9, 5, 9.2});
  add_sphere_body(system, {1, 1, 1}, 1);
  add_sphere_body(system, {1.2, 21.1, 0.9}, 0.5);
  add_sphere_body(system, {4, 1, 1}, 2.5);  // overlaps the first
  const Soundness found = look_at(system, Outline::smooth);
  EXPECT_EQ(found.crossing, 2);
  EXPECT_THAT(found.unsound, ElementsAre(1, 1, 0, 1, 0));
  EXPECT_EQ(found.what(), "1 particle is inside another one, or a vertex of it is, 2 cross another one");
}

TEST(SurfaceSoundness, FindsSurfacesThatCrossThemselvesOrHaveTurnedOver) {
  System<3> system = empty_cell(30);
  TriangleMesh pushed = geodesic_icosahedron(42, 4.0);
  pushed.vertex[5] = -1.4 * pushed.vertex[5];  // through the other side
  TriangleMesh inward = box_mesh({1, 2, 3});
  add_mesh(system, pushed, 0.1, {5, 5, 5});
  add_mesh(system, inward, 0.1, {15, 5, 5});
  add_mesh(system, dented_sphere(162, 0.9, 0.9), 0.1, {5, 15, 5});
  for (int f = system.topology.facet_begin[1]; f < system.topology.facet_begin[2]; ++f)
    std::swap(system.topology.facet[f][0], system.topology.facet[f][1]);
  for (const Outline outline : {Outline::smooth, Outline::rough}) {
    const Soundness found = look_at(system, outline);
    EXPECT_EQ(found.self_crossing, 1);
    EXPECT_EQ(found.turned_over, 1);
    EXPECT_FALSE(found.has_areas());
    EXPECT_EQ(found.crossing + found.inside, 0);
    EXPECT_THAT(found.unsound, ElementsAre(1, 1, outline == Outline::rough));
    const Soundness each = look_at_each(system, outline);
    EXPECT_EQ(each.unsound, found.unsound);
    EXPECT_EQ(each.what(), found.what());
    EXPECT_EQ(each.longest_edge, found.longest_edge);
  }
  system.state.position[50][2] = NAN;
  EXPECT_THAT(look_at(system, Outline::smooth).unsound, ElementsAre(0, 0, 1));
  EXPECT_EQ(look_at_each(system, Outline::smooth).not_finite, 1);
}

TEST(SurfaceSoundness, FindsABodyThatMeetsItsOwnImage) {
  System<3> system = empty_cell(20);
  system.box.strain = 0.1;
  add_mesh(system, box_mesh({1, 1, 22}), 0.1, {15, 4, 3});
  const Soundness found = look_at(system, Outline::smooth);
  EXPECT_GE(found.crossing + found.inside, 1);
  EXPECT_EQ(found.bodies(), 1);
  system.box.periodic[2] = false;
  EXPECT_TRUE(look_at(system, Outline::smooth).sound());
}

/// Vertices of one radius pass through the middle of an equilateral triangle whose edges are longer than
/// sqrt(3) of their diameter, between two of them from 2 diameters on: the middle is wider.
TEST(SurfaceSoundness, FindsTrianglesThatLetVerticesThrough) {
  System<3> system = empty_cell(20);
  const TriangleMesh mesh = geodesic_icosahedron(12, 1);
  const double edge = mean_edge(mesh), limit = edge / (2 * std::sqrt(3));
  add_mesh(system, mesh, 1.001 * limit, {5, 5, 5});
  EXPECT_EQ(look_at(system, Outline::rough).open, 0);
  EXPECT_NEAR(look_at(system, Outline::rough).longest_edge, std::sqrt(3) / 1.001, 1e-12);
  EXPECT_EQ(look_at(system, Outline::rough).uncovered, 1)
      << "edges pass each other from sqrt(2) diameters on";
  EXPECT_TRUE(look_at(system, Outline::rough).sound());
  for (double& r : system.state.radius) r = 0.999 * limit;
  EXPECT_EQ(look_at(system, Outline::rough).open, 1);
  EXPECT_EQ(look_at(system, Outline::smooth).open, 0) << "smooth triangles are no row of spheres";
  for (double& r : system.state.radius) r = 1.2 * limit;
  add_sphere_body(system, {15, 15, 15}, 0.85 * limit);
  EXPECT_EQ(look_at(system, Outline::rough).open, 0);
  system.state.radius[12] = 0.75 * limit;
  EXPECT_EQ(look_at(system, Outline::rough).open, 1) << "the smallest vertex counts";
  for (double& r : system.state.radius) r = 0.51 * edge / std::sqrt(2.0);
  EXPECT_EQ(look_at(system, Outline::rough).uncovered, 0);
}

/// Points of random triangles, some of them obtuse, against spheres of unequal radii.
TEST(SpheresCover, AsPointsOfTheTriangleSay) {
  RandomStream draw(7, Purpose::test);
  int covered = 0, holes_inside = 0;
  for (int k = 0; k < 600; ++k) {
    Vec3 x[3];
    double radius[3];
    for (int c = 0; c < 3; ++c) {
      for (int d = 0; d < 3; ++d) x[c][d] = draw.uniform(-1, 1);
      radius[c] = draw.uniform(0.2, k % 2 ? 0.9 : 1.3);
    }
    double worst = -1;  // how far a point is out of all spheres
    bool inner = true;
    constexpr int n = 60;
    for (int i = 0; i <= n; ++i)
      for (int j = 0; i + j <= n; ++j) {
        const Vec3 p = x[0] + (1.0 * i / n) * (x[1] - x[0]) + (1.0 * j / n) * (x[2] - x[0]);
        double out = 10;
        for (int c = 0; c < 3; ++c) out = std::min(out, norm(p - x[c]) - radius[c]);
        if (out > 0 && (i == 0 || j == 0 || i + j == n)) inner = false;
        worst = std::max(worst, out);
      }
    if (worst > 0 || worst < -0.04) {
      EXPECT_EQ(spheres_cover(x, radius), worst < 0) << worst;
    }
    covered += worst < -0.04;
    holes_inside += worst > 0 && inner;
  }
  EXPECT_GT(covered, 50);
  EXPECT_LT(covered, 500);
  EXPECT_GT(holes_inside, 3);
}

TEST(SurfaceSeenFrom, ProvesNothingButWhatIsTrue) {
  const TriangleMesh sphere = geodesic_icosahedron(42), star = star_mesh(42, 0.4, 3);
  EXPECT_TRUE(is_seen_from({0.1, 0, 0}, sphere.vertex, sphere.face));
  EXPECT_TRUE(is_seen_from({}, star.vertex, star.face));
  EXPECT_FALSE(is_seen_from({3, 0, 0}, sphere.vertex, sphere.face));
  const TriangleMesh pit = dented_sphere(162, 1.2, 0.9);
  EXPECT_FALSE(is_seen_from({}, pit.vertex, pit.face));
  const TriangleMesh twice = joined(sphere, star);  // each seen, but two of them
  EXPECT_FALSE(is_seen_from({}, twice.vertex, twice.face));
}

TEST(WindingAlongZ, IsThatOfSolidAngles) {
  RandomStream draw(2, Purpose::test);
  int inside = 0;
  for (const TriangleMesh& mesh : {star_mesh(42, 0.6, 1), dented_sphere(162, 0.8, 0.9), ell_mesh(),
                                   joined(geodesic_icosahedron(42), star_mesh(12, 0.3, 2))})
    for (int k = 0; k < 1000; ++k) {
      const Vec3 p{draw.uniform(-1, 3), draw.uniform(-1, 3), draw.uniform(-1, 3)};
      const int expected = winding_number(p, mesh.vertex, mesh.face);
      ASSERT_EQ(winding_along_z(p, mesh.vertex, mesh.face), expected);
      inside += expected;
    }
  EXPECT_GT(inside, 500);
}

/// All triangles of all bodies against all triangles of all images, in sheared cells in which bodies meet
/// many images.
TEST(SurfaceSoundness, AgreesWithEveryPairOfTriangles) {
  int crossing = 0, inside = 0, all = 0;
  for (std::uint64_t seed = 1; seed < 9; ++seed) {
    System<3> s = random_surfaces(seed % 2 ? 3 : 6, 2.5 + 0.7 * static_cast<double>(seed), seed);
    s.box.strain = 0.2 * static_cast<double>(seed);
    s.box.periodic[2] = seed % 3 != 0;
    const std::vector<BodySurface> shapes = lay_out_bodies(s);
    const auto n = static_cast<int>(shapes.size());
    std::set<int> crossed, within;
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b)
        for (int cell = 0; cell < 5 * 7 * 3; ++cell) {
          const Vec3 cells{cell / 15 - 3.0, cell / 3 % 5 - 2.0, s.box.periodic[2] ? cell % 3 - 1.0 : 0.0};
          const Vec3 shift = s.box.lattice().vector(cells);
          if ((a == b && shift == Vec3{}) || !shapes[a].bounds.meets(shapes[b].bounds.shifted(shift)))
            continue;
          std::vector<Vec3> moved = shapes[b].vertex;
          for (Vec3& x : moved) x += shift;
          for (const Vec3& x : moved)
            if (is_inside(x, shapes[a].vertex, shapes[a].face)) within.insert(b);
          if (shapes[a].is_sphere() && shapes[b].is_sphere() &&
              norm(moved[0] - shapes[a].vertex[0]) < shapes[a].radius[0] - shapes[b].radius[0])
            within.insert(b);
          for (const auto& [i, j, meeting] :
               crossings_between({shapes[a].vertex, shapes[a].face}, {moved, shapes[b].face}))
            if (meeting == TriangleMeeting::crossing) crossed.insert(b);
        }
    const Soundness found = look_at(s, Outline::smooth);
    EXPECT_EQ(found.crossing, static_cast<int>(crossed.size())) << seed;
    EXPECT_EQ(found.inside, static_cast<int>(within.size())) << seed;
    EXPECT_EQ(found.self_crossing, 0);
    crossing += found.crossing;
    inside += found.inside;
    all += n;
  }
  EXPECT_GT(crossing, 10);
  EXPECT_LT(crossing, all - 5);
  EXPECT_GT(inside, 5);
}

}  // namespace
}  // namespace supple
