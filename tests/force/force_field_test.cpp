/// A force field is a value: copies act on systems of their own.
#include "supple/force/force_field.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "supple/contact/link_forces.hpp"
#include "supple/contact/rough_contacts.hpp"
#include "supple/contact/smooth_contacts.hpp"
#include "supple/contact/touch_friction.hpp"
#include "supple/core/error.hpp"
#include "supple/core/parallel.hpp"
#include "supple/model/polygons.hpp"
#include "tests/support/polygons.hpp"
#include "tests/support/touching.hpp"

namespace supple {
namespace {

using testing::polygon_field;
using testing::random_polygons;

class ForceFields : public ::testing::TestWithParam<bool> {
 protected:
  ForceField<2> make() const {
    ForceField<2> field = GetParam() ? polygon_field(SmoothContacts(Harmonic{5}))
                                     : polygon_field(RoughContacts<2>(Harmonic{5}));
    field.add(TouchFriction(TouchLaw{0.4, 3, 0.5, 0.3}));
    field.add(LinkForces(LinkLaw{3, 0.2, 2, 0.1}));
    return field;
  }
};
INSTANTIATE_TEST_SUITE_P(RoughAndSmooth, ForceFields, ::testing::Bool());

System<2> stirred(std::uint64_t seed, int bodies) {
  System<2> system = random_polygons({.bodies = bodies, .seed = seed});
  testing::stir(system, seed);
  system.lag = 1e-3;
  return system;
}

std::vector<Vec2> forces_of(ForceField<2>& field, System<2>& system) {
  Evaluation<2> out;
  field.evaluate(system, Detail::energies, out);
  const LossPower power = field.loss_power(system, out);  // of what this evaluation found
  out.force.push_back({power.viscous, power.sliding});
  return out.force;
}

TEST_P(ForceFields, CopiesActOnSystemsOfTheirOwn) {
  System<2> a = stirred(1, 9), b = stirred(2, 9), fresh_a = a, fresh_b = b;
  ForceField<2> first = make(), other = make();
  const std::vector<Vec2> of_a = forces_of(other, fresh_a);
  other = make();
  const std::vector<Vec2> of_b = forces_of(other, fresh_b);

  forces_of(first, a);
  ForceField<2> second = first;
  EXPECT_NE(second.bodies(), first.bodies());
  for (int turn = 0; turn < 3; ++turn) {
    EXPECT_EQ(forces_of(second, b), of_b);
    EXPECT_EQ(forces_of(first, a), of_a);
  }
  Evaluation<2> of_first, of_second;
  first.evaluate(a, Detail::energies, of_first);
  second.evaluate(b, Detail::energies, of_second);
  const LossPower before = first.loss_power(a, of_first);
  second.bodies()->set_laws(Harmonic{7});
  second.evaluate(b, Detail::energies, of_second);
  EXPECT_EQ(first.loss_power(a, of_first).viscous, before.viscous);
  EXPECT_EQ(forces_of(first, a), of_a);
  EXPECT_NE(forces_of(second, b), of_b);
}

TEST_P(ForceFields, GoFromSystemToSystem) {
  ForceField<2> field = make();
  System<2> a = stirred(1, 9), b = stirred(2, 9), c = stirred(3, 4);
  for (int turn = 0; turn < 2; ++turn)
    for (System<2>* system : {&a, &b, &c}) {
      System<2> same = *system;
      same.pairs = {};
      ForceField<2> fresh = make();
      EXPECT_EQ(forces_of(field, *system), forces_of(fresh, same));
    }
}

/// Two discs that overlap by 0.2, across the boundary or not: one row each, of different images.
TEST(BodyContactsOfTwoSystems, AreNotTakenForThoseOfTheOther) {
  const auto pair = [](double x) {
    System<2> s;
    s.box.length = {10, 10};
    add_disc_body(s, {x - 0.4, 5}, 0.5);
    add_disc_body(s, {x > 10 - 0.4 ? x + 0.4 - 10 : x + 0.4, 5}, 0.5);
    return s;
  };
  System<2> inside = pair(5), across = pair(9.8);
  Evaluation<2> out;
  ForceField<2> first(RoughContacts<2>(Harmonic{1})), second = first;
  first.evaluate(inside, Detail::energies, out);
  second.evaluate(across, Detail::energies, out);
  RoughContacts<2> contacts(Harmonic{1});
  for (int turn = 0; turn < 2; ++turn)
    for (System<2>* system : {&inside, &across}) {
      out.force.assign(2, Vec2{});
      contacts.evaluate(*system, Detail::energies, out);
      EXPECT_NEAR(norm(out.force[0]), 0.2, 1e-12);
      ASSERT_EQ(contacts.records(*system).size(), 1u);
      EXPECT_NEAR(contacts.records(*system)[0].gap, -0.2, 1e-12);
    }
}

TEST(ForceField, OfDiscsRefusesForcesBetweenBodies) {
  ForceField<2> discs{DiscContacts()};
  EXPECT_THROW(discs.add(LinkForces(LinkLaw{})), Error);
}

}  // namespace
}  // namespace supple
