#include "supple/contact/touch_friction.hpp"

#include "supple/contact/link_forces.hpp"
#include "supple/model/body_flow.hpp"
#include "tests/support/polygons.hpp"
#include "tests/support/touching.hpp"

namespace supple {
namespace {

using namespace testing;

/// Sticks and pulls: both springs and dashpots act as they are.
const TouchLaw free_law{.friction = 1e9, .k_t = 40, .eta = 3, .eta_t = 2, .pull = ViscousPull::allowed};

/// Forces of friction alone: with the contacts less without.
Evaluation<2> friction_alone(const Touching& t, System<2>& system, const TouchLaw& law) {
  ForceField<2> field(*t.contacts);
  Evaluation<2> out;
  field.evaluate(system, Detail::energies, out);
  std::fill(out.force.begin(), out.force.end(), Vec2{});
  out.torque.assign(out.force.size(), 0);
  out.energy = {};
  out.virial = {};
  TouchFriction(law).evaluate(system, *t.contacts, system.lag, Detail::energies, out);
  return out;
}

TEST(TouchFriction, PowerOfAllForcesIsForceTimesVelocityOfTheTouch) {
  for (Touching& t : all_touchings())
    for (const std::uint64_t seed : {1, 2, 3}) {
      SCOPED_TRACE(t.name);
      stir(t.system, seed);
      const auto e = friction_alone(t, t.system, free_law);
      ASSERT_FALSE(e.trial_touch.empty());
      ASSERT_GT(e.energy.viscous_power, 0);
      ASSERT_GT(e.energy.tangential_viscous_power, 0);
      // Dashpots alone: F.v is what they lose.
      EXPECT_NEAR(power(e, t.system.state), -e.energy.viscous_power - e.energy.tangential_viscous_power,
                  1e-12);
      if (e.trial_touch.size() > 1) continue;
      // A spring beside them: k_t u v_t more, where eta_t v_t^2 says what v_t is.
      System<2> wound = t.system;
      wound.touches.rows = e.trial_touch;
      wound.touches.rows[0].elongation = 0.3;
      const auto w = friction_alone(t, wound, free_law);
      const double half = t.contacts->scale(
          ring_of(wound.topology, wound.touches.rows[0].key.site == wound.topology.begin[1]));
      EXPECT_NEAR(std::abs(power(w, wound.state) - power(e, wound.state)),
                  half * 40 * 0.3 * std::sqrt(e.energy.tangential_viscous_power / (half * 2)), 1e-12);
      EXPECT_NEAR(w.energy.tangential, half * 0.5 * 40 * 0.3 * 0.3, 1e-13);
    }
}

TEST(TouchFriction, NetForceAndTorqueAreZeroAndTheVirialIsThatOfAllForces) {
  for (Touching& t : all_touchings()) {
    SCOPED_TRACE(t.name);
    stir(t.system, 4);
    const auto e = friction_alone(t, t.system, free_law);
    Vec2 force{};
    double torque = 0, largest = 0;
    Mat2 virial;
    for (int i = 0; i < t.system.state.size(); ++i) {
      const Vec2 x = t.system.state.position[i] - Vec2{50, 50};
      force += e.force[i];
      torque += cross(x, e.force[i]) + e.torque[i];
      largest = std::max(largest, norm(e.force[i]));
      virial.add_outer(1, e.force[i], x);
    }
    ASSERT_GT(largest, 0.1);
    EXPECT_LT(norm(force), 1e-12);
    EXPECT_NEAR(torque, 0, 1e-12);
    for (int c = 0; c < 2; ++c)
      for (int d = 0; d < 2; ++d) EXPECT_NEAR(virial[c][d], e.virial[c][d], 1e-11);
  }
}

TEST(TouchFriction, RigidTurnWindsUpNothing) {
  for (Touching& t : all_touchings())
    for (const int steps : {40, 1000}) {
      SCOPED_TRACE(t.name);
      System<2> system = t.system;
      ForceField<2> field = t.field(free_law);
      Evaluation<2> out;
      const double angle = 2 * std::numbers::pi / steps;
      double most = 0;
      for (int k = 0; k < steps; ++k) {
        turn(system, {49, 52}, angle, 0.01);
        field.evaluate(system, Detail::energies, out);
        field.commit(system, out);
        EXPECT_LT(out.energy.viscous_power + out.energy.tangential_viscous_power, 1e-18);
        ASSERT_FALSE(system.touches.rows.empty());
        for (const Touch& touch : system.touches.rows) most = std::max(most, std::abs(touch.elongation));
      }
      EXPECT_LT(most, 1e-12 * t.distance);
    }
}

/// With velocities of the instant, as they are at the start of a motion, nothing moves either.
TEST(TouchFriction, RigidMotionHasNoVelocity) {
  for (Touching& t : all_touchings()) {
    SCOPED_TRACE(t.name);
    for (int i = 0; i < t.system.state.size(); ++i) {
      t.system.state.velocity[i] = Vec2{0.4, 2} + cross(1.3, t.system.state.position[i]);
      t.system.state.spin[i] = 1.3;
    }
    const auto e = friction_alone(t, t.system, free_law);
    for (const Vec2& f : e.force) EXPECT_LT(norm(f), 1e-11);
  }
}

/// A disc without spin that moves over a body at rest from edge to edge and round a corner, at one depth:
/// u is the way that its centre went.
TEST(TouchFriction, SlidingOverTheEndOfAnEdgeAndRoundACornerKeepsTheElongation) {
  const std::vector<Vec2> ring{{0, 0}, {1, 0}, {3, 0}, {3, 3}, {0, 3}};
  Touching t = touching<SmoothContacts>("", ring, {0.5, -1}, Toucher::disc);
  ForceField<2> field = t.field({.friction = 1e9, .k_t = 1});
  Evaluation<2> out;
  const double dt = 1e-3, speed = 1;
  double way = 0;
  State<2>& s = t.system.state;
  const auto move_to = [&](const Vec2& p) {
    const Vec2 to = p + Vec2{50, 50};
    way += norm(to - s.position.back());
    s.velocity.back() = (1 / dt) * (to - s.position.back());
    s.position.back() = to;
    t.system.lag = dt;
    field.evaluate(t.system, Detail::forces, out);
    field.commit(t.system, out);
    ASSERT_EQ(t.system.touches.rows.size(), 1u);
  };
  for (int k = 1; k <= 2500; ++k) move_to({0.5 + speed * dt * k, -1});
  EXPECT_NEAR(std::abs(t.system.touches.rows[0].elongation), 2.5, 1e-9);  // a corner has a round front
  for (int k = 1; k <= 1000; ++k) {
    const double angle = 0.5 * std::numbers::pi * k / 1000;
    move_to({3 + std::sin(angle), -std::cos(angle)});
  }
  for (int k = 1; k <= 1000; ++k) move_to({4, speed * dt * k});
  EXPECT_NEAR(std::abs(t.system.touches.rows[0].elongation), way, 1e-6);
  EXPECT_NEAR(way, 3.5 + 0.5 * std::numbers::pi, 1e-6);
}

TEST(TouchFriction, WithoutFrictionAndViscosityForcesKeepTheirBits) {
  System<2> system = random_polygons({.bodies = 9, .seed = 3});
  add_disc_body(system, {1.3, 1.4}, 0.5);
  stir(system, 1);
  system.lag = 0.01;
  const auto contacts = std::make_shared<SmoothContacts>(Harmonic{2});
  ForceField<2> plain = polygon_field(*contacts), rubbing = polygon_field(*contacts);
  rubbing.add(TouchFriction(TouchLaw{.k_t = 1}));
  Evaluation<2> a, b;
  plain.evaluate(system, Detail::energies, a);
  rubbing.evaluate(system, Detail::energies, b);
  EXPECT_EQ(a.force, b.force);
  EXPECT_EQ(a.energy.stored(), b.energy.stored());
  EXPECT_GT(b.trial_touch.size(), 10u);
}

/// A vertex in the middle of a slit of one body: the pushes of its sides cancel, and dashpots stay bounded.
TEST(TouchFriction, DashpotsInASlitAreNotAmplified) {
  const std::vector<Vec2> slit{{0, 0}, {6, 0}, {6, 4}, {3.4, 4}, {3.4, 1}, {2.6, 1}, {2.6, 4}, {0, 4}};
  for (const double off : {0.1, 1e-3, 1e-6}) {
    Touching t = touching<SmoothContacts>("", slit, {3 + off, 3}, Toucher::disc);
    stir(t.system, 2);
    const auto e = friction_alone(t, t.system, free_law);
    ASSERT_EQ(e.trial_touch.size(), 1u);
    double largest = 0;
    for (const Vec2& f : e.force) largest = std::max(largest, norm(f));
    EXPECT_GT(largest, 1e-3);
    EXPECT_LT(largest, 8 * free_law.eta);  // no relative speed is above 2 sqrt(2), of a few vertices
  }
}

/// Whichever image of each body stands in the cell, sheared and while it is being sheared.
TEST(TouchFriction, ForcesDoNotDependOnTheImagesThatDescribeTheState) {
  System<2> system = random_polygons({.bodies = 9, .seed = 7});
  add_disc_body(system, {1.3, 1.4}, 0.5);
  system.box.strain_rate = 0.9;
  stir(system, 8);
  const Vec2 moves[] = {{1, 0}, {0, 1}, {-1, -1}, {2, 1}};
  for (const bool smooth : {false, true}) {
    const TouchLaw law{0.4, 40, 3, 2};
    System<2> here = system, there = system;
    for (int b = 0; b < there.topology.body_count(0); ++b) {
      const Vec2 n = moves[b % 4];
      for (int i = there.topology.begin[b]; i < there.topology.begin[b + 1]; ++i) {
        there.state.position[i] +=
            Vec2{n[0] * there.box.length[0] + n[1] * there.box.strain * there.box.length[1],
                 n[1] * there.box.length[1]};
        there.state.velocity[i] += there.box.velocity_jump(static_cast<int>(n[1]));
      }
    }
    Evaluation<2> out[2];
    int k = 0;
    for (System<2>* s : {&here, &there}) {
      std::shared_ptr<BodyContacts<2>> contacts;
      if (smooth) contacts = std::make_shared<SmoothContacts>(Harmonic{50});
      else contacts = std::make_shared<RoughContacts<2>>(Harmonic{50});
      ForceField<2> field(*contacts);
      field.add(TouchFriction(law));
      for (int step = 0; step < 2; ++step) {  // the second one has what the first has wound up
        s->lag = 0.01;
        field.evaluate(*s, Detail::energies, out[k]);
        field.commit(*s, out[k]);
      }
      ++k;
    }
    ASSERT_GT(here.touches.rows.size(), 10u);
    ASSERT_EQ(here.touches.rows.size(), there.touches.rows.size());
    // The rounding of positions, 1e-15 of the cell, turns a normal by as much over the distance of the pair.
    double largest = 0;
    for (const Vec2& f : out[0].force) largest = std::max(largest, norm(f));
    for (std::size_t i = 0; i < out[0].force.size(); ++i) {
      EXPECT_LT(norm(out[0].force[i] - out[1].force[i]), 1e-13 * largest);
      EXPECT_NEAR(out[0].torque[i], out[1].torque[i], 1e-13 * largest);
    }
    std::vector<double> elongation[2];
    for (const Touch& touch : here.touches.rows) elongation[0].push_back(touch.elongation);
    for (const Touch& touch : there.touches.rows) elongation[1].push_back(touch.elongation);
    for (auto& u : elongation) std::sort(u.begin(), u.end());
    for (std::size_t i = 0; i < elongation[0].size(); ++i)
      EXPECT_NEAR(elongation[0][i], elongation[1][i], 1e-13);
    EXPECT_NEAR(out[0].energy.tangential, out[1].energy.tangential, 1e-11);
    for (int c = 0; c < 2; ++c)
      for (int d = 0; d < 2; ++d) EXPECT_NEAR(out[0].virial[c][d], out[1].virial[c][d], 1e-10);
  }
}

/// Bodies that are brought back into the cell as they leave it move and remember as if they were not.
TEST(TouchFriction, CrossingTheShearedBoundaryTearsNothingAndForgetsNothing) {
  for (const bool smooth : {false, true}) {
    System<2> start = random_polygons({.bodies = 9, .seed = 7, .diameter_ratio = smooth ? 0.6 : 1.0});
    add_disc_body(start, {1.1, 1.2}, 0.3);
    start.box.strain_rate = 0.3;
    for (Vec2& v : start.state.velocity) v = {0.7, 2};
    start.links = {{3, start.topology.begin[1], {}, 1, 0}, {0, start.topology.begin[8], {1, 0, 0}, 1, 0}};
    const auto run = [&](bool wraps, int& wrapped) {
      System<2> system = start;
      std::shared_ptr<BodyContacts<2>> contacts;
      if (smooth) contacts = std::make_shared<SmoothContacts>(Harmonic{5});
      else contacts = std::make_shared<RoughContacts<2>>(Harmonic{5});
      ForceField<2> field = polygon_field(*contacts);
      field.add(TouchFriction(TouchLaw{0.4, 3, 0.5, 0.3}));
      field.add(LinkForces(LinkLaw{3, 0.2, 2, 0.1}));
      Evaluation<2> out;
      State<2>& s = system.state;
      const double dt = 0.01;
      for (int step = 0; step < 200; ++step) {
        field.evaluate(system, Detail::forces, out);
        field.commit(system, out);
        for (int i = 0; i < s.size(); ++i) {
          s.velocity[i] += dt / s.mass[i] * out.force[i];
          s.spin[i] += dt / s.inertia[i] * out.torque[i];
          s.position[i] += dt * s.velocity[i];
        }
        system.box.strain += dt * system.box.strain_rate;
        system.lag = dt;
        if (wraps && wrap_bodies(system)) ++wrapped, field.invalidate();
      }
      field.evaluate(system, Detail::forces, out);
      field.commit(system, out);
      std::vector<double> numbers;
      for (const Vec2& f : out.force) numbers.push_back(f[0]), numbers.push_back(f[1]);
      std::vector<double> elongations;
      for (const Touch& touch : system.touches.rows) elongations.push_back(touch.elongation);
      for (const Link& link : system.links) elongations.push_back(link.elongation);
      std::sort(elongations.begin(), elongations.end());
      numbers.insert(numbers.end(), elongations.begin(), elongations.end());
      return numbers;
    };
    int wrapped = 0;
    const auto in_cell = run(true, wrapped), anywhere = run(false, wrapped);
    EXPECT_GT(wrapped, 4);
    ASSERT_EQ(in_cell.size(), anywhere.size());
    EXPECT_GT(in_cell.size(), 2 * static_cast<std::size_t>(start.state.size()) + 10);
    for (std::size_t k = 0; k < in_cell.size(); ++k) EXPECT_NEAR(in_cell[k], anywhere[k], 1e-8);
  }
}

}  // namespace
}  // namespace supple
