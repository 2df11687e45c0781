#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "supple/core/error.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/experiment/heap.hpp"
#include "supple/model/polygons.hpp"

namespace supple {
namespace {

constexpr double friction = 0.1;

/// Twelve octagons, which settle and spread in a second.
Case small_heap(const std::string& contact = "rough") {
  Case c;
  c.general.experiment = "slump";
  c.bodies.count = 12;
  c.bodies.vertices = 8;
  c.contact.kind = contact;
  c.contact.floor_friction = friction;
  c.slump.gravity = 1e-3;
  c.slump.width = 3;
  c.slump.drop_spacing = 1.5;
  c.slump.settle_time = 150;
  c.slump.spread_time = 200;
  c.output.frames = 4;
  resolve_family(c);
  experiment_of(c).complete(c);
  return c;
}

struct Table {
  const MemoryRecorder::Table& table;
  double at(std::size_t row, const std::string& name) const { return table.column(name)[row]; }
  std::size_t rows() const { return table.rows.size(); }
};

/// Each kind of contact is run once.
const MemoryRecorder& run_of(const Case& c) {
  static std::map<std::string, MemoryRecorder> runs;
  const auto [at, is_new] = runs.try_emplace(c.contact.kind);
  if (is_new) run(c, nullptr, at->second);
  return at->second;
}

class Slump : public ::testing::TestWithParam<std::string> {
 protected:
  double result(const std::string& name) const { return recorder_.get("results", name); }
  Table table() const { return {recorder_.tables.at("motion")}; }

