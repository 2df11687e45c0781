/// The force between two bodies along and across the line of their centres, and where they begin to touch.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "supple/contact/rough_contacts.hpp"
#include "supple/contact/smooth_contacts.hpp"
#include "supple/core/random.hpp"
#include "supple/force/force_field.hpp"
#include "supple/model/bodies.hpp"
#include "supple/model/polygons.hpp"
#include "supple/observe/pair_friction.hpp"

namespace supple {
namespace {

constexpr double radius = 0.2;

std::vector<Vec2> random_ring(RandomStream& draw, int n) {
  std::vector<Vec2> ring;
  for (int k = 0; k < n; ++k) {
    const double angle = 2 * std::numbers::pi * (k + 0.3 * draw.uniform()) / n, r = draw.uniform(0.7, 1.2);
    ring.push_back(r * Vec2{std::cos(angle), std::sin(angle)});
  }
  return ring;
}

struct Pair {
  System<2> system;
  std::unique_ptr<ForceField<2>> field;

  Pair(const std::vector<Vec2>& below, const std::vector<Vec2>& above, Outline outline) {
    system.box.length = {20, 20};
    system.box.periodic = {false, false};
    for (const auto* ring : {&below, &above}) {
      std::vector<Vec2> at;
      for (const Vec2& x : *ring) at.push_back(x + Vec2{10, 10});
      const std::vector<double> rest(at.size(), 1);
      add_ring(system, at, radius, {}, 1, rest, rest);
    }
    field = outline == Outline::smooth ? std::make_unique<ForceField<2>>(SmoothContacts(Harmonic{1}))
                                       : std::make_unique<ForceField<2>>(RoughContacts<2>(Harmonic{1}));
  }
  MutualForce force(int on, int by) {
    Evaluation<2> out;
    field->invalidate();
    field->evaluate(system, Detail::energies, out);
    energy = out.energy.elastic;
    total = {};
    for (int i = system.topology.body_begin(on); i < system.topology.body_end(on); ++i) total += out.force[i];
    return force_on(system, site_contacts(system, field->bodies()->records(system), field->bodies()->laws()),
                    on, by);
  }
  double energy = 0;
  Vec2 total{};  ///< on the body, as the engine has it
};

class FirstTouch : public ::testing::TestWithParam<Outline> {};

/// Just above it nothing is in contact, just below it something is: as the engine sees it.
TEST_P(FirstTouch, IsWhereContactsBegin) {
  RandomStream draw(3, Purpose::test);
  for (int turn = 0; turn < 40; ++turn) {
    const std::vector<Vec2> below = random_ring(draw, 5 + turn % 4);
    std::vector<Vec2> above = random_ring(draw, 4 + turn % 5);
    for (Vec2& x : above) x[0] += draw.uniform(-0.8, 0.8);
    const auto touch = first_touch({below, radius}, {above, radius}, GetParam());
    ASSERT_TRUE(touch);
    Pair pair(below, above, GetParam());
    move_body(pair.system, 1, {0, *touch + 1e-7});
    pair.force(1, 0);
    EXPECT_EQ(pair.energy, 0) << turn;
    move_body(pair.system, 1, {0, -2e-7});
    pair.force(1, 0);
    EXPECT_GT(pair.energy, 0) << turn;
  }
}

/// The force is that of the engine, and its parts along and across the line of centres are as the chapter
/// has them: n from the other body, t a quarter of a turn to the left of n.
TEST_P(FirstTouch, ForcesHaveTheirParts) {
  RandomStream draw(4, Purpose::test);
  const std::vector<Vec2> below = random_ring(draw, 7), above = random_ring(draw, 6);
  Pair pair(below, above, GetParam());
  move_body(pair.system, 1, {0, *first_touch({below, radius}, {above, radius}, GetParam()) - 0.15});
  const MutualForce up = pair.force(1, 0);
  EXPECT_GT(up.contacts, 0);
  EXPECT_LT(norm(up.force - pair.total), 1e-12);
  const Vec2 n = up.normal, t{-n[1], n[0]};
  EXPECT_GT(n[1], 0.5);
  EXPECT_NEAR(cross(n, t), 1, 1e-12);
  EXPECT_LT(norm(up.normal_force() * n + up.tangential_force() * t - up.force), 1e-12);
  EXPECT_NEAR(up.friction(), dot(up.force, t) / dot(up.force, n), 1e-12);
  const MutualForce down = pair.force(0, 1);
  EXPECT_LT(norm(up.force + down.force), 1e-12);
  EXPECT_NEAR(up.friction(), down.friction(), 1e-12);  // both axes turn round
}

INSTANTIATE_TEST_SUITE_P(Outlines, FirstTouch, ::testing::Values(Outline::rough, Outline::smooth),
                         [](const auto& one) {
                           return std::string(one.param == Outline::rough ? "rough" : "smooth");
                         });

TEST(FirstTouch, IsNowhereWhereVerticesPass) {
  const std::vector<Vec2> below{{-1, 0}, {-0.9, -1}, {0.9, -1}, {1, 0}}, above{{0, 0}, {0.1, 1}, {-0.1, 1}};
  EXPECT_FALSE(first_touch({below, 0.2}, {above, 0.2}, Outline::rough));
  EXPECT_NEAR(*first_touch({below, 0.2}, {above, 0.2}, Outline::smooth), 0.4, 1e-12);
}

TEST(MutualForce, IsNothingApart) {
  Pair pair({{-1, 0}, {0, -1}, {1, 0}}, {{0, 5}, {0.1, 6}, {-0.1, 6}}, Outline::rough);
  const MutualForce none = pair.force(1, 0);
  EXPECT_EQ(none.contacts, 0);
  EXPECT_EQ(none.friction(), 0);
}

/// The chapter's (9.13), with R and N.
TEST(RoughFrictionBound, IsThatOfThePolygon) {
  for (const auto& [c, n, bound] : {std::tuple(1.3065630, 8, 0.57735), std::tuple(0.71, 8, 0.28233)}) {
    const double inverse = 1 / (c * std::sin(std::numbers::pi / n));
    EXPECT_NEAR(*rough_friction_bound(c * std::sin(std::numbers::pi / n), 1),
                1 / std::sqrt(inverse * inverse - 1), 1e-12);
    EXPECT_NEAR(*rough_friction_bound(c * std::sin(std::numbers::pi / n), 1), bound, 1e-5);
  }
  EXPECT_FALSE(rough_friction_bound(1, 1));
}

}  // namespace
}  // namespace supple
