/// Which particles bear load: closed forms, and every motion of a grid tried.
#include "supple/observe/rattlers.hpp"

#include <gmock/gmock.h>

#include <numbers>

#include "supple/contact/rough_contacts.hpp"
#include "supple/contact/smooth_contacts.hpp"
#include "supple/model/bodies.hpp"
#include "supple/model/rigid.hpp"
#include "tests/support/polygons.hpp"

namespace supple {
namespace {

using std::numbers::pi;
using ::testing::Each;
using ::testing::ElementsAre;

std::vector<SiteContact<2>> touching(System<2>& system, BodyContacts<2>&& contacts) {
  NeighborList<2>(default_skin, contacts.meeting()).update(system);
  return site_contacts(system, contacts.records(system), contacts.laws());
}

std::vector<std::uint8_t> rattlers(System<2>& system, const OutsideForces<2>& outside = {}) {
  return find_rattlers(system, touching(system, RoughContacts<2>(Harmonic{})), outside);
}

System<2> discs(double length, const std::vector<Vec2>& centres, const std::vector<double>& radius) {
  System<2> system;
  system.box.length = {length, length};
  for (std::size_t k = 0; k < centres.size(); ++k) add_disc_body(system, centres[k], radius[k]);
  return system;
}

/// A disc at 10, 10 with fixed ones at these angles that touch it.
std::uint8_t middle_rattles(const std::vector<double>& degrees) {
  std::vector<Vec2> centres{{10, 10}};
  for (const double a : degrees)
    centres.push_back(Vec2{10, 10} + 1.9 * Vec2{std::cos(a * pi / 180), std::sin(a * pi / 180)});
  System<2> system = discs(20, centres, std::vector<double>(centres.size(), 1));
  for (std::size_t k = 1; k < centres.size(); ++k) system.state.mobility[k] = Mobility::fixed;
  return rattlers(system)[0];
}

TEST(Rattlers, ADiscIsHeldByContactsThatSurroundIt) {
  EXPECT_EQ(middle_rattles({}), 1);
  EXPECT_EQ(middle_rattles({0}), 1);
  EXPECT_EQ(middle_rattles({0, 178}), 1);
  EXPECT_EQ(middle_rattles({0, 180}), 0) << "squeezed by two opposite contacts, which bear load";
  EXPECT_EQ(middle_rattles({0, 121, 239}), 0);
  EXPECT_EQ(middle_rattles({0, 89, 178}), 1) << "three on one side let it out";
  EXPECT_EQ(middle_rattles({0, 61, 122, 183}), 0);
}

TEST(Rattlers, TakeOthersWithThem) {
  // Discs of a square lattice hold each other. In one of its holes a small disc touches a lattice disc, and a
  // smaller one touches that from the other side, squeezing it; nothing holds the smaller one.
  std::vector<Vec2> centres;
  for (int k = 0; k < 9; ++k) centres.push_back({2.0 * (k % 3) + 1, 2.0 * (k / 3) + 1});
  std::vector<double> radius(9, 1.001);
  const Vec2 diagonal{std::sqrt(0.5), std::sqrt(0.5)};
  centres.push_back(centres[0] + 1.2 * diagonal);
  centres.push_back(centres[0] + 1.49 * diagonal);
  radius.insert(radius.end(), {0.2, 0.1});
  System<2> system = discs(6, centres, radius);
  EXPECT_THAT(rattlers(system), ElementsAre(0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1));
  system.state.mobility[10] = Mobility::fixed;
  EXPECT_EQ(rattlers(system)[9], 0) << "once it stands still, it holds the other one";
}

/// A tetrad of discs flies apart: three contacts each, all from one side but for the one in the middle.
TEST(Rattlers, ManyContactsFromOneSideHoldNothing) {
  const double around = 2 / std::sqrt(3.);
  std::vector<Vec2> centres{{10, 10}};
  for (int k = 0; k < 3; ++k)
    centres.push_back(Vec2{10, 10} +
                      0.999 * around * Vec2{std::cos(2 * pi * k / 3), std::sin(2 * pi * k / 3)});
  System<2> system = discs(20, centres, {around - 1, 1, 1, 1});
  EXPECT_THAT(rattlers(system), Each(1));
}

/// Smooth particles: a square between two tips that press on the middles of opposite edges, and beside them.
TEST(Rattlers, ASquareBetweenTwoTips) {
  const auto held = [](double upper_tip_at) {
    System<2> system;
    system.box.length = {40, 40};
    const auto add = [&](const std::vector<Vec2>& ring) {
      const std::vector<double> rest(ring.size(), 1);
      add_ring(system, ring, 0.1, {}, 1, rest, rest);
    };
    add({{19, 19}, {21, 19}, {21, 21}, {19, 21}});
    add({{20, 18.85}, {19, 15}, {21, 15}});
    add({{20 + upper_tip_at, 21.15}, {21 + upper_tip_at, 25}, {19 + upper_tip_at, 25}});
    for (int k = 4; k < 10; ++k) system.state.mobility[k] = Mobility::fixed;
    return find_rattlers(system, touching(system, SmoothContacts(Harmonic{})))[0] == 0;
  };
  EXPECT_TRUE(held(0)) << "two opposite contacts that bear load";
  EXPECT_FALSE(held(0.5)) << "their torques turn it out of both";
  EXPECT_FALSE(held(-0.02));
}

TEST(Rattlers, TeethHoldRigidAndDeformableRingsAlike) {
  // A hexagon of vertices between two walls of four vertices each, two by two: six contacts, no rotation
  // left.
  for (const bool rigid : {false, true}) {
    System<2> system;
    system.box.length = {40, 40};
    add_polygon(system, {20, 20}, 3, 6, pi / 6, 1, {});
    const double r = 2 * system.state.radius[0], across = norm(system.state.position[0] - Vec2{20, 20});
    for (const double side : {-1.0, 1.0})
      for (const double along : {-0.6, 0.6})
        add_disc_body(system, Vec2{20 + along * r, 20 + side * (across + 0.7 * r)}, 0.5 * r);
    for (int k = 6; k < 10; ++k) system.state.mobility[k] = Mobility::fixed;
    if (rigid) make_rigid(system, 0);
    EXPECT_EQ(rattlers(system)[0], 0) << rigid;
    move_body(system, 4, {0, r});
    move_body(system, 3, {0, r});
    place_sites(system);
    EXPECT_EQ(rattlers(system)[0], 1) << "one side only";
  }
}

TEST(Rattlers, WallsAndWeightHold) {
  System<2> system = discs(4, {{1, 0.45}, {3, 2}, {2, 3}}, {0.5, 0.5, 0.5});
  system.box.periodic = {false, false};
  const std::vector<SiteForce<2>> floor{{0, {0, 0.1}}}, both{{0, {0, 0.1}}, {0, {0, -0.1}}};
  EXPECT_THAT(rattlers(system, {floor}), Each(1)) << "nothing keeps it on the floor";
  EXPECT_THAT(rattlers(system, {both}), ElementsAre(0, 1, 1)) << "squeezed between floor and lid";
  EXPECT_THAT(rattlers(system, {floor, {0, -1}}), ElementsAre(0, 1, 1)) << "its weight; the others fall";
}

/// Two bodies that hold each other through the cell and through its period have two neighbours each.
TEST(Rattlers, NeighboursThroughThePeriodCountTwice) {
  System<2> system = discs(4, {{1, 1}, {2.95, 1}}, {1, 1});
  system.box.strain = 0.3;
  system.box.length = {4, 8};  // a shorter one is refused, as the neighbour list knows one image of a pair
  const std::vector<SiteContact<2>> contacts = touching(system, RoughContacts<2>(Harmonic{}));
  ASSERT_EQ(contacts.size(), 1u);
  SiteContact<2> other = contacts[0];
  other.force = -other.force;
  other.shift += Vec2{other.body == 0 ? -4.0 : 4.0, 0};
  const std::vector<SiteContact<2>> both{contacts[0], other};
  const ContactNetwork network = contact_network(system, both);
  ASSERT_EQ(network.pairs.size(), 2u);
  EXPECT_THAT(network.contacts_of_bodies(), Each(2));
  EXPECT_THAT(find_rattlers(system, both), Each(0));
}

/// The definition: every motion of a fine grid is tried on random polygons with their neighbours held.
TEST(Rattlers, AreThoseWithAMotionThatOpensAllContacts) {
  int held = 0, free = 0;
  for (std::uint64_t seed = 1; seed < 9; ++seed) {
    testing::PackingDraw draw;
    draw.seed = seed;
    draw.spacing = 2.5;
    System<2> system = testing::random_polygons(draw);
    const auto contacts = touching(system, RoughContacts<2>(Harmonic{}));
    for (int b = 0; b < 9; ++b) {
      const Vec2 centre = body_centre(system, b);
      double best = -1;
      for (int i = 0; i < 60; ++i)
        for (int k = 0; k < 120; ++k) {
          const double theta = pi * (i + 0.5) / 60, phi = pi * k / 60;
          const Vec2 move = std::sin(theta) * Vec2{std::cos(phi), std::sin(phi)};
          const double turn = std::cos(theta) / outer_radius(system, b);
          double least = 1;
          for (const SiteContact<2>& c : contacts) {
            if (c.body != b && c.other_body != b) continue;
            const Vec2 at = system.state.position[c.site] - (c.body == b ? Vec2{} : c.shift);
            const Vec2 push = (c.body == b ? 1 : -1) / norm(c.force) * c.force;
            least = std::min(least, dot(push, move + cross(turn, at - centre)));
          }
          best = std::max(best, least);
        }
      if (best > -0.03 && best < 0.03) continue;  // the grid does not tell
      const System<2> now = system;
      for (int i = 0; i < system.state.size(); ++i)
        if (i < now.topology.begin[b] || i >= now.topology.begin[b + 1])
          system.state.mobility[i] = Mobility::fixed;
      EXPECT_EQ(find_rattlers(system, contacts)[b], best > 0) << seed << ' ' << b << ' ' << best;
      system = now;
      (best > 0 ? free : held) += 1;
    }
  }
  EXPECT_GT(held, 8);
  EXPECT_GT(free, 8);
}

}  // namespace
}  // namespace supple
