/// Cells without shear: periodic ones have no plates; in closed ones the discs at the edge are fixed, at
/// rest.
#include <gtest/gtest.h>

#include "supple/experiment/experiments.hpp"

namespace supple {
namespace {

Case still_case(const std::string& boundary) {
  Case c;
  c.general.experiment = "dynamics";
  c.box.boundary = boundary;
  c.particles.discs = 60;
  c.particles.permanent_links = false;
  c.time.steps = 200;
  c.given = {"box.boundary", "time.steps"};
  return c;
}

int count_fixed(const System<2>& s) {
  int count = 0;
  for (int i = 0; i < s.state.size(); ++i) count += s.state.mobility[i] != Mobility::free;
  return count;
}

TEST(Boundary, APeriodicCellHoldsNoDisc) {
  MemoryRecorder r;
  run(still_case("periodic"), nullptr, r);
  EXPECT_EQ(count_fixed(r.last_system), 0);
}

TEST(Boundary, AClosedCellKeepsItsDiscsAndFixesThoseAtTheEdge) {
  MemoryRecorder r;
  run(still_case("fixed"), nullptr, r);
  const System<2>& s = r.last_system;
  EXPECT_GT(count_fixed(s), 10);
  EXPECT_LT(count_fixed(s), 50);
  double largest = 0;
  for (int i = 0; i < s.state.size(); ++i) {
    for (int d = 0; d < 2; ++d) {
      EXPECT_GT(s.state.position[i][d], 0) << i;
      EXPECT_LT(s.state.position[i][d], s.box.length[d]) << i;
    }
    const bool at_edge = s.state.position[i][0] <= s.state.radius[i] ||
                         s.state.position[i][1] <= s.state.radius[i] ||
                         s.state.position[i][0] >= s.box.length[0] - s.state.radius[i] ||
                         s.state.position[i][1] >= s.box.length[1] - s.state.radius[i];
    EXPECT_EQ(at_edge, s.state.mobility[i] == Mobility::fixed) << i;
    largest = std::max(largest, norm(r.last_evaluation.force[i]) * (s.state.mobility[i] == Mobility::free));
  }
  // Relaxed: what is left on free discs is small beside a contact force of 10 % overlap, k d0 / 10.
  EXPECT_LT(largest, 1e-2 * 3141.6 * 1e-5);
}

TEST(Boundary, AStateTakesTheBoundaryThatTheUserGives) {
  MemoryRecorder free_run, closed;
  run(still_case("periodic"), nullptr, free_run);
  InitialState state;
  state.system = free_run.last_system;
  run(still_case("fixed"), &state, closed);
  EXPECT_FALSE(closed.info.box.periodic[flow]);
  EXPECT_GT(count_fixed(closed.last_system), 5);
}

}  // namespace
}  // namespace supple