  Case heap_ = small_heap(GetParam());
  const MemoryRecorder& recorder_ = run_of(heap_);
};

TEST_P(Slump, TheFloorBearsTheWeightOnceAllIsAtRest) {
  EXPECT_TRUE(recorder_.warnings.empty()) << recorder_.warnings.front();
  EXPECT_LT(result("settled_motion"), heap_.slump.rest);
  EXPECT_LT(result("motion"), heap_.slump.rest);
  EXPECT_NEAR(result("settled_floor_force"), 1, 2e-3);
  EXPECT_NEAR(result("floor_force"), 1, 2e-3);
}

TEST_P(Slump, AtRestForcesAlongTheFloorAddToZero) {
  const Table t = table();
  int walled = 0;
  for (std::size_t k = 0; k < t.rows(); ++k) {
    if (k == 0 || t.at(k, "kinetic_energy") > 2e-9 || t.at(k, "floor_force") == 0) continue;
    EXPECT_NEAR(t.at(k, "left_force") - t.at(k, "right_force") + t.at(k, "drag"), 0, 5e-3) << k;
    walled += t.at(k, "right_force") > 0.01;
  }
  EXPECT_GT(walled, 0);
  EXPECT_EQ(t.at(t.rows() - 1, "right_force"), 0);
}

TEST_P(Slump, SpreadsWhereTheWallStood) {
  EXPECT_LT(result("settled_front"), 1.01 * recorder_.get("constants", "cell_width"));
  EXPECT_GT(result("front"), result("settled_front") + 1);
  EXPECT_GT(result("spread"), 1.1 * result("settled_spread"));
  EXPECT_LT(result("top"), result("settled_top"));
}

TEST_P(Slump, FrictionIsThatOfTheFloorAndBounded) {
  const State<2>& s = recorder_.last_system.state;
  int on_floor = 0, on_side = 0;
  for (const SiteForce<2>& w : recorder_.last_evaluation.wall) {
    const bool side = w.force[gradient] == 0;
    (side ? on_side : on_floor) += 1;
    if (side) EXPECT_LT(s.position[w.site][flow], s.radius[w.site]);
    else EXPECT_LE(std::abs(w.force[flow]), friction * w.force[gradient] * (1 + 1e-12));
  }
  EXPECT_GT(on_floor, 5);
  EXPECT_GT(on_side, 0);
  const Table t = table();
  for (std::size_t k = 0; k < t.rows(); ++k)
    EXPECT_LE(std::abs(t.at(k, "drag")), friction * t.at(k, "floor_force") + 1e-12);
}

/// Before they meet the floor particles fall as one: y = y0 - (g/b) (t - (1 - exp(-b t))/b).
TEST_P(Slump, FallsFreelyAtFirst) {
  const Table t = table();
  const double g = heap_.slump.gravity, b = heap_.motion.damping;
  EXPECT_DOUBLE_EQ(b, std::sqrt(g));
  int checked = 0;
  for (std::size_t k = 1; k < t.rows() && t.at(k, "floor_force") == 0; ++k) {
    const double time = t.at(k, "time"), fallen = g / b * (time - (1 - std::exp(-b * time)) / b);
    EXPECT_NEAR(t.at(0, "height") - t.at(k, "height"), fallen, 1e-6) << k;
    ++checked;
  }
  EXPECT_GT(checked, 1);
}

TEST_P(Slump, SaysNothingOfACellThatIsNotThere) {
  for (const auto& value : recorder_.values.at("results"))
    for (const char* word : {"packing_fraction", "pressure", "stress", "tolerance", "evaluations"})
      EXPECT_EQ(value.name.name.find(word), std::string::npos) << value.name.name;
}

INSTANTIATE_TEST_SUITE_P(Contacts, Slump, ::testing::Values("rough", "smooth"),
                         [](const auto& one) { return one.param; });

/// What a state did before does not matter: its particles fall anew.
TEST(SlumpOfAState, BeginsAtRest) {
  Case c = small_heap();
  c.slump.settle_time = c.slump.spread_time = 2;
  MemoryRecorder first, still, moving;
  run(c, nullptr, first);
  InitialState state;
  state.system = first.last_system;
  run(c, &state, moving);
  EXPECT_EQ(moving.tables.at("motion").column("time").front(), 0);
  EXPECT_EQ(moving.tables.at("motion").column("kinetic_energy").front(), 0);
  for (Vec2& v : system_of<2>(state).state.velocity) v = {};
  system_of<2>(state).time = 0;
  system_of<2>(state).floor_contact.clear();
  run(c, &state, still);
  EXPECT_EQ(moving.last_system.state.position, still.last_system.state.position);
}

/// A disc that bounces with little damping hardly moves at the top of a bounce, where the floor bears
/// nothing.
TEST(SlumpOfADisc, IsNotAtRestInTheAir) {
  Case c;
  c.general.experiment = "slump";
  c.bodies.family = "disc";
  c.bodies.count = 1;
  c.motion.damping = 0.001;
  c.slump.spread_time = 20;
  resolve_family(c);
  MemoryRecorder recorder;
  run(c, nullptr, recorder);
  for (const std::string when : {"settled_", ""})
    if (recorder.warnings.empty()) {
      EXPECT_NEAR(recorder.get("results", when + "floor_force"), 1, 0.01);
    }
  c.slump.settle_time = 400;  // its energy falls by exp(-0.001 t): long enough
  MemoryRecorder longer;
  run(c, nullptr, longer);
  EXPECT_TRUE(longer.warnings.empty());
  EXPECT_NEAR(longer.get("results", "settled_floor_force"), 1, 0.01);
}

/// Three discs as stairs: a slope of one.
TEST(Heap, IsMeasured) {
  System<2> s;
  s.box.length = {10, 10};
  s.box.periodic = {false, false};
  for (int k = 0; k < 3; ++k) add_disc_body(s, {0.5 + k, 2.5 - k}, 0.5);
  ForceField<2> field(DiscContacts{});
  field.external().gravity = {0, -2};
  Evaluation<2> evaluation;
  evaluation.force = {{0, 0}, {0.6, -0.8}, {0, 0.1}};
  evaluation.wall = {{0, {3, 0}}, {1, {-1, 0}}, {2, {-0.5, 6}}, {2, {0, -1}}};
  const Heap h = measure_heap(s, field, evaluation);
  EXPECT_DOUBLE_EQ(h.front, 3);
  EXPECT_DOUBLE_EQ(h.top, 3);
  EXPECT_DOUBLE_EQ(h.spread, 3);
  EXPECT_DOUBLE_EQ(h.height, 1.5);
  EXPECT_NEAR(h.slope, 1, 1e-12);
  EXPECT_DOUBLE_EQ(h.imbalance, 0.5);  // of a weight of 2
  EXPECT_DOUBLE_EQ(6 * h.walls.left, 3);
  EXPECT_DOUBLE_EQ(6 * h.walls.right, 1);
  EXPECT_DOUBLE_EQ(6 * h.walls.floor, 6);
  EXPECT_DOUBLE_EQ(6 * h.walls.lid, 1);
  EXPECT_DOUBLE_EQ(6 * h.walls.drag, -0.5);
}

}  // namespace
}  // namespace supple
