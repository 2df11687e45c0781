#include "supple/contact/smooth_contacts.hpp"

#include "supple/core/parallel.hpp"
#include "tests/support/field_check.hpp"
#include "tests/support/polygons.hpp"
#include "tests/support/probe.hpp"

namespace supple {
namespace {

using namespace testing;

/// Polygons that reach deep into each other, with vertices inside, concave corners and discs. No contact is
/// near a border between regions, where the Hessian jumps.
System<2> crowd(std::uint64_t seed, int bodies = 9) {
  System<2> system = random_polygons({.bodies = bodies, .seed = seed, .spacing = 2.6, .jitter = 0.2});
  add_disc_body(system, {1.3, 1.4}, 0.5);
  add_disc_body(system, {1.9, 1.5}, 0.3);
  return system;
}

TEST(SmoothContacts, ForceFieldHoldsWhatEveryFieldMust) {
  int edges = 0, convex = 0, concave = 0, inside = 0;
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    SCOPED_TRACE(seed);
    System<2> system = crowd(seed);
    auto contacts = std::make_shared<SmoothContacts>(Harmonic{2, seed % 2 == 0});
    ForceField<2> field = polygon_field(*contacts);
    FieldCheck(field, system).run();
    for (const auto& r : contacts->records(system)) {
      edges += r.sites == 3;
      convex += r.sites == 2 && r.multiplicity > 0;
      concave += r.multiplicity < 0;
      inside += r.distance() < 0;
    }
  }
  EXPECT_GT(edges, 100);
  EXPECT_GT(convex, 50);
  EXPECT_GE(concave, 2);
  EXPECT_GE(inside, 2);
}

TEST(SmoothContacts, GiveTheSameBitsForAnyNumberOfThreads) {
  System<2> system = crowd(5, 900);
  for (int k = 0; k < 2000; ++k) add_disc_body(system, {0.5 + 0.61 * (k % 50), 0.4 + 1.3 * (k / 50)}, 0.35);
  ForceField<2> field(SmoothContacts(Harmonic{1.5, true}));
  Evaluation<2> one, more;
  field.evaluate(system, Detail::energies, one);
  const int violations = field.bodies()->feature_violations();
  for (const int threads : {2, 3}) {
    const WithThreads some(threads);
    field.evaluate(system, Detail::energies, more);
    EXPECT_EQ(one.force, more.force);
    EXPECT_EQ(one.energy.elastic, more.energy.elastic);
    for (int i = 0; i < 4; ++i) EXPECT_EQ(one.virial[i / 2][i % 2], more.virial[i / 2][i % 2]);
    EXPECT_EQ(field.bodies()->feature_violations(), violations);
  }
  int discs = 0, edges = 0;
  for (const auto& r : field.bodies()->records(system)) (r.row >= 0 ? discs : edges) += 1;
  EXPECT_GT(discs, 4 * chunk_size);  // or they would not be shared
  EXPECT_GT(edges, 4 * chunk_size);
}

TEST(SmoothContacts, FastLoopEqualsItsRecordsAndItsTouches) {
  System<2> system = crowd(5, 36);
  auto contacts = std::make_shared<SmoothContacts>(Harmonic{1.5, true});
  ForceField<2> field(*contacts);
  Evaluation<2> fast, slow;
  field.evaluate(system, Detail::energies, fast);
  slow.force.resize(fast.force.size());
  slow.torque.resize(fast.force.size());
  const auto records = contacts->records(system);
  ASSERT_GT(records.size(), 100u);
  evaluate_conservative(records, contacts->laws(), slow);
  EXPECT_NEAR(fast.energy.elastic, slow.energy.elastic, 1e-13 * slow.energy.elastic);
  for (std::size_t i = 0; i < fast.force.size(); ++i) EXPECT_LT(norm(fast.force[i] - slow.force[i]), 1e-13);
  for (int c = 0; c < 2; ++c)
    for (int d = 0; d < 2; ++d) EXPECT_NEAR(fast.virial[c][d], slow.virial[c][d], 1e-12);

  double energy = 0;
  std::size_t summed = 0, most = 0;
  for (const BodyTouch<2>& touch : sum_touches(system, records, contacts->laws())) {
    energy += touch.energy;
    summed += touch.records;
    most = std::max<std::size_t>(most, touch.records);
    const int begin = system.topology.begin[touch.body], end = system.topology.begin[touch.body + 1];
    EXPECT_FALSE(begin <= touch.site && touch.site < end) << "a body touches itself";
  }
  EXPECT_NEAR(energy, fast.energy.elastic, 1e-12 * energy);
  EXPECT_EQ(summed, records.size());
  EXPECT_GT(most, 2u) << "no concave corner";
}

TEST(SmoothContacts, PushNoBodyRound) {
  System<2> system = crowd(6, 36);
  ForceField<2> field(SmoothContacts(Harmonic{1}));
  Evaluation<2> out;
  field.evaluate(system, Detail::energies, out);
  EXPECT_NEAR(out.virial[0][1], out.virial[1][0], 1e-12);
  system.box.periodic = {false, false};
  field.invalidate();
  field.evaluate(system, Detail::energies, out);
  double torque = 0, scale = 0;
  for (int i = 0; i < system.state.size(); ++i) {
    torque += cross(system.state.position[i], out.force[i]);
    scale += norm(system.state.position[i]) * norm(out.force[i]);
  }
  EXPECT_GT(scale, 1);
  EXPECT_LT(std::abs(torque), 1e-14 * scale);
}

/// The same bits from a list that has seen many small moves and from a fresh one.
TEST(SmoothContacts, DoNotDependOnWhenTheListWasBuilt) {
  System<2> system = crowd(9, 16);
  ForceField<2> field(SmoothContacts(Harmonic{1}));
  RandomStream draw(9, Purpose::test);
  Evaluation<2> kept, fresh;
  int differ = 0;
  for (int step = 0; step < 300; ++step) {
    for (Vec2& x : system.state.position) x += Vec2{draw.uniform(-0.01, 0.01), draw.uniform(-0.01, 0.01)};
    system.box.strain += 3e-4;
    field.evaluate(system, Detail::energies, kept);
    System<2> copy = system;
    copy.pairs.clear();
    ForceField<2> anew(SmoothContacts(Harmonic{1}));
    anew.evaluate(copy, Detail::energies, fresh);
    ASSERT_EQ(kept.force, fresh.force) << "step " << step;
    ASSERT_EQ(kept.energy.elastic, fresh.energy.elastic);
    ASSERT_EQ(kept.virial[0][1], fresh.virial[0][1]);
    differ += copy.pairs.second != system.pairs.second;
  }
  EXPECT_GT(field.neighbors().builds(), 3);
  EXPECT_LT(field.neighbors().builds(), 100);
  EXPECT_GT(differ, 100) << "the lists were always the same";
}

/// A state that is put back brings the rows of its time, which the list does not have the positions of.
TEST(SmoothContacts, SurviveAStateThatIsPutBack) {
  System<2> system = crowd(9, 16);
  ForceField<2> field(SmoothContacts(Harmonic{1}));
  Evaluation<2> before, after;
  field.evaluate(system, Detail::energies, before);
  const System<2> kept = system;
  for (int times = 0; times < 3; ++times) {
    for (int i = 0; i < system.topology.begin[5]; ++i) system.state.position[i] += Vec2{0.9, 0.4};
    field.evaluate(system, Detail::energies, after);
    ASSERT_NE(before.energy.elastic, after.energy.elastic);
    const std::vector<Vec2> moved = system.state.position;
    const double energy = after.energy.elastic;
    system = kept;
    field.evaluate(system, Detail::energies, after);
    EXPECT_EQ(before.force, after.force);
    system = kept;
    system.state.position = moved;  // where the list was built last, but with the rows of old
    field.evaluate(system, Detail::energies, after);
    EXPECT_EQ(after.energy.elastic, energy);
    system = kept;
  }
}

TEST(SmoothContacts, SeeOtherBodiesThroughAnyNumberOfCells) {
  System<2> system;
  system.box.length = {8, 9};
  system.box.strain = 0.3;
  add_body(system, square, 0.5);
  add_disc_body(system, {1.5 + 5 * 8 - 2 * 0.3 * 9, 3.6 - 2 * 9.0}, 0.5);
  ForceField<2> field(SmoothContacts(Harmonic{2}));
  Evaluation<2> out;
  field.evaluate(system, Detail::energies, out);
  EXPECT_NEAR(out.energy.elastic, 0.16, 1e-12);
  EXPECT_NEAR(out.force[4][1], 0.8, 1e-12);
  EXPECT_NEAR(out.force[2][1] + out.force[3][1], -0.8, 1e-12);
}

}  // namespace
}  // namespace supple
