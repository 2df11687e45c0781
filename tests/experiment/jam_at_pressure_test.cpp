/// Where minima of the enthalpy with softened contacts could lead astray.
#include <gtest/gtest.h>

#include "supple/core/error.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/experiment/jam.hpp"
#include "supple/experiment/sound_states.hpp"

namespace supple {
namespace {

Case pressed(const char* family, double pressure, int seed) {
  Case c;
  c.general.experiment = "jamming";
  c.general.seed = seed;
  c.bodies.family = family;
  c.bodies.count = 16;
  c.bodies.vertices = 20;
  c.jamming.packing_fraction = 0.4;
  c.jamming.step = 0.01;
  c.jamming.search = "pressure";
  c.jamming.pressure = pressure;
  resolve_family(c);
  return c;
}

void expect_sound(const Packing<2>& packing, const JamSpec& spec, const JamProgress<2>& end) {
  Packing<2> p = packing;
  const PackingState<2> s = observe(p);
  EXPECT_TRUE(end.last.converged && end.settled);
  EXPECT_TRUE(in_window(spec, s.full_pressure)) << s.full_pressure;
  EXPECT_LT(s.contact_pressure, s.full_pressure);
  EXPECT_TRUE(look_at(p).sound());
}

/// Contacts of a thousandth of their stiffness would let vertices through.
TEST(JamAtPressure, ParticlesStayOutsideOfEachOtherAtHighPressures) {
  for (const double pressure : {1e-4, 1e-3}) {
    const Case c = pressed("shell", pressure, 1);
    Packing<2> packing = make_packing(c, nullptr, c.jamming.packing_fraction);
    expect_sound(packing, jam_spec(c), jam(packing, jam_spec(c)));
  }
}

/// A window that no packing can be in: what is left is a packing from which the root search goes on.
TEST(JamAtPressure, LeavesAPackingToGoOnFromWhereItFails) {
  const Case c = pressed("droplet", 1e-5, 1);
  Packing<2> packing = make_packing(c, nullptr, c.jamming.packing_fraction);
  JamSpec spec = jam_spec(c);
  spec.window = 1e-15;
  JamState<2> state;
  ASSERT_FALSE(jam_at_pressure(packing, spec, state, {}, {}));
  EXPECT_GT(state.progress.minimisations, 10);
  EXPECT_TRUE(look_at(packing).sound());
  EXPECT_LT(observe(packing).contact_pressure, 30 * c.jamming.pressure);
  spec = jam_spec(c);
  spec.search = JamSearch::root;
  expect_sound(packing, spec, jam(packing, spec));
}

TEST(JamAtPressure, AnInterruptedRunKeepsNothingOfSoftContacts) {
  const Case c = pressed("shell", 1e-5, 1);
  Packing<2> packing = make_packing(c, nullptr, c.jamming.packing_fraction);
  const double stiffness = packing.field->bodies()->laws().common().scale().stiffness;
  int soft = 0;
  const auto until_soft = [&](const JamProgress<2>& p) {
    if (packing.field->bodies()->laws().common().scale().stiffness < stiffness) {
      ++soft;
      EXPECT_FALSE(p.settled);
    }
    return soft == 0;
  };
  EXPECT_THROW(jam(packing, jam_spec(c), until_soft), Error);
  EXPECT_EQ(soft, 1);
  EXPECT_EQ(packing.field->bodies()->laws().common().scale().stiffness, stiffness);
  // Nearly a thousand times more if it were the state of contacts of a thousandth.
  EXPECT_LT(observe(packing).contact_pressure, 30 * c.jamming.pressure);
}

/// The stages are rows of the run: contacts yield less from one to the next, and the last are those of the
/// case.
TEST(JamAtPressure, RowsTellOfTheStages) {
  const Case c = pressed("shell", 1e-6, 1);
  MemoryRecorder recorder;
  run(c, nullptr, recorder);
  const MemoryRecorder::Table& rows = recorder.tables.at("packing");
  std::vector<double> pressures, yields;
  for (std::size_t k = 0; k < rows.rows.size(); ++k) {
    const double stiffness = rows.column("contact_stiffness")[k], p = rows.column("pressure")[k];
    if (yields.empty() && stiffness == 1) continue;  // nothing presses yet
    pressures.push_back(p);
    yields.push_back(p / stiffness);
  }
  ASSERT_GE(yields.size(), 5u);
  EXPECT_NEAR(pressures.front(), 1e-3, 1e-5);
  for (std::size_t k = 1; k < yields.size(); ++k) EXPECT_LT(yields[k], 1.01 * yields[k - 1]) << k;
  EXPECT_EQ(rows.column("contact_stiffness").back(), 1);
  EXPECT_NEAR(pressures.back(), 1e-6, 1e-8);
}

/// The first stage is a quarter of the work; a bar that stood at half when particles first press would lie.
TEST(JamAtPressure, TellsHowMuchIsDone) {
  const Case c = pressed("shell", 1e-6, 2);
  Packing<2> packing = make_packing(c, nullptr, c.jamming.packing_fraction);
  double last = 0;
  int first = 0;
  const JamProgress<2> end = jam(packing, jam_spec(c), [&](const JamProgress<2>& p) {
    EXPECT_TRUE(p.share.has_value());
    EXPECT_GE(*p.share, last);
    last = *p.share;
    if (p.state.pressure > 2e-4) {
      ++first;
      EXPECT_LE(*p.share, 0.25);
    }
    return true;
  });
  EXPECT_GT(first, 0);
  EXPECT_GT(*end.share, 0.8);
}

/// Discs that have been compressed by 0.02 of their diameter jam at a packing fraction higher by 0.0065.
TEST(JamAtPressure, DiscsJamWhereARootSearchFindsThem) {
  double sum[2] = {0, 0};
  constexpr int seeds = 40;
  for (int seed = 1; seed <= seeds; ++seed)
    for (const JamSearch search : {JamSearch::pressure, JamSearch::root}) {
      Case c = pressed("disc", 1e-6, seed);
      c.bodies.count = 64;
      Packing<2> packing = make_packing(c, nullptr, c.jamming.packing_fraction);
      JamSpec spec = jam_spec(c);
      spec.search = search;
      jam(packing, spec);
      sum[search == JamSearch::root] += covered_fraction(packing) / seeds;
    }
  EXPECT_NEAR(sum[0], sum[1], 0.002);  // one and a half standard errors of the two means
}

}  // namespace
}  // namespace supple
