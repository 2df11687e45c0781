#include "supple/contact/rough_contacts.hpp"

#include "supple/core/parallel.hpp"
#include "tests/support/field_check.hpp"
#include "tests/support/polygons.hpp"
#include "tests/support/random_surfaces.hpp"

namespace supple {
namespace {

TEST(RoughContacts, ForceFieldHoldsWhatEveryFieldMust) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    SCOPED_TRACE(seed);
    System<2> system = testing::random_polygons({.seed = seed});
    add_disc_body(system, {1.1, 1.3}, 0.6);
    ForceField<2> field = testing::polygon_field(RoughContacts<2>(Harmonic{2, seed == 2}));
    testing::FieldCheck(field, system).run();
    EXPECT_GT(field.bodies()->records(system).size(), 10u);
  }
}

/// Shaken surfaces and spheres that overlap in a sheared cell.
TEST(RoughContacts, ForceFieldHoldsWhatEveryFieldMustIn3D) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    SCOPED_TRACE(seed);
    System<3> system;
    system.box.length = {3.3, 3.5, 3.7};
    system.box.strain = 0.17;
    RandomStream draw(seed, Purpose::test);
    for (int b = 0; b < 6; ++b)
      testing::add_shaken(system, geodesic_icosahedron(b == 0 && seed == 1 ? 42 : 12),
                          {1.6 * (b % 2), 1.6 * (b / 2 % 2), 1.5 * (b / 4)}, {}, 0.08, draw);
    add_sphere_body(system, {2.5, 2.5, 2.6}, 0.7);
    add_sphere_body(system, {0.9, 2.4, 3.4}, 0.6);
    ForceField<3> field(RoughContacts<3>(Harmonic{2, seed == 2}));
    testing::FieldCheck(field, system).run();
    EXPECT_GT(field.bodies()->records(system).size(), 20u);
  }
}

TEST(RoughContacts, FastLoopEqualsItsRecords) {
  System<2> system = testing::random_polygons({.bodies = 30});
  auto contacts = std::make_shared<RoughContacts<2>>(Harmonic{1.5, true});
  ForceField<2> field(*contacts);
  Evaluation<2> fast, slow;
  field.evaluate(system, Detail::energies, fast);
  slow.force.resize(fast.force.size());
  slow.torque.resize(fast.force.size());
  const auto records = contacts->records(system);
  ASSERT_GT(records.size(), 20u);
  evaluate_conservative(records, contacts->laws(), slow);
  EXPECT_NEAR(fast.energy.elastic, slow.energy.elastic, 1e-14 * slow.energy.elastic);
  for (std::size_t i = 0; i < fast.force.size(); ++i) EXPECT_LT(norm(fast.force[i] - slow.force[i]), 1e-13);
  EXPECT_NEAR(fast.virial[0][1], slow.virial[0][1], 1e-13);
}

/// Sites of one body never meet; the nearest image is found however far a body has wandered.
TEST(RoughContacts, SeeOtherBodiesThroughAnyNumberOfCells) {
  System<2> system;
  system.box.length = {8, 8};
  system.box.strain = 0.3;
  add_disc_body(system, {0.2, 0.1}, 0.5);
  add_disc_body(system, {8.0 - 0.3 + 5 * 8 + 3 * 0.3 * 8, 8 * 3.0 + 0.1}, 0.5);
  auto contacts = std::make_shared<RoughContacts<2>>(Harmonic{2});
  ForceField<2> field(*contacts);
  Evaluation<2> out;
  field.evaluate(system, Detail::energies, out);
  EXPECT_NEAR(out.energy.elastic, 0.25, 1e-12);
  EXPECT_NEAR(out.force[0][0], 1, 1e-12);
  EXPECT_NEAR(out.force[1][0], -1, 1e-12);
}

TEST(RoughContacts, GiveTheSameBitsForOneAndTwoThreads) {
  System<2> system = testing::random_polygons({.bodies = 900});
  ForceField<2> field(RoughContacts<2>(Harmonic{1.5, true}));
  Evaluation<2> one, two;
  field.evaluate(system, Detail::energies, one);
  thread_count() = 2;
  ASSERT_GE(chunk_count(system.state.size()), 4);  // or it would not be threaded
  field.evaluate(system, Detail::energies, two);
  thread_count() = 1;
  ASSERT_GT(field.bodies()->records(system).size(), 100u);
  EXPECT_EQ(one.force, two.force);
  EXPECT_EQ(one.energy.elastic, two.energy.elastic);
  EXPECT_EQ(one.virial[0][1], two.virial[0][1]);
}

}  // namespace
}  // namespace supple
