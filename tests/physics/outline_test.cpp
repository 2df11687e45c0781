/// Stiff smooth polygons of many vertices push and lose as discs of their outline with the law that follows
/// from it.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "supple/contact/laws/list.hpp"
#include "supple/core/random.hpp"
#include "tests/support/polygons.hpp"
#include "tests/support/touching.hpp"

namespace supple {
namespace {

using namespace testing;

/// Vertices at the distance `rim` from the centre, l apart; surfaces meet `gap` beyond.
constexpr int sides = 60;
constexpr double rim = 1, gap = 0.1, k = 2, eta = 3;
const double spacing = 2 * std::numbers::pi * rim / sides;

System<2> two_polygons(double distance, std::uint64_t draw) {
  System<2> s;
  s.box.length = {100, 100};
  s.box.periodic = {false, false};
  RandomStream random(draw, Purpose::test, 0);
  for (const double x : {0.0, distance}) {
    const double turn = random.uniform(0, 2 * std::numbers::pi);
    std::vector<Vec2> ring;
    for (int i = 0; i < sides; ++i) {
      const double angle = turn + 2 * std::numbers::pi * i / sides;
      ring.push_back(Vec2{50 + x, 50} + rim * Vec2{std::cos(angle), std::sin(angle)});
    }
    add_body(s, ring, 0.5 * gap);
  }
  return s;
}

/// A vertex at x beside the line of centres is delta - x^2/R deep, where 2/R is the sum of the curvatures of
/// its circle and of the line at the distance where surfaces meet from the other one. Half of the energy is
/// on either side: F = (k/l) int (delta - x^2/R) dx = (4/3) (k/l) sqrt(R) delta^(3/2), and 2 sqrt(R delta)/l
/// dashpots act. Edges lie (2/3) r (1 - cos(pi/n)) behind their circle in the mean.
TEST(Outline, ForcesOfTwoPolygonsAreThoseOfTheirCirclesInTheMean) {
  for (const double overlap : {0.02, 0.04}) {
    const double delta = overlap - 2.0 / 3.0 * rim * (1 - std::cos(std::numbers::pi / sides));
    const double curvature = 0.5 * (1 / rim + 1 / (rim + gap - overlap)),
                 bearing = 2 * std::sqrt(delta / curvature) / spacing;
    const auto contacts = std::make_shared<SmoothContacts>(Harmonic{k});
    ForceField<2> bare(SmoothContacts(Harmonic{k})), field(*contacts);
    field.add(
        TouchFriction(TouchLaw{.friction = 1e9, .eta = eta, .eta_t = eta, .pull = ViscousPull::allowed}));
    double push = 0, viscous = 0, along = 0;
    const int draws = 400;
    for (int draw = 1; draw <= draws; ++draw) {
      System<2> s = two_polygons(2 * rim + gap - overlap, draw);
      for (int i = sides; i < 2 * sides; ++i) s.state.velocity[i] = {1, 1};
      Evaluation<2> elastic, all;
      bare.evaluate(s, Detail::forces, elastic);
      field.evaluate(s, Detail::forces, all);
      for (int i = sides; i < 2 * sides; ++i) {
        push += elastic.force[i][0] / draws;
        viscous -= (all.force[i][0] - elastic.force[i][0]) / draws;
        along -= (all.force[i][1] - elastic.force[i][1]) / draws;
      }
    }
    EXPECT_NEAR(push, 2.0 / 3.0 * k * bearing * delta, 0.015 * push) << overlap;
    EXPECT_NEAR(viscous, eta * bearing, 0.02 * viscous) << overlap;
    EXPECT_NEAR(along, eta * bearing, 0.02 * along) << overlap;
    // The law "hertz" of discs of radius R + gap/2, with the spring that makes it the same.
    const double d0 = 2 * rim + gap, d = d0 - delta;
    const double per_spring = Hertz().force(d, d0, 1) / std::pow(delta, 1.5);
    const double spring = 4.0 / 3.0 * k / (spacing * std::sqrt(curvature)) / per_spring;
    EXPECT_NEAR(Hertz().force(d, d0, spring), push, 0.015 * push);
  }
}

}  // namespace
}  // namespace supple
