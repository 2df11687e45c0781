/// Contacts that attract: closed forms of two particles, and what holds for every way in which bodies meet.
#include "supple/contact/laws/adhesive.hpp"

#include "supple/contact/disc_contacts.hpp"
#include "supple/observe/rattlers.hpp"
#include "tests/support/field_check.hpp"
#include "tests/support/polygons.hpp"
#include "tests/support/touching.hpp"

namespace supple {
namespace {

using namespace testing;

constexpr double k = 3, w = 0.3;

BodyLaw sticky(double stiffness = k, double range = w) { return {Harmonic{stiffness}, Adhesive(range)}; }

TEST(AdhesiveLaw, WellPullAndReleaseAreThoseOfTheClosedForm) {
  const Adhesive law(w);
  const double d0 = 2;
  EXPECT_DOUBLE_EQ(law.energy(d0, d0, k), -k * w * w * d0 * d0 / 4);
  EXPECT_DOUBLE_EQ(law.force(d0, d0, k), 0);
  EXPECT_NEAR(law.force(d0 * (1 + w / 2), d0, k), -k * w * d0 / 2, 1e-14);
  EXPECT_NEAR(law.force(d0 * (1 + w) * (1 - 1e-12), d0, k), 0, 1e-10);  // released without a jump
  for (const double beyond : {1.0, 1.1, 2.0}) {
    EXPECT_EQ(law.force(d0 * (1 + w) * beyond, d0, k), 0);
    EXPECT_EQ(law.energy(d0 * (1 + w) * beyond, d0, k), 0);
  }
  // The work of pulling the pair apart is the depth of the well.
  double work = 0;
  const int steps = 1000;
  for (int i = 0; i < steps; ++i) work -= law.force(d0 * (1 + w * (i + 0.5) / steps), d0, k) * d0 * w / steps;
  EXPECT_NEAR(work, k * w * w * d0 * d0 / 4, 1e-6);
}

TEST(AdhesiveLaw, FieldOfPolygonsHoldsWhatEveryFieldMust) {
  for (const bool smooth : {false, true})
    for (const std::uint64_t seed : {1, 2}) {
      SCOPED_TRACE(seed);
      System<2> system = random_polygons({.seed = seed});
      add_disc_body(system, {1.1, 1.3}, 0.6);
      const BodyLaw law{Harmonic{2, seed == 2}, Adhesive(0.35)};
      std::shared_ptr<BodyContacts<2>> contacts;
      if (smooth) contacts = std::make_shared<SmoothContacts>(law);
      else contacts = std::make_shared<RoughContacts<2>>(law);
      ForceField<2> field = polygon_field(*contacts);
      FieldCheck(field, system).run();
      int pulling = 0;
      for (const BodyTouch<2>& t : sum_touches(system, contacts->records(system), law))
        pulling += t.normal_force() < 0;
      EXPECT_GT(pulling, 5);
    }
}

TEST(AdhesiveLaw, FastLoopsEqualTheirRecords) {
  for (const bool smooth : {false, true}) {
    System<2> system = random_polygons({.bodies = 30});
    std::shared_ptr<BodyContacts<2>> contacts;
    if (smooth) contacts = std::make_shared<SmoothContacts>(sticky());
    else contacts = std::make_shared<RoughContacts<2>>(sticky());
    ForceField<2> field(*contacts);
    Evaluation<2> fast, slow;
    field.evaluate(system, Detail::energies, fast);
    slow.force.resize(fast.force.size());
    slow.torque.resize(fast.force.size());
    evaluate_conservative(contacts->records(system), contacts->laws(), slow);
    EXPECT_NEAR(fast.energy.elastic, slow.energy.elastic, 1e-12);
    for (std::size_t i = 0; i < fast.force.size(); ++i) EXPECT_LT(norm(fast.force[i] - slow.force[i]), 1e-12);
    EXPECT_NEAR(fast.virial[0][1], slow.virial[0][1], 1e-12);
  }
}

/// Two sites at a distance, of every kind that may meet.
struct Pair {
  std::string name;
  std::function<ForceField<2>()> field;
  std::function<System<2>(double)> at;
};

System<2> open_cell() {
  System<2> s;
  s.box.length = {60, 60};
  return s;
}

std::vector<Pair> all_pairs() {
  const auto discs = [](double d) {
    System<2> s = open_cell();
    s.state.resize(2);
    s.state.position = {{59.9, 5}, {59.9 + d, 5}};  // over the edge of the cell
    s.state.radius = {0.5, 0.5};
    return s;
  };
  const auto bodies = [](double d) {
    System<2> s = open_cell();
    add_disc_body(s, {59.9, 5}, 0.5);
    add_disc_body(s, {59.9 + d - 60, 5}, 0.5);
    return s;
  };
  const auto on_edge = [](double d) {
    System<2> s = open_cell();
    add_body(s, {{5, 5}, {15, 5}, {15, 6}, {5, 6}}, 0.5);
    add_disc_body(s, {10.2, 5 - d}, 0.5);
    return s;
  };
  const auto body_field = []<class Contacts>(std::type_identity<Contacts>) {
    // No skin: the list reaches out to the range by itself.
    return [] { return ForceField<2>(Contacts(sticky()), 1e-9); };
  };
  return {{"discs",
           [] {
             return ForceField<2>(DiscContacts(Adhesive(w), DiscLaw{{k}, {}, Tensile{}}), 1e-9);
           },
           discs},
          {"rough", body_field(std::type_identity<RoughContacts<2>>{}), bodies},
          {"smooth", body_field(std::type_identity<SmoothContacts>{}), bodies},
          {"on an edge", body_field(std::type_identity<SmoothContacts>{}), on_edge}};
}

TEST(AdhesiveLaw, NeighbourListReachesOutToTheRange) {
  for (const Pair& pair : all_pairs())
    for (const double d : {0.9, 1.05, 1.2, 1.29, 1.2999, 1.3001, 1.5}) {
      SCOPED_TRACE(pair.name);
      ForceField<2> field = pair.field();
      System<2> system = pair.at(d);
      Evaluation<2> out;
      field.evaluate(system, Detail::energies, out);
      const double expected = Adhesive(w).force(d, 1, k);
      EXPECT_NEAR(norm(out.force.back()), std::abs(expected), 1e-12) << d;
      EXPECT_NEAR(out.energy.elastic, Adhesive(w).energy(d, 1, k), 1e-12) << d;
      // Positive where it pushes: pressure of a pair that adheres is negative.
      EXPECT_NEAR(out.virial[0][0] + out.virial[1][1], expected * d, 1e-12) << d;
    }
}

/// A pair that is let go at the largest pull swings through contact and back, and one that meets fast parts
/// again, with the energy it had.
TEST(AdhesiveLaw, MotionThroughTheWellKeepsEnergyAndMomentum) {
  for (const Pair& pair : all_pairs())
    for (const double speed : {0.0, 1.5}) {
      SCOPED_TRACE(pair.name);
      ForceField<2> field = pair.field();
      System<2> system = pair.at(speed > 0 ? 1.4 : 1.15);
      const bool edge = pair.name == "on an edge";
      State<2>& s = system.state;
      const Vec2 toward = edge ? Vec2{0, 1} : Vec2{-1, 0};
      s.mass.assign(s.mass.size(), 1);
      s.velocity.assign(s.velocity.size(), Vec2{});
      s.velocity.back() = speed * toward;
      const Vec2 momentum = speed * toward;
      const double dt = 1e-3;
      double first = 0, worst = 0, deepest = 0;
      Evaluation<2> out;
      field.evaluate(system, Detail::energies, out);
      first = out.energy.elastic + 0.5 * speed * speed;
      for (int step = 0; step < 20000; ++step) {
        for (int i = 0; i < s.size(); ++i) {
          s.velocity[i] += 0.5 * dt * out.force[i];
          s.position[i] += dt * s.velocity[i];
        }
        field.evaluate(system, Detail::energies, out);
        double now = out.energy.elastic;
        Vec2 p{};
        for (int i = 0; i < s.size(); ++i) {
          s.velocity[i] += 0.5 * dt * out.force[i];
          now += 0.5 * dot(s.velocity[i], s.velocity[i]);
          p += s.velocity[i];
        }
        worst = std::max(worst, std::abs(now - first));
        deepest = std::min(deepest, out.energy.elastic);
        ASSERT_LT(norm(p - momentum), 1e-10);
      }
      EXPECT_LT(worst, 1e-5);
      EXPECT_LT(deepest, -0.9 * k * w * w / 4);
      const double left = out.energy.elastic;
      if (speed > 0) {  // they have parted
        EXPECT_EQ(left, 0);
      }
    }
}

/// What pulls does not rub, and its dashpot does not add to the pull; power is as for every law.
TEST(AdhesiveLaw, TouchesThatPullDoNotRub) {
  Touching t = touching<SmoothContacts>("", square, {1.5, -1.3}, Toucher::disc);
  t.contacts = std::make_shared<SmoothContacts>(sticky(100));
  for (const double v : {0.5, -0.5}) {
    t.system.state.velocity.back() = {2, v};  // away from the edge where v < 0
    ForceField<2> bare(*t.contacts), field = t.field({.friction = 0.5, .k_t = 40, .eta = 3, .eta_t = 2});
    Evaluation<2> without, with;
    bare.evaluate(t.system, Detail::energies, without);
    field.evaluate(t.system, Detail::energies, with);
    const Vec2 more = with.force.back() - without.force.back();
    EXPECT_GT(without.force.back()[1], 1);  // pulled up, to the edge
    EXPECT_NEAR(more[0], 0, 1e-12);
    EXPECT_NEAR(more[1], v > 0 ? -3 * v : 0, 1e-12);
    EXPECT_EQ(with.trial_touch.at(0).state, ContactState::slip);
    EXPECT_NEAR(power(with, t.system.state) - power(without, t.system.state), -with.energy.viscous_power,
                1e-12);
  }
  const DiscLaw discs{{k, 0, 2, 0}, {}, Tensile{}, 0.5};
  EXPECT_EQ(respond_contact(Adhesive(w), discs, {1.2, 1, 0, 1, 0.01}, 0.1).tangential.force, 0);
  EXPECT_LT(respond_contact(Adhesive(w), discs, {1.2, 1, 0, 1, 0.01}, 0.1).elastic, 0);
}

/// The normal of a touch points away from the body whether it pushes or pulls, so that the elongation of a
/// pair that is drawn apart goes on with the same sign.
TEST(AdhesiveLaw, NormalOfATouchPointsOutwardAlsoWhereItPulls) {
  for (const double height : {0.96, 1.3}) {  // contact is at 1.2
    Touching t = touching<SmoothContacts>("", square, {1.5, -height}, Toucher::disc);
    t.contacts = std::make_shared<SmoothContacts>(sticky(100));
    t.system.state.velocity.back() = {2, 0};
    ForceField<2> field = t.field({.friction = 1e9, .eta_t = 2});
    Evaluation<2> out;
    field.evaluate(t.system, Detail::energies, out);
    EXPECT_EQ(out.force.back()[0] < -1, height < 1.2);
    const auto contacts = site_contacts(t.system, t.contacts->records(t.system), t.contacts->laws());
    ASSERT_EQ(contacts.size(), 1u);
    EXPECT_NEAR(contacts[0].normal_force(), 100 * (1.2 - height), 1e-9);
    // It would take energy to open, either way; a contact that only pushes leaves its body free.
    EXPECT_EQ(find_rattlers(t.system, contacts)[1], 0);
  }
}

TEST(AdhesiveLaw, LinksOfDiscsHaveNoWell) {
  const DiscLaw law{{k, 0, 0, 0}, {k, 0, 0, 0}, Tensile{}};
  EXPECT_NEAR(elastic_energy(Adhesive(w), law, 0.9, 1, true), 0.5 * k * 0.01, 1e-15);
  EXPECT_NEAR(elastic_energy(Adhesive(w), law, 1.1, 1, true), 0.5 * k * 0.01, 1e-15);
  EXPECT_LT(elastic_energy(Adhesive(w), law, 1.1, 1, false), 0);
}

}  // namespace
}  // namespace supple
