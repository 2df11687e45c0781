/// A stiff polygon of many vertices rolls and slides as the wheel of its outline does.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "supple/solve/mover.hpp"
#include "tests/support/polygons.hpp"
#include "tests/support/touching.hpp"

namespace supple {
namespace {

using namespace testing;

constexpr int sides = 60;
/// Of a wheel: mass 1, all of it at the distance 1 from the centre, so that its moment of inertia is 1.
constexpr double rim = 1, rounding = 0.05, outer = rim + rounding;
constexpr double stiffness = 2000, dt = 1e-4, gravity = 1;

enum class Outline { polygon, rigid, disc };

std::vector<Vec2> ring_about(const Vec2& centre) {
  std::vector<Vec2> ring;
  for (int k = 0; k < sides; ++k) {
    const double angle = 2 * std::numbers::pi * (k + 0.21) / sides;
    ring.push_back(centre + rim * Vec2{std::cos(angle), std::sin(angle)});
  }
  return ring;
}

/// A wheel, of 60 vertices and stiff against bending, or rigid, or a disc, on a ground that does not move.
class Rolling {
 public:
  Rolling(System<2> ground, Outline wheel, const Vec2& centre, const TouchLaw& law)
      : system_(std::move(ground)), mover_(field(law)) {
    const int first = system_.state.size();
    system_.state.mobility.assign(static_cast<std::size_t>(first), Mobility::fixed);
    system_.state.inertia.assign(static_cast<std::size_t>(first), 1e300);  // nor does a disc there turn
    const double edge = 2 * rim * std::sin(std::numbers::pi / sides), turn = 2 * std::numbers::pi / sides;
    if (wheel == Outline::disc) add_disc_body(system_, centre, outer);
    else
      add_ring(system_, ring_about(centre), rounding, {0, 4000, 300, 0}, 1, std::vector<double>(sides, edge),
               std::vector<double>(sides, turn));
    for (int i = first; i < system_.state.size(); ++i) {
      system_.state.mass[i] = wheel == Outline::disc ? 1 : 1.0 / sides;
      system_.state.inertia[i] = rim * rim;
    }
    if (wheel == Outline::rigid) make_rigid(system_, 1);
  }

  void pull(const Vec2& weight) { mover_.forces().external().gravity = weight; }
  void push(const Vec2& velocity) {
    for (int i = system_.topology.begin[1]; i < system_.state.size(); ++i)
      system_.state.velocity[i] = velocity;
    for (Vec2& v : system_.rigid.velocity) v = velocity;
  }
  void run(double time) {
    for (int step = 0; step * dt < time; ++step) {
      const EnergyParts& e = mover_.evaluate_energies(system_).energy;
      lost_ += system_.lag * (e.sliding_power + e.viscous_power + e.tangential_viscous_power);
      mover_.advance(system_, {}, dt, 1);
    }
  }
  BodyMotion<2> wheel() const { return body_motion(system_, 1); }
  double lost() const { return lost_; }

 private:
  static ForceField<2> field(const TouchLaw& law) {
    const auto contacts = std::make_shared<SmoothContacts>(Harmonic{stiffness});
    ForceField<2> f = polygon_field(*contacts);
    f.add(TouchFriction(law));
    return f;
  }

