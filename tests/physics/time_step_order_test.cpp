/// Motion with dashpots and tangential springs is of second order in the time step: twice the steps, a
/// quarter of the error. Forces that saw velocities of half a step before would make it a half.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "supple/solve/mover.hpp"

namespace supple {
namespace {

constexpr PairStiffness spring{100, 4, 80, 3};

/// Equal discs of unit radius and mass, in a cell of 50 x 50.
System<2> discs(std::vector<Vec2> position, std::vector<Vec2> velocity, std::vector<double> spin) {
  System<2> s;
  s.box.length = {50, 50};
  const auto n = static_cast<int>(position.size());
  s.state.resize(n);
  s.state.position = std::move(position);
  s.state.velocity = std::move(velocity);
  s.state.spin = std::move(spin);
  s.state.mass.assign(s.state.position.size(), 1);
  s.state.radius = s.state.mass;
  s.state.inertia.assign(s.state.position.size(), 0.5);
  return s;
}

/// A suspension, how it is sheared, damped [1/time] and held.
struct Ride {
  System<2> system;
  bool linked = false;
  double friction = 0.3;
  std::function<double(double)> strain = [](double) { return 0.0; };
  double damping = 0;
  double duration = 0.5;
};

struct End {
  System<2> system;
  double residual;  ///< of the balance of energy
};

/// Moves it in so many steps. Links are made of all pairs that touch.
End moved(const Ride& m, int steps) {
  System<2> s = m.system;
  Mover mover{ForceField<2>(
      DiscContacts(Divergent(0), {spring, spring, Tensile{}, m.friction, Slip::clamp, LeverArm::distance}))};
  mover.evaluate(s);
  if (m.linked)
    for (int row = 0; row < s.pairs.size(); ++row) s.pairs.state[row] = ContactState::permanent;
  EnergyBalance<2> balance;
  mover.set_account(&balance);
  const double dt = m.duration / steps;
  const auto rates = [&](int k) {
    const double h = 1e-5, t = k * dt;
    return ShearRates{(m.strain(t + h) - m.strain(t - h)) / (2 * h), (m.strain(t + dt) - m.strain(t)) / dt};
  };
  balance.open(s, mover.evaluate(s, rates(0)));
  for (int k = 0; k < steps; ++k) {
    mover.evaluate(s, rates(k));
    mover.advance(s, rates(k), dt, std::exp(-m.damping * dt));
  }
  const Evaluation<2>& last = mover.evaluate(s, rates(steps));
  return {s, balance.residual(s, last)};
}

double distance(const System<2>& a, const System<2>& b) {
  double square = 0;
  for (int i = 0; i < a.state.size(); ++i) {
    const Vec2 apart = a.state.position[i] - b.state.position[i];
    const double turned = a.state.angle[i] - b.state.angle[i];
    square += dot(apart, apart) + turned * turned;
  }
  return std::sqrt(square);
}

/// The changes with twice the steps, and with twice those, are as 4 to 1; so are the residuals of the energy.
void expect_second_order(const Ride& m, int steps = 200) {
  const End a = moved(m, steps), b = moved(m, 2 * steps), c = moved(m, 4 * steps);
  const double coarse = distance(a.system, b.system), fine = distance(b.system, c.system);
  EXPECT_GT(fine, 1e-12);
  EXPECT_NEAR(coarse / fine, 4, 0.4);
  if (std::abs(c.residual) > 1e-10) {
    EXPECT_NEAR(a.residual / b.residual, 4, 0.6);
    EXPECT_NEAR(b.residual / c.residual, 4, 0.6);
  }
}

/// q'' + 2 g q' + w^2 q = 0 with q(0), q'(0), after t; underdamped.
double damped_oscillation(double g, double square, double q, double rate, double t) {
  const double w = std::sqrt(square - g * g);
  return std::exp(-g * t) * (q * std::cos(w * t) + (rate + g * q) / w * std::sin(w * t));
}

/// The reduced mass of the pair is 1/2.
TEST(TimeStepOrder, ALinkWithACentralDashpotEndsWhereTheClosedFormSays) {
  const Ride m{discs({{20, 20}, {21.9, 20}}, {{0.5, 0}, {-0.5, 0}}, {0, 0}), true};
  const double expected = damped_oscillation(spring.eta, 2 * spring.k, -0.1, -1, m.duration);
  const auto error = [&](int steps) {
    const State<2>& s = moved(m, steps).system.state;
    return std::abs(s.position[1][0] - s.position[0][0] - 2 - expected);
  };
  EXPECT_LT(error(400), 1e-4);
  EXPECT_NEAR(error(200) / error(400), 4, 0.4);
  expect_second_order(m);
}

/// Two discs that are fixed but spin: the rims move by 2 w d/2, against inertias 1/2 at arms d/2.
TEST(TimeStepOrder, ALinkWithATangentialDashpotEndsWhereTheClosedFormSays) {
  Ride m{discs({{20, 20}, {21.9, 20}}, {{}, {}}, {2, 2}), true};
  m.system.state.mobility.assign(2, Mobility::fixed);
  const double arm = 0.95, g = 2 * arm * arm * spring.eta_t, square = 4 * arm * arm * spring.k_t;
  const double expected = damped_oscillation(g, square, 0, 2, m.duration);
  const auto error = [&](int steps) { return std::abs(moved(m, steps).system.state.angle[0] - expected); };
  EXPECT_LT(error(400), 1e-4);
  EXPECT_NEAR(error(200) / error(400), 4, 0.4);
  expect_second_order(m);
}

/// Stretching, turning about each other and winding up.
TEST(TimeStepOrder, ALinkedPairThatTurns) {
  expect_second_order({discs({{20, 20}, {21.8, 20.4}}, {{0.7, -1}, {-0.5, 2}}, {2, -1}), true});
}

TEST(TimeStepOrder, ALinkedPairThatIsDamped) {
  Ride m{discs({{20, 20}, {21.8, 20.4}}, {{0.7, -1}, {-0.5, 2}}, {2, -1}), true};
  m.damping = 2;
  expect_second_order(m);
}

/// In contact all the time, first in stick and then in slip.
TEST(TimeStepOrder, AContactThatSticksAndSlips) {
  Ride m{discs({{20, 20}, {21.7, 20.4}}, {{0.7, -1}, {-0.5, 2}}, {4, 1}), false, 0.5};
  m.duration = 0.12;
  expect_second_order(m, 240);
}

/// A row of discs across the boundary of a cell whose shear swings.
TEST(TimeStepOrder, LinksAcrossTheShearedBoundary) {
  Ride m{discs({{20, 1}, {20.3, 49.1}, {20.5, 47.3}}, {{}, {}, {}}, {0, 0, 0}), true};
  m.strain = [](double t) { return 0.05 * std::sin(7 * t + 0.3); };
  m.damping = 1;
  expect_second_order(m);
}

TEST(TimeStepOrder, ALinkThatAPlateDrives) {
  Ride m{discs({{20, 49.5}, {20.3, 47.7}}, {{}, {}}, {0, 0}), true};
  m.system.state.mobility[0] = Mobility::upper_plate;
  m.strain = [](double t) { return 0.01 * std::sin(7 * t); };
  expect_second_order(m);
}

/// The rate jumps with the step at which the shear begins, and with that at which it ends.
TEST(TimeStepOrder, AShearThatBeginsAndEndsAtOnce) {
  Ride m{discs({{20, 1}, {20.3, 49.1}, {20.5, 47.3}}, {{}, {}, {}}, {0, 0, 0}), true};
  m.strain = [](double t) { return 0.05 * std::sin(10 * (std::clamp(t, 0.1, 0.4) - 0.1)); };
  expect_second_order(m);
}

/// What the spring of a contact does in the half step before it opens counts, too.
TEST(TimeStepOrder, TheEnergyOfACollisionBalances) {
  for (const double friction : {0.0, 0.1, 1.0}) {
    Ride m{discs({{20, 20}, {22.05, 20.1}}, {{0.5, 0.2}, {-0.5, -0.4}}, {3, 1}), false, friction};
    m.duration = 1;
    const End a = moved(m, 1000), b = moved(m, 2000), c = moved(m, 4000);
    EXPECT_GT(distance(c.system, m.system), 0.5);
    EXPECT_LT(std::abs(b.residual), std::abs(a.residual) / 3) << friction;
    EXPECT_LT(std::abs(c.residual), std::abs(b.residual) / 3) << friction;
  }
}

}  // namespace
}  // namespace supple
