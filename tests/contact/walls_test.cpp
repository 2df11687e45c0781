#include "supple/contact/walls.hpp"

#include "supple/contact/rough_contacts.hpp"
#include "tests/support/field_check.hpp"
#include "tests/support/polygons.hpp"

namespace supple {
namespace {

TEST(Walls, ForceFieldHoldsWhatEveryFieldMust) {
  System<2> system = testing::random_polygons();
  system.box.strain = 0;
  system.box.periodic = {false, false};
  ForceField<2> field = testing::polygon_field(RoughContacts<2>(Harmonic{2}));
  field.set_walls({{4, false}});
  Evaluation<2> out;
  field.evaluate(system, Detail::energies, out);
  ASSERT_GT(out.energy.wall, 0);
  Vec2 from_walls{};
  for (const SiteForce<2>& wall : out.wall) from_walls += wall.force;
  Vec2 net{};
  for (const Vec2& f : out.force) net += f;
  EXPECT_LT(norm(net - from_walls), 1e-11);
}

TEST(Walls, PushBackWhatTouchesAndStandOnlyWhereAsked) {
  System<2> system;
  system.box.length = {10, 10};
  system.box.periodic = {false, false};
  add_disc_body(system, {0.3, 5}, 0.5);
  add_disc_body(system, {9.8, 5}, 0.5);
  add_disc_body(system, {5, -0.1}, 0.5);
  WallLaw<2> walls{{4, false}};
  ForceField<2> field(RoughContacts<2>(Harmonic{1}));
  field.set_walls(walls);
  Evaluation<2> out;
  field.evaluate(system, Detail::energies, out);
  EXPECT_NEAR(out.force[0][0], 4 * 0.2, 1e-14);
  EXPECT_NEAR(out.force[1][0], -4 * 0.3, 1e-14);
  EXPECT_NEAR(out.force[2][1], 4 * 0.6, 1e-14);
  EXPECT_NEAR(out.energy.wall, 2 * (0.04 + 0.09 + 0.36), 1e-14);
  walls.stands[flow][1] = false;
  field.set_walls(walls);
  field.evaluate(system, Detail::energies, out);
  EXPECT_EQ(out.force[1][0], 0);
}

TEST(Floor, SticksUpToCoulombAndIsDraggedBeyond) {
  System<2> system;
  system.box.length = {10, 10};
  system.box.periodic = {false, false};
  add_disc_body(system, {5, 0.4}, 0.5);
  ForceField<2> field(RoughContacts<2>(Harmonic{1}));
  field.set_walls({{4, false}, 0.5, 0.5});
  Evaluation<2> out;
  field.evaluate(system, Detail::energies, out);
  EXPECT_EQ(out.force[0][0], 0);
  field.commit(system, out);
  system.state.position[0][0] = 5.05;  // below mu N / k_t = 0.5 * 0.4 / 2 = 0.1
  field.evaluate(system, Detail::energies, out);
  EXPECT_NEAR(out.force[0][0], -0.1, 1e-14);
  field.commit(system, out);
  system.state.position[0][0] = 5.3;
  field.evaluate(system, Detail::energies, out);
  EXPECT_NEAR(out.force[0][0], -0.2, 1e-14);
  field.commit(system, out);
  system.state.position[0][0] = 5.2;  // now stuck at 5.2, without force
  field.evaluate(system, Detail::energies, out);
  EXPECT_NEAR(out.force[0][0], 0, 1e-14);
  system.state.position[0][1] = 0.6;  // lifted: forgets
  field.evaluate(system, Detail::energies, out);
  field.commit(system, out);
  EXPECT_TRUE(std::isnan(system.floor_contact[0]));
}

}  // namespace
}  // namespace supple
