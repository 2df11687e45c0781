/// Frames of bodies: sites, the cell, and one row for each pair of sites that touch.
#include "supple/experiment/frame.hpp"

#include <gtest/gtest.h>

#include "supple/contact/rough_contacts.hpp"
#include "supple/contact/smooth_contacts.hpp"
#include "supple/model/discs.hpp"
#include "tests/support/polygons.hpp"

namespace supple {
namespace {

using namespace supple::testing;

/// Each row's force on its second site, along the line of the two (rough contacts).
std::vector<Vec2> forces_of_rows(const System<2>& system, const Frame<2>& frame) {
  std::vector<Vec2> force(frame.position.size());
  for (const ContactRow<2>& row : frame.contacts) {
    const Vec2 r = system.box.displacement(frame.position[row.first], frame.position[row.second]);
    const Vec2 push = (row.normal_force / norm(r)) * r;
    force[row.first] -= push;
    force[row.second] += push;
  }
  return force;
}

void expect_ascending(const std::vector<ContactRow<2>>& rows) {
  for (std::size_t k = 1; k < rows.size(); ++k)
    EXPECT_LT(std::pair(rows[k - 1].first, rows[k - 1].second), std::pair(rows[k].first, rows[k].second));
}

TEST(Frame, OfPolygons) {
  System<2> system = random_polygons();
  system.step = 7;
  system.time = 0.5;
  system.box.strain_rate = 0.25;
  ForceField<2> field(RoughContacts<2>(Harmonic{3, true}));
  Evaluation<2> evaluation;
  field.evaluate(system, Detail::forces, evaluation);
  const Frame<2> frame =
      make_frame(system, evaluation, field.bodies()->records(system), field.bodies()->laws());
  EXPECT_EQ(frame.step, 7);
  EXPECT_EQ(frame.time, 0.5);
  EXPECT_EQ(frame.strain, system.box.strain);
  EXPECT_EQ(frame.strain_rate, 0.25);
  EXPECT_EQ(frame.length, system.box.length);
  EXPECT_EQ(frame.position, system.state.position);
  EXPECT_EQ(frame.force, evaluation.force);
  ASSERT_GT(frame.contacts.size(), 9u);
  for (std::size_t k = 0; k < frame.contacts.size(); ++k) {
    const ContactRow<2>& row = frame.contacts[k];
    EXPECT_LT(row.first, row.second);
    EXPECT_EQ(row.state, ContactState::slip);
    EXPECT_EQ(row.tangential_force, 0);
  }
  expect_ascending(frame.contacts);
  const std::vector<Vec2> force = forces_of_rows(system, frame);
  for (std::size_t i = 0; i < force.size(); ++i) EXPECT_LT(norm(force[i] - evaluation.force[i]), 1e-13);
}

TEST(Frame, RowsOfSmoothContactsAscend) {
  System<2> system = random_polygons();
  ForceField<2> field(SmoothContacts(Harmonic{}));
  Evaluation<2> evaluation;
  field.evaluate(system, Detail::forces, evaluation);
  const Frame<2> frame =
      make_frame(system, evaluation, field.bodies()->records(system), field.bodies()->laws());
  ASSERT_GT(frame.contacts.size(), 9u);
  expect_ascending(frame.contacts);
}

/// Corner on corner: each acts on the other's boundary with half of the law.
TEST(Frame, CornersHeadOnAreOneRow) {
  System<2> system;
  system.box.length = {10, 10};
  const std::vector<double> four(4, 1);
  add_ring(system, {{3, 5}, {4, 4}, {5, 5}, {4, 6}}, 0.5, {}, 1, four, four);
  add_ring(system, {{5.9, 5}, {7, 4}, {8, 5}, {7, 6}}, 0.5, {}, 1, four, four);
  ForceField<2> field(SmoothContacts(Harmonic{3, false}));
  Evaluation<2> evaluation;
  field.evaluate(system, Detail::forces, evaluation);
  const Frame<2> frame =
      make_frame(system, evaluation, field.bodies()->records(system), field.bodies()->laws());
  ASSERT_EQ(frame.contacts.size(), 1u);
  EXPECT_EQ(frame.contacts[0].first, 2);
  EXPECT_EQ(frame.contacts[0].second, 4);
  EXPECT_NEAR(frame.contacts[0].normal_force, 0.3, 1e-14);
  EXPECT_NEAR(evaluation.force[2][0], -0.3, 1e-14);
}

TEST(Frame, RunInfoSaysWhichSitesFormABody) {
  System<2> bodies = random_polygons();
  add_disc_body(bodies, {1, 1}, 1);
  const RunInfo<2> info = make_run_info(bodies, reduced_units());
  EXPECT_EQ(info.body_begin, bodies.topology.begin);
  EXPECT_EQ(info.particle, bodies_of_sites(bodies.topology, bodies.state.size()));
  EXPECT_EQ(info.particle.back(), 9);

  const System<2> discs = listed_discs(bodies.box, {{1, 1}, {5, 5}}, {1, 1}, 1);
  EXPECT_TRUE(make_run_info(discs, si_units()).body_begin.empty());
  EXPECT_EQ(make_run_info(discs, si_units()).particle, (std::vector<std::int32_t>{0, 1}));
  Evaluation<2> none;
  EXPECT_EQ(make_frame(discs, none).length, discs.box.length);
}

}  // namespace
}  // namespace supple
