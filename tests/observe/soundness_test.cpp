/// Particles in each other, across each other and across themselves: small figures, and every pair of edges
/// tried.
#include "supple/observe/soundness.hpp"

#include <gmock/gmock.h>

#include <set>

#include "tests/support/polygons.hpp"
#include "tests/support/sites_inside.hpp"

namespace supple {
namespace {

using ::testing::ElementsAre;

void add(System<2>& system, const std::vector<Vec2>& ring, double radius = 0.1) {
  const std::vector<double> rest(ring.size(), 1);
  add_ring(system, ring, radius, {}, 1, rest, rest);
}

void add_box(System<2>& system, double x, double y, double width, double height) {
  add(system, {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}}, 10);
}

TEST(Soundness, FindsBodiesInsideOthers) {
  System<2> system;
  system.box.length = {20, 20};
  system.box.strain = 0.25;
  add_box(system, 18, 19, 4, 4);           // across both periods: its lower part is 5 to the left
  add_box(system, 16.5, 2.5, 0.25, 0.25);  // in that part
  add_box(system, 12, 8, 1, 1);
  add_disc_body(system, {12.5, 8.5}, 0.1);  // in the one before
  add_box(system, 12.9, 8.95, 3, 0.5);      // overlaps it
  add_box(system, 5, 15, 1, 1);
  const Soundness found = look_at(system, Outline::smooth);
  EXPECT_THAT(found.unsound, ElementsAre(0, 1, 1, 1, 1, 0));
  EXPECT_EQ(found.inside, 4);
  EXPECT_EQ(found.crossing, 2) << "the last two";
  EXPECT_TRUE(found.has_areas());
  for (int k = 4; k < 8; ++k) system.state.position[k] += Vec2{40 - 5, -20};
  EXPECT_EQ(look_at(system, Outline::smooth).inside, 4) << "another copy of the same";
  for (int k = 4; k < 8; ++k) system.state.position[k][0] += 5;
  EXPECT_EQ(look_at(system, Outline::smooth).inside, 3);
  testing::PackingDraw apart;
  apart.spacing = 3.2;
  EXPECT_TRUE(look_at(testing::random_polygons(apart), Outline::smooth).sound());
}

/// A cross of two bars: no vertex of either is inside the other.
TEST(Soundness, FindsBarsThatCross) {
  System<2> system;
  system.box.length = {20, 20};
  add_box(system, 5, 9, 10, 1);
  add_box(system, 9, 5, 1, 10);
  add_box(system, 1, 1, 1, 1);
  const Soundness found = look_at(system, Outline::smooth);
  EXPECT_EQ(found.inside, 0);
  EXPECT_EQ(found.crossing, 2);
  EXPECT_EQ(found.what(), "2 particles cross another one");
  EXPECT_THAT(found.unsound, ElementsAre(1, 1, 0));
}

TEST(Soundness, FindsRingsThatCrossThemselvesOrHaveTurnedOver) {
  System<2> system;
  system.box.length = {40, 40};
  add(system, {{1, 1}, {5, 1}, {1.5, 4}, {5, 5}});    // a bow tie: its edges 1 and 3 cross
  add(system, {{11, 1}, {11, 2}, {12, 2}, {12, 1}});  // clockwise
  add(system, {{21, 1}, {25, 1}, {25, 5}, {21, 5}});
  const Soundness found = look_at(system, Outline::smooth);
  EXPECT_EQ(found.self_crossing, 1);
  EXPECT_EQ(found.turned_over, 1);
  EXPECT_FALSE(found.has_areas());
  EXPECT_THAT(found.unsound, ElementsAre(1, 1, 0));
  EXPECT_EQ(found.what(), "1 particle has turned inside out, 1 crosses itself");
  system.state.position[9][0] = std::nan("");
  EXPECT_EQ(look_at(system, Outline::smooth).not_finite, 1);
}

TEST(Soundness, FindsABodyThatMeetsItsOwnImage) {
  System<2> system;
  system.box.length = {20, 20};
  system.box.strain = 0.1;
  add_box(system, 15, 4, 22, 1);
  const Soundness found = look_at(system, Outline::smooth);
  EXPECT_GE(found.crossing + found.inside, 1);
  EXPECT_EQ(found.bodies(), 1);
  system.box.periodic[0] = false;
  EXPECT_TRUE(look_at(system, Outline::smooth).sound());
}

/// Where a vertex disc fits between those at the ends of an edge, nothing holds others back.
TEST(Soundness, FindsEdgesThatLetVerticesThrough) {
  System<2> system;
  system.box.length = {20, 20};
  add(system, {{1, 1}, {1.3, 1}, {1.15, 1.2}});
  EXPECT_EQ(look_at(system, Outline::rough).open, 0);
  EXPECT_NEAR(look_at(system, Outline::rough).longest_edge, 1.5, 1e-12);
  system.state.position[1][0] = 1.401;
  EXPECT_EQ(look_at(system, Outline::rough).open, 1);
  EXPECT_EQ(look_at(system, Outline::smooth).open, 0) << "smooth edges are no row of discs";
  add_disc_body(system, {5, 5}, 0.05);
  system.state.position[1][0] = 1.301;
  EXPECT_EQ(look_at(system, Outline::rough).open, 1) << "the smallest vertex counts";
}

bool cross_by_parameters(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const double det = cross(b - a, d - c);
  if (det == 0) return false;
  const double s = cross(c - a, d - c) / det, t = cross(c - a, b - a) / det;
  return s > 0 && s < 1 && t > 0 && t < 1;
}

/// All edges of all bodies against all edges of all images, in a sheared cell in which bodies meet many
/// images.
TEST(Soundness, AgreesWithEveryPairOfEdges) {
  int crossing = 0, self_crossing = 0, all = 0;
  for (std::uint64_t seed = 1; seed < 13; ++seed) {
    testing::PackingDraw draw;
    draw.seed = seed;
    draw.bodies = seed % 2 ? 4 : 9;
    draw.spacing = 1.6 + 0.3 * static_cast<double>(seed % 6);
    draw.jitter = 0.02 + 0.2 * static_cast<double>(seed % 4);
    const System<2> s = testing::random_polygons(draw);
    std::set<int> crossed, self;
    const auto& t = s.topology;
    for (int a = 0; a < draw.bodies; ++a)
      for (int b = 0; b < draw.bodies; ++b)
        for (int up = -2; up <= 2; ++up)
          for (int across = -3; across <= 3; ++across) {
            const Vec2 shift{across * s.box.length[0] + up * s.box.strain * s.box.length[1],
                             up * s.box.length[1]};
            for (int f = t.facet_begin[a]; f < t.facet_begin[a + 1]; ++f)
              for (int g = t.facet_begin[b]; g < t.facet_begin[b + 1]; ++g) {
                if (a == b && shift == Vec2{} && f == g) continue;
                const auto x = [&](int facet, int end) { return s.state.position[t.facet[facet][end]]; };
                if (cross_by_parameters(x(f, 0), x(f, 1), x(g, 0) + shift, x(g, 1) + shift))
                  (a == b && shift == Vec2{} ? self : crossed).insert(a);
              }
          }
    const Soundness found = look_at(s, Outline::smooth);
    EXPECT_EQ(found.crossing, static_cast<int>(crossed.size())) << seed;
    EXPECT_EQ(found.self_crossing, static_cast<int>(self.size())) << seed;
    std::set<int> inside;
    for (const testing::SiteInside& i : testing::find_sites_inside(s))
      inside.insert(bodies_of_sites(t, s.state.size())[i.site]);
    EXPECT_GE(found.inside, static_cast<int>(inside.size()))
        << seed << ": that knows no images of a body itself";
    crossing += found.crossing;
    self_crossing += found.self_crossing;
    all += draw.bodies;
  }
  EXPECT_GT(crossing, 10);
  EXPECT_LT(crossing, all - 5);
  EXPECT_GT(self_crossing, 3);
}

TEST(Soundness, OfBodiesFarApartIsThatOfEachAlone) {
  System<2> system;
  system.box.length = {200, 20};
  add_box(system, 5, 5, 4, 4);
  add(system, {{20, 5}, {20, 9}, {24, 9}, {24, 5}});                // turned over
  add(system, {{40, 5}, {46, 5}, {46, 9}, {43, 3}, {40, 9}}, 0.1);  // crosses itself
  add_disc_body(system, {60, 5}, 1);
  add(system, {{80, 5}, {81, 5}, {81, 6}, {80, 6}}, 0.2);  // open, where rough
  add_box(system, 120, 5, 1, 1);
  for (const Outline outline : {Outline::rough, Outline::smooth}) {
    const Soundness all = look_at(system, outline), each = look_at_each(system, outline);
    EXPECT_EQ(each.unsound, all.unsound);
    EXPECT_EQ(each.what(), all.what());
    EXPECT_EQ(each.longest_edge, all.longest_edge);
    EXPECT_EQ(each.turned_over, 1);
    EXPECT_EQ(each.self_crossing, 1);
    EXPECT_EQ(each.open > 0, outline == Outline::rough);
  }
  system.state.position[0][0] = NAN;
  EXPECT_EQ(look_at_each(system, Outline::rough).not_finite, 1);
}

}  // namespace
}  // namespace supple
