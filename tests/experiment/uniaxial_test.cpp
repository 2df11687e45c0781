#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "supple/core/error.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/experiment/packing_record.hpp"
#include "supple/model/bodies.hpp"
#include "supple/observe/wall_forces.hpp"

namespace supple {
namespace {

Case small_box(const std::string& family = "shell", const std::string& contact = "rough") {
  Case c;
  c.general.experiment = "uniaxial_compression";
  c.bodies.family = family;
  c.bodies.count = 12;
  c.bodies.vertices = 10;
  c.contact.kind = contact;
  c.uniaxial.step = 0.04;
  resolve_family(c);
  return c;
}

TEST(UniaxialCompression, ParticlesBeginBetweenTheWalls) {
  for (const char* family : {"shell", "disc", "rough_disc"}) {
    Packing<2> p = make_boxed_packing(small_box(family), nullptr, 0.5, 1.5);
    const State<2>& s = p.system.state;
    const Vec2 length = p.system.box.length;
    EXPECT_NEAR(length[gradient] / length[flow], 1.5, 1e-12);
    EXPECT_NEAR(covered_fraction(p), 0.5, 1e-9) << family;
    for (int i = 0; i < s.size(); ++i)
      for (int d = 0; d < 2; ++d) {
        EXPECT_GE(s.position[i][d], s.radius[i]) << family;
        EXPECT_LE(s.position[i][d], length[d] - s.radius[i]) << family;
      }
    EXPECT_TRUE(report_packing(p).evaluation.wall.empty()) << family;
  }
}

struct Kind {
  const char *family, *contact;
};

class UniaxialCompressionOf : public ::testing::TestWithParam<Kind> {};

TEST_P(UniaxialCompressionOf, WallsBearTheStress) {
  const Case c = small_box(GetParam().family, GetParam().contact);
  MemoryRecorder recorder;
  run(c, nullptr, recorder);
  EXPECT_TRUE(recorder.warnings.empty()) << recorder.warnings.front();
  const auto& table = recorder.tables.at("packing");
  const auto column = [&](const char* name) { return table.column(name); };
  const std::vector<double> lid = column("wall_force"), floor = column("floor_force"),
                            syy = column("stress_yy");
  ASSERT_EQ(lid.size(), 6u);
  EXPECT_NEAR(column("strain").back(), 0.2, 1e-12);
  EXPECT_GT(column("pressure").front(), c.uniaxial.pressure);
  EXPECT_LT(column("pressure").front(), 1.01 * c.uniaxial.pressure);
  EXPECT_GT(lid.back(), 5 * lid.front());
  const double width = recorder.last_system.box.length[flow],
               unit = recorder.get("constants", "pressure_unit");
  for (std::size_t k = 0; k < lid.size(); ++k) {
    EXPECT_NEAR(lid[k], floor[k], 1e-4 * lid[k]);
    EXPECT_NEAR(lid[k] / width / unit, syy[k], 1e-4 * syy[k]);
  }
}

/// The work on the upper wall is what the packing stores: dU/d(height) = -force, over states in equilibrium.
TEST_P(UniaxialCompressionOf, TheWallDoesTheWorkThatIsStored) {
  Case c = small_box(GetParam().family, GetParam().contact);
  c.minimise.force_tolerance = 1e-9;
  Packing<2> p = make_boxed_packing(c, nullptr, 0.6, 1);
  scale_cell(p.system, {0.8, 0.8});
  p.field->invalidate();
  ASSERT_TRUE(relax(p).converged);
  const double force = sum_wall_forces(report_packing(p).evaluation.wall).lid, change = 2e-6;
  ASSERT_GT(force, 1e-3);
  const auto energy = [&](double height_change) {
    Packing<2> q = p;
    q.system.box.length[gradient] += height_change;
    q.field->invalidate();
    EXPECT_TRUE(relax(q).converged);
    return observe(q).energy;
  };
  EXPECT_NEAR(-(energy(change) - energy(-change)) / (2 * change), force, 1e-5 * force);
}

INSTANTIATE_TEST_SUITE_P(Kinds, UniaxialCompressionOf,
                         ::testing::Values(Kind{"shell", "rough"}, Kind{"shell", "smooth"},
                                           Kind{"disc", "rough"}),
                         [](const auto& one) {
                           return std::string(one.param.contact) + "_" + one.param.family;
                         });

TEST(UniaxialCompression, DiscsOverlapAndShellsFormFacets) {
  const auto last = [](const char* family, const char* contact) {
    MemoryRecorder recorder;
    run(small_box(family, contact), nullptr, recorder);
    return recorder;
  };
  const MemoryRecorder shells = last("shell", "smooth"), discs = last("disc", "rough");
  EXPECT_LT(shells.get("results", "overlap_area"), 0.005);
  EXPECT_GT(discs.get("results", "overlap_area"), 0.02);
  EXPECT_EQ(discs.get("results", "contact_length"), 1);
  const std::vector<double> length = shells.tables.at("packing").column("contact_length");
  EXPECT_GT(length.back(), 1.3 * length.front());
}

TEST(UniaxialCompression, GoesOnFromABoxAndRefusesAPeriodicCell) {
  Case c = small_box();
  c.uniaxial.strain = 0.08;
  MemoryRecorder first, second;
  run(c, nullptr, first);
  InitialState state;
  state.system = first.last_system;
  system_of<2>(state).state.velocity.assign(first.last_system.state.position.size(), {1, 1});
  run(c, &state, second);
  EXPECT_EQ(second.last_system.state.velocity.front(), Vec2{});
  const auto& before = first.tables.at("packing");
  const auto& after = second.tables.at("packing");
  EXPECT_NEAR(after.column("wall_force").front(), before.column("wall_force").back(),
              1e-4 * before.column("wall_force").back());
  EXPECT_EQ(after.column("strain").front(), 0);
  system_of<2>(state).box.periodic = {true, true};
  EXPECT_THROW(run(c, &state, second), Error);
}

TEST(UniaxialCompression, EndsWhereAMinimisationDoesNotConverge) {
  Case c = small_box();
  c.uniaxial.pressure = 0;  // or the squeeze before would end first
  c.minimise.max_evaluations = 5;
  MemoryRecorder recorder;
  try {
    run(c, nullptr, recorder);
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::numerics);
    EXPECT_THAT(e.what(), ::testing::HasSubstr("raise minimise.max_evaluations"));
  }
  EXPECT_GT(recorder.last_system.state.size(), 0);
}

}  // namespace
}  // namespace supple
