/// Contacts in cells of any size against the same bodies with all their images in the open.
#include "tests/support/all_images.hpp"

#include <gtest/gtest.h>

#include "supple/contact/detect_discs.hpp"
#include "supple/contact/disc_contacts.hpp"
#include "supple/contact/neighbor_list.hpp"
#include "supple/contact/rough_contacts.hpp"
#include "supple/contact/smooth_contacts.hpp"
#include "supple/core/error.hpp"
#include "supple/core/random.hpp"
#include "supple/model/polygons.hpp"

namespace supple {
namespace {

using testing::with_all_images;

constexpr double strains[] = {0, 0.31, 0.5, -1.7, 7.23};

/// Discs of radius `radius` in a cell of that size, at random, any number of cells away.
System<2> discs_anywhere(int n, double radius, const Vec2& length, double strain, std::uint64_t seed) {
  System<2> system;
  system.box.length = length;
  system.box.strain = strain;
  system.box.strain_rate = 0.4;
  system.state.resize(n);
  for (int i = 0; i < n; ++i) {
    RandomStream draw(seed, Purpose::test, static_cast<std::uint64_t>(i));
    State<2>& s = system.state;
    s.position[i] = {draw.uniform(-3, 4) * length[0], draw.uniform(-3, 4) * length[1]};
    s.velocity[i] = {draw.uniform(-1, 1), draw.uniform(-1, 1)};
    s.spin[i] = draw.uniform(-1, 1);
    s.radius[i] = radius * draw.uniform(0.7, 1);
    s.mass[i] = s.inertia[i] = 1;
  }
  return system;
}

/// Small polygons and discs, each anywhere.
System<2> bodies_anywhere(int bodies, const Vec2& length, double strain, std::uint64_t seed) {
  System<2> system;
  system.box.length = length;
  system.box.strain = strain;
  system.topology.begin = system.topology.facet_begin = system.topology.hinge_begin = {0};
  for (int b = 0; b < bodies; ++b) {
    RandomStream draw(seed, Purpose::test, static_cast<std::uint64_t>(b));
    const Vec2 centre{draw.uniform(-3, 4) * length[0], draw.uniform(-3, 4) * length[1]};
    if (b % 3 == 2) add_disc_body(system, centre, draw.uniform(0.2, 0.3));
    else add_polygon(system, centre, draw.uniform(1.8, 2.6), 6 + b % 3, draw.uniform(0, 6), 0.6, ShapeSpec{});
  }
  return system;
}

void start(const System<2>& system, Evaluation<2>& out) {
  out = {};
  out.force.assign(static_cast<std::size_t>(system.state.size()), Vec2{});
  out.torque.assign(static_cast<std::size_t>(system.state.size()), 0.0);
}

/// Forces and torques of the first sites are the same; returns the largest force.
double expect_same_forces(const Evaluation<2>& got, const Evaluation<2>& right, const std::string& where) {
  double largest = 0;
  for (std::size_t i = 0; i < got.force.size(); ++i) {
    const double scale = 1 + norm(right.force[i]);
    EXPECT_LT(norm(got.force[i] - right.force[i]), 1e-10 * scale) << where << ", site " << i;
    EXPECT_NEAR(got.torque[i], right.torque[i], 1e-10 * scale) << where << ", site " << i;
    largest = std::max(largest, norm(right.force[i]));
  }
  return largest;
}

Evaluation<2> disc_forces(System<2>& system) {
  const PairStiffness stiff{20, 0.3, 15, 0.2};
  DiscContacts contacts(Divergent(1), {stiff, stiff, Tensile{}, 0.3, Slip::clamp, LeverArm::distance});
  Evaluation<2> out;
  start(system, out);
  contacts.evaluate(system, 1e-2, Detail::forces, out);
  return out;
}

std::string name(const System<2>& system) {
  return "cell " + std::to_string(system.box.length[0]) + " x " + std::to_string(system.box.length[1]) +
         ", strain " + std::to_string(system.box.strain);
}

TEST(AllImages, DiscsInCellsOfTwoToSixDiameters) {
  double largest = 0;
  for (const double width : {4.0, 4.12, 4.36, 4.8, 6.0, 12.0})
    for (const double strain : strains)
      for (const double height : {4.0, 4.5, 12.0}) {
        System<2> system = discs_anywhere(7, 1, {width, height}, strain, 5);
        NeighborList<2> list;
        list.update(system);
        System<2> open = with_all_images(system);
        largest = std::max(largest, expect_same_forces(disc_forces(system), disc_forces(open), name(system)));
      }
  EXPECT_GT(largest, 1);
}

/// The law on records, and records against the open system: counts, distances and normals.
TEST(AllImages, RecordsOfDiscs) {
  for (const double width : {4.0, 4.3, 7.0})
    for (const double strain : strains) {
      System<2> system = discs_anywhere(6, 1, {width, 4.1}, strain, 8);
      NeighborList<2> list;
      list.update(system);
      const System<2> open = with_all_images(system);
      std::vector<std::pair<double, double>> got, right;
      for (const auto& r : detect_discs(system)) got.emplace_back(r.gap, std::abs(r.normal[0]));
      for (const auto& r : detect_discs(open)) {
        // Pairs of which both are images stand for a pair of the first ones; those of one are counted from
        // both ends.
        const bool first = r.site[0] < system.state.size(), second = r.site[1] < system.state.size();
        if (first) right.emplace_back(r.gap, std::abs(r.normal[0]));
        if (first && second) right.emplace_back(r.gap, std::abs(r.normal[0]));
      }
      got.insert(got.end(), got.begin(), got.end());
      ASSERT_EQ(got.size(), right.size()) << name(system);
      std::sort(got.begin(), got.end());
      std::sort(right.begin(), right.end());
      for (std::size_t k = 0; k < got.size(); ++k) {
        EXPECT_NEAR(got[k].first, right[k].first, 1e-12);
        EXPECT_NEAR(got[k].second, right[k].second, 1e-7);
      }
    }
}

template <class Contacts>
void expect_all_images_of_bodies(const Vec2& length) {
  double largest = 0;
  for (const double strain : strains)
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      System<2> system = bodies_anywhere(5, length, strain, seed);
      Contacts contacts(Harmonic{3, false});
      NeighborList<2> list(default_skin, contacts.meeting());
      list.update(system);
      System<2> open = with_all_images(system, 1);
      Contacts in_the_open(Harmonic{3, false});
      Evaluation<2> got, records, right;
      start(system, got);
      start(system, records);
      start(open, right);
      contacts.evaluate(system, Detail::forces, got);
      in_the_open.evaluate(open, Detail::forces, right);
      largest = std::max(largest, expect_same_forces(got, right, name(system)));
      evaluate_conservative(contacts.records(system), contacts.laws(), records);
      expect_same_forces(records, right, name(system) + ", records");
    }
  EXPECT_GT(largest, 0.1);
}

TEST(AllImages, RoughBodiesThatBarelyFit) { expect_all_images_of_bodies<RoughContacts<2>>({2.8, 2.8}); }
TEST(AllImages, RoughBodiesInAFlatCell) { expect_all_images_of_bodies<RoughContacts<2>>({7, 2.8}); }
TEST(AllImages, SmoothBodiesThatBarelyFit) { expect_all_images_of_bodies<SmoothContacts>({3.4, 3.4}); }
TEST(AllImages, SmoothBodiesInAFlatCell) { expect_all_images_of_bodies<SmoothContacts>({7, 3.4}); }

/// Rows live on while discs move: their images must not.
template <class Contacts>
void expect_all_images_on_the_way(System<2> system) {
  Contacts contacts(Harmonic{3, false});
  NeighborList<2> list(default_skin, contacts.meeting());
  double largest = 0;
  for (int step = 0; step < 300; ++step) {
    for (int i = 0; i < system.state.size(); ++i) system.state.position[i] += 0.05 * system.state.velocity[i];
    system.box.strain += 0.003;
    list.update(system);
    System<2> open = with_all_images(system, 1);
    Contacts in_the_open(Harmonic{3, false});
    Evaluation<2> got, right;
    start(system, got);
    start(open, right);
    contacts.evaluate(system, Detail::forces, got);
    in_the_open.evaluate(open, Detail::forces, right);
    largest = std::max(largest, expect_same_forces(got, right, "step " + std::to_string(step)));
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_LT(list.builds(), 200);  // rows did live on
  EXPECT_GT(largest, 0.1);
}

System<2> moving_discs(double width) {
  System<2> system = discs_anywhere(4, 1, {width, width}, 0, 3);
  system.box.strain_rate = 0;
  system.topology.begin = {0, 1, 2, 3, 4};
  return system;
}

TEST(AllImages, RoughDiscsThatMoveInASmallCell) {
  for (const double width : {4.01, 4.12, 4.36, 4.9})
    expect_all_images_on_the_way<RoughContacts<2>>(moving_discs(width));
}
TEST(AllImages, SmoothDiscsThatMoveInASmallCell) {
  for (const double width : {4.01, 4.12, 4.36, 4.9})
    expect_all_images_on_the_way<SmoothContacts>(moving_discs(width));
}
TEST(AllImages, SmoothBodiesThatMoveInASmallCell) {
  System<2> system = bodies_anywhere(4, {3.4, 3.4}, 0.2, 2);
  for (int b = 0; b < 4; ++b) {
    RandomStream draw(9, Purpose::test, static_cast<std::uint64_t>(b));
    const Vec2 v{draw.uniform(-0.3, 0.3), draw.uniform(-0.3, 0.3)};
    for (int i = system.topology.begin[b]; i < system.topology.begin[b + 1]; ++i)
      system.state.velocity[i] = v;
  }
  expect_all_images_on_the_way<SmoothContacts>(system);
}

/// The same periodic state, every second disc one cell away.
TEST(AllImages, PositionsOutsideTheCellMakeTheSameForces) {
  System<2> inside = discs_anywhere(200, 1, {30, 25}, 0.4, 4), outside = inside;
  for (int i = 0; i < 200; ++i) {
    inside.box.wrap(inside.state.position[i], inside.state.velocity[i]);
    outside.state.position[i] = inside.state.position[i];
    outside.state.velocity[i] = inside.state.velocity[i];
    if (i % 2) outside.state.position[i][0] -= 30;
  }
  for (System<2>* system : {&inside, &outside}) NeighborList<2>().update(*system);
  EXPECT_EQ(detect_discs(inside).size(), detect_discs(outside).size());
  EXPECT_GT(expect_same_forces(disc_forces(outside), disc_forces(inside), "moved by a cell"), 1);
}

std::string complaint_of(System<2> system) {
  try {
    NeighborList<2>().update(system);
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::input);
    return e.what();
  }
  return "";
}

TEST(AllImages, CellsInWhichANeighbourIsMetOnTwoSidesAreRefused) {
  for (const Vec2& length : {Vec2{3.9, 12}, Vec2{12, 3.9}, Vec2{2, 2}}) {
    System<2> system = discs_anywhere(4, 1, length, 0, 1);
    for (double& r : system.state.radius) r = 1;
    EXPECT_THAT(complaint_of(system), ::testing::HasSubstr("a neighbour on two sides")) << name(system);
    system.box.periodic = {false, false};  // walls have no images
    EXPECT_EQ(complaint_of(system), "");
  }
  System<2> flat = discs_anywhere(4, 1, {12, 3}, 0, 1);
  for (double& r : flat.state.radius) r = 1;
  EXPECT_THAT(complaint_of(flat), ::testing::HasSubstr("the period of the cell along y is 0.75 of the least"))
      << "a length would need its unit";
  EXPECT_THAT(complaint_of(flat), ::testing::HasSubstr("; take a larger cell"));
  flat.box.length[gradient] = 3.999;
  EXPECT_THAT(complaint_of(flat), ::testing::HasSubstr("is shorter than the least, by 0.00025 of it"));
  System<2> alone = discs_anywhere(1, 1, {2.1, 2.1}, 0, 1);
  EXPECT_EQ(complaint_of(alone), "");  // a single disc has no neighbour
  alone.box.length = {1.3, 2.1};
  alone.state.radius[0] = 1;
  EXPECT_THAT(complaint_of(alone), ::testing::HasSubstr("meets itself"));
}

TEST(AllImages, ACellThatShrinksTooFarIsRefusedDuringARun) {
  System<2> system = discs_anywhere(4, 1, {12, 4.05}, 0, 1);
  for (double& r : system.state.radius) r = 1;
  NeighborList<2> list;
  list.update(system);
  system.box.length[1] = 3.99;  // the list would hold on
  try {
    list.update(system);
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::input);
  }
}

}  // namespace
}  // namespace supple
