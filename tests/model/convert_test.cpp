#include "supple/model/convert.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "supple/contact/rough_contacts.hpp"
#include "supple/core/error.hpp"
#include "supple/model/rigid.hpp"
#include "supple/observe/summary.hpp"
#include "tests/support/polygons.hpp"

namespace supple::testing {
namespace {

const Units other{"other", 3, 5, 7};

/// Deformable and rigid polygons that move.
System<2> moving() {
  System<2> system = random_polygons();
  for (int i = 0; i < system.state.size(); ++i)
    system.state.velocity[i] = {0.1 * std::sin(i), 0.2 * std::cos(i)};
  make_rigid(system, 1);
  system.rigid.spin[0] = 0.3;
  place_sites(system);
  return system;
}

double shape_energy(const System<2>& system) {
  ForceField<2> field = polygon_field(RoughContacts<2>(Harmonic{}));
  Evaluation<2> evaluation;
  System<2> copy = system;
  field.evaluate(copy, Detail::energies, evaluation);
  return evaluation.energy.terms;
}

TEST(Convert, EnergiesOfShapesAndMotionAreThoseOfTheOtherUnits) {
  const System<2> before = moving();
  System<2> after = before;
  convert(after, si_units(), other);
  const double factor = 1 / other.of(unit::energy);
  const double moved = kinetic_energy(after).total();
  EXPECT_NEAR(moved, factor * kinetic_energy(before).total(), 1e-14 * moved);
  EXPECT_NEAR(shape_energy(after), factor * shape_energy(before), 1e-12 * shape_energy(after));
  EXPECT_GT(shape_energy(before), 0);
}

TEST(Convert, RigidParticlesStayWhereTheirSitesAre) {
  System<2> system = moving();
  convert(system, si_units(), other);
  const std::vector<Vec2> where = system.state.position;
  place_sites(system);
  for (std::size_t i = 0; i < where.size(); ++i) EXPECT_LT(norm(system.state.position[i] - where[i]), 1e-14);
}

TEST(Convert, FloorAndMemoryOfContactsAreLengths) {
  System<2> system = random_polygons();
  system.floor_contact.assign(static_cast<std::size_t>(system.state.size()), 6.0);
  system.touches.rows = {{{3, 40, TouchOn::site, {}}, ContactState::stick, 9}};
  system.links = {{2, 30, {}, 12, 15}};
  convert(system, si_units(), other);
  EXPECT_EQ(system.floor_contact[0], 2);
  EXPECT_EQ(system.touches.rows[0].elongation, 3);
  EXPECT_EQ(system.touches.rows[0].key.other, 40);
  EXPECT_EQ(system.links[0].rest, 4);
  EXPECT_EQ(system.links[0].elongation, 5);
}

TEST(Convert, TermsOfWholeBodiesHaveNoUnits) {
  System<2> system = random_polygons();
  system.terms = {{"perimeter", 1, {1.0}}};
  EXPECT_THROW(convert(system, si_units(), other), Error);
}

}  // namespace
}  // namespace supple::testing
