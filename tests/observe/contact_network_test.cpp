/// Contact numbers and constraints of small systems that can be counted by hand.
#include "supple/observe/rattlers.hpp"

#include <gmock/gmock.h>

#include "supple/contact/rough_contacts.hpp"
#include "supple/contact/smooth_contacts.hpp"
#include "supple/model/rigid.hpp"
#include "tests/support/polygons.hpp"

namespace supple {
namespace {

using ::testing::Contains;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::Lt;

struct Found {
  std::vector<SiteContact<2>> contacts;
  ContactNetwork network;
};

Found find(System<2>& system, std::span<const SiteForce<2>> wall = {}) {
  NeighborList<2>().update(system);
  RoughContacts<2> rough(Harmonic{});
  Found found{site_contacts(system, rough.records(system), rough.laws()), {}};
  found.network = contact_network(system, found.contacts, wall);
  return found;
}

System<2> discs(double length, const std::vector<Vec2>& centres, double radius = 0.5) {
  System<2> system;
  system.box.length = {length, length};
  for (const Vec2& x : centres) add_disc_body(system, x, radius);
  return system;
}

TEST(ContactNetwork, HexagonalDiscsHaveSixNeighboursAndTooManyContacts) {
  const double height = std::sqrt(0.75);
  System<2> system;
  system.box.length = {6, 6 * height};
  for (int row = 0; row < 6; ++row)
    for (int column = 0; column < 6; ++column)
      add_disc_body(system, {column + 0.5 * (row % 2), row * height}, 0.501);
  const Found found = find(system);
  EXPECT_THAT(found.network.contacts_of_bodies(), Each(6));
  EXPECT_THAT(find_rattlers(system, found.contacts), Each(0));
  const ContactNumbers numbers = count_contacts(found.network);
  EXPECT_EQ(numbers.bodies, 36);
  EXPECT_EQ(numbers.pairs, 108);
  EXPECT_EQ(numbers.site_contacts, 108);
  EXPECT_EQ(numbers.mean(), 6);
  const ConstraintCount count = count_constraints(system, found.contacts);
  EXPECT_EQ(count.needed(), 2 * 36 - 1);
  EXPECT_EQ(count.excess(), 108 - 71);
}

TEST(ContactNetwork, BodiesThatAreLeftOutTakeTheirContactsWithThem) {
  System<2> system = discs(10, {{1, 1}, {1.9, 1}, {2.8, 1}, {5, 5}});
  const Found found = find(system);
  EXPECT_THAT(found.network.contacts_of_bodies(), ElementsAre(1, 2, 1, 0));
  const std::vector<std::uint8_t> left_out{1, 0, 0, 1};
  const ContactNumbers all = count_contacts(found.network), rest = count_contacts(found.network, left_out);
  EXPECT_EQ(all.pairs, 2);
  EXPECT_EQ(all.mean(), 1);
  EXPECT_EQ(rest.bodies, 2);
  EXPECT_EQ(rest.pairs, 1);
  EXPECT_EQ(rest.mean(), 1);
  EXPECT_EQ(count_constraints(system, found.contacts, left_out).needed(), 2 * 2 - 1);
  EXPECT_EQ(count_constraints(system, found.contacts, left_out).contacts, 1);
}

TEST(ContactNetwork, BodiesOfManySitesCountOnceAPair) {
  // Squares of side 1 side by side: two pairs of vertices touch.
  System<2> system;
  system.box.length = {10, 10};
  for (int b = 0; b < 2; ++b) {
    const double x = 9.2 + 1.19 * b;  // sticks out of the cell
    add_ring(system, {{x, 3}, {x + 1, 3}, {x + 1, 4}, {x, 4}}, 0.1, {1, 1, 0, 0}, 1, {1, 1, 1, 1},
             {0, 0, 0, 0});
  }
  for (Vec2& x : {std::ref(system.state.position[4]), std::ref(system.state.position[5]),
                  std::ref(system.state.position[6]), std::ref(system.state.position[7])})
    x[0] -= 10;  // another image of the second body
  const Found found = find(system);
  ASSERT_EQ(found.contacts.size(), 2u);
  EXPECT_EQ(found.contacts[0].site, 4);
  EXPECT_EQ(found.contacts[0].other, 1);
  EXPECT_EQ(found.contacts[0].body, 1);
  EXPECT_EQ(found.contacts[0].other_body, 0);
  EXPECT_NEAR(found.contacts[0].force[0], 0.01, 1e-14) << "pushed on by the left one";
  ASSERT_EQ(found.network.pairs.size(), 1u);
  EXPECT_EQ(found.network.pairs[0].site_contacts, 2);
  EXPECT_THAT(found.network.contacts_of_bodies(), ElementsAre(1, 1));
  EXPECT_THAT(find_rattlers(system, found.contacts), ElementsAre(1, 1));
}

/// Two edges that reach over each other, and the corner between them taken back, are one contact; its far
/// site is the one with most of it.
TEST(ContactNetwork, RecordsOfOneSiteAgainstOneBodyAreOneContact) {
  System<2> system;
  system.box.length = {10, 10};
  add_disc_body(system, {5, 5}, 0.5);
  add_ring(system, {{5.9, 5}, {7, 4}, {7, 6}}, 0.5, {}, 1, {1, 1, 1}, {0, 0, 0});
  const auto record = [](const std::vector<std::pair<int, double>>& sides, double multiplicity) {
    ContactRecord<2> r;
    r.add(0, 1);
    for (const auto& [site, weight] : sides) r.add(site, -weight);
    r.normal = {-1, 0};
    r.branch = {-0.9, 0};
    r.reach = 1;
    r.gap = -0.1;
    r.multiplicity = multiplicity;
    r.touch = 0;
    return r;
  };
  const std::vector<ContactRecord<2>> records{record({{1, 0.9}, {2, 0.1}}, 0.5),
                                              record({{3, 0.25}, {1, 0.75}}, 0.5), record({{1, 1}}, -0.25)};
  const auto contacts = site_contacts(system, records, Harmonic{2, false});
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_EQ(contacts[0].site, 0);
  EXPECT_EQ(contacts[0].other, 1);
  EXPECT_EQ(contacts[0].body, 0);
  EXPECT_EQ(contacts[0].other_body, 1);
  EXPECT_NEAR(contacts[0].force[0], -0.15, 1e-15);
  EXPECT_NEAR(contacts[0].normal_force(), 0.15, 1e-15);
}

/// Shifted by a quarter of their side, each of two smooth squares has one corner in front of an edge of the
/// other.
TEST(ContactNetwork, SmoothSquaresTouchWithTwoCorners) {
  System<2> system;
  system.box.length = {10, 10};
  const std::vector<double> four(4, 1);
  for (int b = 0; b < 2; ++b) {
    const double x = 3 + 1.19 * b, y = 5 + 0.25 * b;
    add_ring(system, {{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}, 0.1, {}, 1, four, four);
  }
  NeighborList<2>(default_skin, Meeting::facets).update(system);
  SmoothContacts smooth(Harmonic{});
  const auto contacts = site_contacts(system, smooth.records(system), smooth.laws());
  ASSERT_EQ(contacts.size(), 2u);
  for (const SiteContact<2>& c : contacts) {
    EXPECT_EQ(c.site, c.body == 0 ? 2 : 4);
    EXPECT_EQ(c.other, c.body == 0 ? 7 : 1) << "the nearer end of the edge";
    EXPECT_NEAR(c.force[0], c.body == 0 ? -0.005 : 0.005, 1e-15) << "half of the law";
  }
  ASSERT_EQ(contact_network(system, contacts).pairs.size(), 1u);
}

/// A tip in a notch: two edges, less the corner that both have counted, are one contact as deep as the nearer
/// edge says.
TEST(ContactNetwork, ACornerThatIsTakenBackIsNoOverlap) {
  System<2> system;
  system.box.length = {20, 20};
  const Vec2 at{5, 5};
  const auto add = [&](std::vector<Vec2> ring) {
    for (Vec2& x : ring) x += at;
    const std::vector<double> rest(ring.size(), 1);
    add_ring(system, ring, 0.1, {}, 1, rest, rest);
  };
  add({{-1, -1}, {1, -1}, {1, 1}, {0, 0}, {-1, 1}});
  add({{0, 0.15}, {0.5, 3}, {-0.5, 3}});
  NeighborList<2>(default_skin, Meeting::facets).update(system);
  SmoothContacts smooth(Harmonic{});
  const auto records = smooth.records(system);
  ASSERT_THAT(records, Contains(Field(&ContactRecord<2>::multiplicity, Lt(0))));
  const double tip = 1 - 0.15 / std::sqrt(2) / 0.2, notch = 1 - 0.15 / 0.2;  // the notch also feels the tip
  EXPECT_NEAR(mean_overlap(system, records, smooth.laws()), (tip + notch) / 2, 1e-12);
}

TEST(ContactNetwork, DepthOfContactsOfDiscs) {
  System<2> system = discs(10, {{1, 1}, {1.9, 1}, {5, 5}, {5.7, 5}});
  NeighborList<2>().update(system);
  RoughContacts<2> rough(Harmonic{});
  EXPECT_NEAR(mean_overlap(system, rough.records(system), rough.laws()), 0.2, 1e-12);
  system.state.position[2] = {8, 8};
  system.state.position[1] = {3, 1};
  EXPECT_EQ(mean_overlap(system, rough.records(system), rough.laws()), 0);
}

TEST(ContactNetwork, WallsAreNeighbours) {
  System<2> system = discs(4, {{0.49, 0.49}, {2, 0.49}, {2, 2}});
  system.box.periodic = {false, false};
  Evaluation<2> out;
  out.force.resize(3);
  WallLaw<2> walls;
  walls.floor_friction = 0.5;
  evaluate_walls(system, walls, Detail::forces, out);
  const Found found = find(system, out.wall);
  EXPECT_THAT(found.network.walls, ElementsAre(2, 1, 0));
  EXPECT_THAT(found.network.contacts_of_bodies(), ElementsAre(2, 1, 0));
  EXPECT_EQ(count_contacts(found.network).walls, 3);
  EXPECT_EQ(count_contacts(found.network).mean(), 1);
  const ConstraintCount count = count_constraints(system, found.contacts, {}, out.wall);
  EXPECT_EQ(count.translations, 0);
  EXPECT_EQ(count.needed(), 7);
  EXPECT_EQ(count.contacts, 3);
}

/// N_m = N (n - 1) - 1 - N_vv quartic modes of floppy packings; shells count like rigid bodies.
TEST(ContactNetwork, ConstraintsOfDeformableBodies) {
  testing::PackingDraw draw;
  draw.shape = {1, 1, 0, 0};
  System<2> floppy = testing::random_polygons(draw);
  const Found found = find(floppy);
  const int sites = floppy.state.size(), touching = static_cast<int>(found.contacts.size());
  ASSERT_GT(touching, 9);
  EXPECT_EQ(-count_constraints(floppy, found.contacts).excess(), sites - 9 - 1 - touching);

  draw.shape.bending = 0.1;
  EXPECT_EQ(count_constraints(testing::random_polygons(draw), found.contacts).needed(), 3 * 9 - 1);
  draw.shape = {1, 1, 0, 0.1};
  System<2> rigid = testing::random_polygons(draw);
  EXPECT_EQ(count_constraints(rigid, found.contacts).needed(), 3 * 9 - 1);
  for (int b = 0; b < 9; ++b) make_rigid(rigid, b);
  EXPECT_EQ(count_constraints(rigid, found.contacts).needed(), 3 * 9 - 1);
  rigid.state.mobility[0] = Mobility::fixed;
  EXPECT_EQ(count_constraints(rigid, found.contacts).needed(), 3 * 8 - 1) << "one is held";
  floppy.state.mobility[0] = Mobility::fixed;
  EXPECT_EQ(count_constraints(floppy, found.contacts).freedoms, 2 * sites - 2);
}

}  // namespace
}  // namespace supple
