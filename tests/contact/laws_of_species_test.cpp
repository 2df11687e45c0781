/// Laws of contacts that depend on the species that meet.
#include "supple/contact/laws/table.hpp"

#include <gtest/gtest.h>

#include "supple/contact/link_forces.hpp"
#include "supple/core/parallel.hpp"
#include "supple/observe/rattlers.hpp"
#include "supple/solve/time_step.hpp"
#include "tests/support/field_check.hpp"
#include "tests/support/polygons.hpp"
#include "tests/support/touching.hpp"

namespace supple {
namespace {

using namespace testing;

/// Three species, whose pairs repel softly or firmly, by different laws, or adhere.
ContactLaws unlike(bool relative = false) {
  ContactLaws laws = Harmonic{2, relative};
  laws.set(0, 1, {Harmonic{3, relative}, Adhesive(0.35)});
  laws.set(1, 1, Harmonic{0.7, relative});
  laws.set(2, 0, {Harmonic{1.3, relative}, Hertz()});
  return laws;
}

/// Polygons and a disc of three species that touch in all pairs of them.
System<2> mixture(std::uint64_t seed = 1, int bodies = 9) {
  System<2> system = random_polygons({.bodies = bodies, .seed = seed});
  add_disc_body(system, {1.1, 1.3}, 0.6);
  for (int b = 0; b <= bodies; ++b) system.species.push_back(b % 3);
  return system;
}

std::shared_ptr<BodyContacts<2>> contacts_of(bool smooth, const ContactLaws& laws) {
  if (smooth) return std::make_shared<SmoothContacts>(laws);
  return std::make_shared<RoughContacts<2>>(laws);
}

TEST(LawsOfSpecies, TableIsSymmetricAndHasTheCommonLawElsewhere) {
  const ContactLaws laws = unlike();
  EXPECT_EQ(laws.of(0, 1).spring(1), 3);
  EXPECT_EQ(laws.of(1, 0).spring(1), 3);
  EXPECT_EQ(laws.of(0, 2).spring(1), 1.3);
  EXPECT_EQ(laws.of(2, 2).spring(1), 2);
  EXPECT_EQ(laws.of(0, 7).spring(1), 2);  // a species of which nothing is said
  EXPECT_FALSE(laws.is_uniform());
  EXPECT_EQ(widest_range(laws), 1.35);
  EXPECT_EQ(laws.least([](const BodyLaw& law) { return law.spring(1); }), 0.7);
  const ContactLaws doubled = laws.map([](const BodyLaw& law) { return law.stiffer(2); });
  EXPECT_EQ(doubled.of(2, 0).spring(1), 2.6);
  EXPECT_EQ(doubled.of(2, 2).spring(1), 4);
  ContactLaws twice = laws;
  twice.set(1, 0, Harmonic{5});
  EXPECT_EQ(twice.of(0, 1).spring(1), 5);
  EXPECT_EQ(widest_range(twice), 1);
}

TEST(LawsOfSpecies, FieldHoldsWhatEveryFieldMust) {
  for (const bool smooth : {false, true})
    for (const std::uint64_t seed : {1, 2}) {
      SCOPED_TRACE(seed);
      System<2> system = mixture(seed);
      ForceField<2> field = polygon_field(*contacts_of(smooth, unlike(seed == 2)));
      FieldCheck(field, system).run();
    }
}

TEST(LawsOfSpecies, FastLoopsEqualTheirRecords) {
  for (const bool smooth : {false, true}) {
    System<2> system = mixture(3, 30);
    const auto contacts = contacts_of(smooth, unlike());
    ForceField<2> field(*contacts);
    Evaluation<2> fast, slow;
    field.evaluate(system, Detail::energies, fast);
    slow.force.resize(fast.force.size());
    slow.torque.resize(fast.force.size());
    const auto records = contacts->records(system);
    evaluate_conservative(records, contacts->laws(), slow);
    EXPECT_NEAR(fast.energy.elastic, slow.energy.elastic, 1e-12);
    for (std::size_t i = 0; i < fast.force.size(); ++i) EXPECT_LT(norm(fast.force[i] - slow.force[i]), 1e-12);
    EXPECT_NEAR(fast.virial[0][1], slow.virial[0][1], 1e-12);
    // Each contact is under the law of its pair, and no further from contact than that reaches.
    const std::vector<std::int32_t> body = bodies_of_sites(system.topology, system.state.size());
    for (const ContactRecord<2>& r : records) {
      const std::int32_t a = system.species[body[r.site[0]]], b = system.species[body[r.site[1]]];
      EXPECT_TRUE((r.species == std::array{a, b}));
      EXPECT_LT(r.distance(), contacts->laws().of(a, b).range() * r.reach);
    }
    for (const SiteContact<2>& c : site_contacts(system, records, contacts->laws()))
      EXPECT_EQ(c.holds, system.species[c.body] + system.species[c.other_body] == 1);
  }
}

TEST(LawsOfSpecies, EqualLawsGiveTheBitsOfOneLaw) {
  for (const bool smooth : {false, true}) {
    System<2> system = mixture(4, 30);
    ContactLaws same = Harmonic{2};
    for (int a = 0; a < 3; ++a) same.set(a, 2, Harmonic{2});
    Evaluation<2> one, each;
    ForceField<2>(*contacts_of(smooth, Harmonic{2})).evaluate(system, Detail::energies, one);
    ForceField<2>(*contacts_of(smooth, same)).evaluate(system, Detail::energies, each);
    EXPECT_EQ(one.force, each.force);
    EXPECT_EQ(one.energy.elastic, each.energy.elastic);
    for (int i = 0; i < 4; ++i) EXPECT_EQ(one.virial[i / 2][i % 2], each.virial[i / 2][i % 2]);
    // The order in which a pair is named does not matter, either.
    ContactLaws turned = Harmonic{2};
    turned.set(1, 0, {Harmonic{3}, Adhesive(0.35)});
    turned.set(1, 1, Harmonic{0.7});
    turned.set(0, 2, {Harmonic{1.3}, Hertz()});
    ForceField<2>(*contacts_of(smooth, unlike())).evaluate(system, Detail::energies, one);
    ForceField<2>(*contacts_of(smooth, turned)).evaluate(system, Detail::energies, each);
    EXPECT_EQ(one.force, each.force);
  }
}

TEST(LawsOfSpecies, GiveTheSameBitsForOneAndTwoThreads) {
  System<2> system = mixture(5, 120);
  const int before = thread_count();
  Evaluation<2> one, two;
  thread_count() = 1;
  ForceField<2>(*contacts_of(false, unlike())).evaluate(system, Detail::energies, one);
  thread_count() = 2;
  ForceField<2>(*contacts_of(false, unlike())).evaluate(system, Detail::energies, two);
  thread_count() = before;
  EXPECT_EQ(one.force, two.force);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(one.virial[i / 2][i % 2], two.virial[i / 2][i % 2]);
}

/// Two particles at a distance of their surfaces, each of any species: U and F of the closed form.
TEST(LawsOfSpecies, TwoUnlikeParticlesAreThoseOfTheClosedForm) {
  constexpr double d = 0.9, far = 1.2;
  ContactLaws laws = Harmonic{2};
  laws.set(0, 1, {Harmonic{3}, Adhesive(0.3)});
  laws.set(1, 1, Harmonic{0.5});
  for (const bool smooth : {false, true})
    for (const bool on_edge : {false, true}) {
      if (on_edge && !smooth) continue;
      for (std::int32_t a = 0; a < 2; ++a)
        for (std::int32_t b = 0; b < 2; ++b)
          for (const double at : {d, far}) {
            SCOPED_TRACE(::testing::Message() << smooth << on_edge << a << b << " at " << at);
            System<2> system;
            system.box.length = {60, 60};
            if (on_edge) add_body(system, {{5, 5}, {15, 5}, {15, 6}, {5, 6}}, 0.5);
            else add_disc_body(system, {10.2, 5}, 0.5);
            add_disc_body(system, {10.2, 5 - at}, 0.5);
            system.species = {a, b};
            ForceField<2> field(*contacts_of(smooth, laws), 1e-9);
            Evaluation<2> out;
            field.evaluate(system, Detail::energies, out);
            const bool sticky = a + b == 1;
            const double k = sticky ? 3 : a == 0 ? 2 : 0.5;
            // (k/2)(1 - d)^2 - k w^2/4, F = k (1 - d); pulled at 1.2 with -k (1.3 - d), U = -(k/2)(1.3 - d)^2
            double u = 0.5 * k * (1 - d) * (1 - d) - (sticky ? k * 0.09 / 4 : 0), f = k * (1 - d);
            if (at == far) u = sticky ? -0.5 * k * 0.01 : 0, f = sticky ? -k * 0.1 : 0;
            EXPECT_NEAR(out.energy.elastic, u, 1e-13);
            EXPECT_NEAR(out.force.back()[1], -f, 1e-13);
            EXPECT_NEAR(out.virial[1][1], f * at, 1e-12);
          }
    }
}

/// A disc that is dragged over a boundary slips at mu F_n of its own pair.
TEST(LawsOfSpecies, FrictionIsThatOfThePair) {
  for (Touching& t : all_touchings()) {
    SCOPED_TRACE(t.name);
    stir(t.system, 3);
    const TouchLaw common{.friction = 0.5, .k_t = 40, .eta = 3, .eta_t = 2},
        own{.friction = 0.1, .k_t = 20, .eta = 1, .eta_t = 1};
    LawTable<TouchLaw> laws = common;
    laws.set(0, 1, own);
    const auto evaluate = [&](const LawTable<TouchLaw>& law, std::vector<std::int32_t> species) {
      System<2> system = t.system;
      system.species = std::move(species);
      system.lag = 0.01;
      ForceField<2> field(*t.contacts);
      field.add(TouchFriction(law));
      Evaluation<2> out;
      field.evaluate(system, Detail::energies, out);
      return out;
    };
    EXPECT_EQ(evaluate(laws, {0, 0}).force, evaluate(common, {}).force);
    EXPECT_EQ(evaluate(laws, {1, 1}).force, evaluate(common, {}).force);
    for (const auto& species : {std::vector{0, 1}, {1, 0}}) {
      const Evaluation<2> out = evaluate(laws, species), alone = evaluate(own, {});
      EXPECT_EQ(out.force, alone.force);
      EXPECT_EQ(out.energy.sliding_power, alone.energy.sliding_power);
      EXPECT_NE(out.force, evaluate(common, {}).force);
    }
  }
}

/// A wound spring is lost when its contact opens: (k_t/2) u^2 of its own pair.
TEST(LawsOfSpecies, ContactThatOpensLosesTheSpringOfThePair) {
  System<2> system;
  system.box.length = {60, 60};
  add_disc_body(system, {5, 5}, 0.5);
  add_disc_body(system, {7, 5}, 0.5);
  const auto contacts = std::make_shared<RoughContacts<2>>(Harmonic{1});
  LawTable<TouchLaw> laws = TouchLaw{.friction = 1, .k_t = 40};
  laws.set(0, 1, {.friction = 1, .k_t = 8});
  for (const auto& [species, k_t] : {std::pair{std::vector{1, 0}, 8.}, {{1, 1}, 40.}}) {
    system.species = species;
    system.touches.rows = {{{1, 0, TouchOn::site, {}}, ContactState::stick, 0.2}};
    system.lag = 0.5;
    ForceField<2> field(*contacts);
    field.add(TouchFriction(laws));
    Evaluation<2> out;
    field.evaluate(system, Detail::energies, out);
    EXPECT_NEAR(out.energy.sliding_power, 0.5 * k_t * 0.04 / 0.5, 1e-13);
  }
}

TEST(LawsOfSpecies, EnergyOfUnlikeParticlesThatRubGoesWhereTheBooksSay) {
  for (const bool smooth : {false, true}) {
    Touching t = smooth ? touching<SmoothContacts>("", regular(12, 2), {2.9, 0.6}, Toucher::vertex)
                        : touching<RoughContacts<2>>("", regular(12, 2), {2.9, 0.6}, Toucher::vertex);
    t.system.species = {0, 1};
    ContactLaws elastic = Harmonic{3000};
    elastic.set(0, 1, Harmonic{200});
    t.contacts = contacts_of(smooth, elastic);
    System<2> system = t.system;
    for (int i = 0; i < system.state.size(); ++i) system.state.mass[i] = system.state.inertia[i] = 1;
    for (int i = system.topology.begin[1]; i < system.state.size(); ++i)
      system.state.velocity[i] = {-0.6, 0.8};
    LawTable<TouchLaw> rub = TouchLaw{5, 900, 0, 0};
    rub.set(1, 0, {0.3, 50, 0.3, 0.2});
    ForceField<2> field(*t.contacts);
    field.add(TouchFriction(rub));
    const EnergyCheck coarse = check_energy(system, field, 4e-4, 0.6),
                      fine = check_energy(system, field, 5e-5, 0.6);
    EXPECT_GT(fine.lost, 0.005);
    EXPECT_LT(fine.error, 1e-3 * fine.lost);
    EXPECT_LT(fine.error, 0.5 * coarse.error);
  }
}

TEST(LawsOfSpecies, LinkIsThatOfThePair) {
  System<2> system;
  system.box.length = {60, 60};
  add_disc_body(system, {5, 5}, 0.5);
  add_disc_body(system, {6.2, 5}, 0.5);
  system.links = {{0, 1, {}, 1}};
  LawTable<LinkLaw> laws = LinkLaw{100};
  laws.set(0, 1, {7});
  for (const auto& [species, k] :
       {std::pair{std::vector{0, 1}, 7.}, {{1, 0}, 7.}, {{0, 0}, 100.}, {{1, 1}, 100.}}) {
    system.species = species;
    ForceField<2> field(RoughContacts<2>(Harmonic{1}));
    field.add(LinkForces(laws));
    Evaluation<2> out;
    field.evaluate(system, Detail::energies, out);
    EXPECT_NEAR(out.force[0][0], k * 0.2, 1e-12);
    EXPECT_NEAR(out.energy.elastic, 0.5 * k * 0.04, 1e-12);
  }
}

/// A stiff pair decides on the step, whichever pairs touch at present.
TEST(LawsOfSpecies, StiffestPairBoundsTheStep) {
  System<2> system;
  system.box.length = {60, 60};
  add_disc_body(system, {5, 5}, 0.5);
  add_disc_body(system, {15, 5}, 0.5);
  system.species = {0, 1};
  ForceField<2> soft(RoughContacts<2>(Harmonic{1}));
  ContactLaws laws = Harmonic{1};
  laws.set(0, 1, Harmonic{400});
  ForceField<2> stiff(RoughContacts<2>{laws});
  EXPECT_NEAR(frequency_bound(system, stiff), 20 * frequency_bound(system, soft), 1e-9);
}

}  // namespace
}  // namespace supple