  System<2> system_;
  Mover<2> mover_;
  double lost_ = 0;
};

System<2> open_space() {
  System<2> s;
  s.box.length = {1000, 1000};
  s.box.periodic = {false, false};
  return s;
}

TouchLaw rough(double mu) { return {.friction = mu, .k_t = stiffness, .eta = 4, .eta_t = 1}; }

Rolling on_table(double mu, Outline wheel) {
  System<2> table = open_space();  // its top is at y = 0
  add_body(table, {{0, -5}, {100, -5}, {100, 0}, {0, 0}}, rounding);
  return {table, wheel, {20, rim + 2 * rounding - 5e-4}, rough(mu)};
}

/// Share of its energy that a corner costs a rigid polygon: it goes on about the next one with what its
/// angular momentum about that is, (2 pi/n)^2/2 m R^2/(I + m R^2) less.
const double corner_cost =
    0.5 * std::pow(2 * std::numbers::pi / sides, 2) / (1 + rim * rim / (outer * outer));

/// Down a slope of angle alpha: a = g sin(alpha)/(1 + I/(m R^2)) without slip, which takes friction of at
/// least tan(alpha)/(1 + m R^2/I); less friction slides, and mu times the impulse of the ground goes from the
/// fall to the spin. There are four corners.
TEST(Rolling, DownASlopeIsThatOfAWheel) {
  const double alpha = 0.3, along = gravity * std::sin(alpha), down = gravity * std::cos(alpha), time = 2;
  for (const auto [mu, wheel] : {std::pair{0.5, Outline::polygon},
                                 {0.08, Outline::polygon},
                                 {0.5, Outline::rigid},
                                 {0.08, Outline::rigid}}) {
    Rolling r = on_table(mu, wheel);
    r.pull({along, -down});
    r.run(0.5);
    const BodyMotion start = r.wheel();
    r.run(time);
    const BodyMotion end = r.wheel();
    const double impulse = down * time + end.velocity[1] - start.velocity[1];
    const bool rolls = mu > std::tan(alpha) / (1 + outer * outer / (rim * rim));
    const double gained =
        rolls ? along * time / (1 + rim * rim / (outer * outer)) : along * time - mu * impulse;
    const double turned = rolls ? gained / outer : mu * impulse * outer / (rim * rim);
    EXPECT_NEAR(end.velocity[0] - start.velocity[0], gained, 0.02 * gained) << mu;
    EXPECT_NEAR(start.spin - end.spin, turned, 0.02 * turned) << mu;
  }
}

/// Pushed without spin it slides until it rolls: v = v0/(1 + I/(m R^2)), and the rest, I/(I + m R^2) of its
/// energy, is lost. It swings on the spring of the contact: the mean over a while.
class RollingPolygon : public ::testing::TestWithParam<Outline> {};
INSTANTIATE_TEST_SUITE_P(StiffAndRigid, RollingPolygon, ::testing::Values(Outline::polygon, Outline::rigid));

TEST_P(RollingPolygon, SlidesUntilItRollsAtTheSpeedOfAWheel) {
  Rolling r = on_table(0.6, GetParam());
  r.pull({0, -gravity});
  r.run(0.5);
  const double before = r.lost();
  r.push({1, 0});
  r.run(1);
  const double lost_then = r.lost() - before, while_ = 0.5;
  const Vec2 from = r.wheel().centre;
  double turned = 0;
  for (int k = 0; k < 50; ++k) {
    r.run(while_ / 50);
    turned -= r.wheel().spin * while_ / 50;
  }
  const double share = rim * rim / (outer * outer), v = 1 / (1 + share), lost = 0.5 * share / (1 + share);
  EXPECT_NEAR(lost_then, lost, (GetParam() == Outline::rigid ? 0.03 : 0.02) * lost);  // and its corners
  EXPECT_NEAR((r.wheel().centre[0] - from[0]) / while_, v, 0.02 * v);
  EXPECT_NEAR(turned * outer / while_, v, 0.02 * v);
}

/// From near the top of another one: it rolls, then slides as the ground pushes less and less, and loses what
/// the disc of its outline loses on a disc, and less than what rigid corners cost.
TEST_P(RollingPolygon, DownAnotherOneLosesWhatADiscDoesAndItsCorners) {
  const double angle = 0.3, apart = 2 * outer - 1e-3;
  double lost[2], drop = 0, way = 0;
  for (const Outline outline : {Outline::disc, GetParam()}) {
    System<2> ground = open_space();
    if (outline != Outline::disc) add_body(ground, ring_about({0, 0}), rounding);
    else add_disc_body(ground, {0, 0}, outer);
    Rolling r(ground, outline, {apart * std::sin(angle), apart * std::cos(angle)}, rough(0.4));
    r.pull({0, -gravity});
    r.run(3.5);
    const BodyMotion end = r.wheel();
    const double kinetic = 0.5 * dot(end.velocity, end.velocity) + 0.5 * rim * rim * end.spin * end.spin;
    drop = gravity * (apart * std::cos(angle) - end.centre[1]);
    way = apart * (std::atan2(end.centre[0], end.centre[1]) - angle);
    const int k = outline != Outline::disc;
    lost[k] = r.lost();
    EXPECT_NEAR(kinetic + lost[k], drop, 0.01 * drop);
    EXPECT_GT(norm(end.velocity), -1.1 * end.spin * outer);  // it slides by now
  }
  const double corners = 2 * way / (2 * std::numbers::pi * rim / sides);  // of both
  EXPECT_GT(lost[0], 0.005 * drop);
  EXPECT_GT(lost[1], lost[0]);
  EXPECT_LT(lost[1] - lost[0], corners * corner_cost * 0.5 * drop);
}

}  // namespace
}  // namespace supple
