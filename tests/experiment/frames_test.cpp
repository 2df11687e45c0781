/// When frames are kept, and what they say.
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "supple/experiment/experiments.hpp"
#include "supple/experiment/frame_schedule.hpp"
#include "tests/io/continued_run.hpp"

namespace supple::testing {
namespace {

std::vector<int> kept(int last, int frames) {
  FrameSchedule schedule(last, frames);
  std::vector<int> out;
  for (int k = 0; k <= last; ++k)
    if (schedule.due(k)) out.push_back(k);
  return out;
}

TEST(FrameSchedule, KeepsAsManyAsAskedWithBothEnds) {
  for (const int last : {1, 7, 99, 100, 1000})
    for (const int frames : {1, 2, 3, 30, 51, 100}) {
      const std::vector<int> k = kept(last, frames);
      EXPECT_EQ(k.size(), static_cast<std::size_t>(std::min(frames, last + 1))) << last << ' ' << frames;
      EXPECT_EQ(k.back(), last);
      if (frames > 1) {
        EXPECT_EQ(k.front(), 0);
      }
    }
  EXPECT_THAT(kept(10, 3), ::testing::ElementsAre(0, 5, 10));
  EXPECT_THAT(kept(0, 5), ::testing::ElementsAre(0));
}

MemoryRecorder recorded(const std::string& text) {
  MemoryRecorder recorder;
  run(case_of(text), nullptr, recorder);
  return recorder;
}

std::string dynamics(int steps, const std::string& output = "") {
  return "experiment = \"dynamics\"\n[particles]\nN = 24\ncut_lines = 0\n[material]\nfriction = "
         "0.3\n[shear]\nrate = \"1000\"\n"
         "[time]\nsteps = " +
         std::to_string(steps) + "\n[output]\n" + output;
}

/// 34 frames for 30, 100 for 51, and never the last instant.
TEST(Frames, OfDynamicsAreAsManyAsAskedAndEndWithTheLastInstant) {
  for (const int frames : {1, 30, 51}) {
    const MemoryRecorder r = recorded(dynamics(100, "frames = " + std::to_string(frames) + "\n"));
    ASSERT_EQ(r.frames.size(), static_cast<std::size_t>(frames));
    EXPECT_EQ(r.frames.back().step, 100);
    if (frames > 1) {
      EXPECT_EQ(r.frames.front().step, 0);
    }
  }
  EXPECT_EQ(recorded(dynamics(5)).frames.size(), 6u) << "every step unless asked";
  EXPECT_EQ(recorded(dynamics(0)).frames.size(), 1u) << "the given state";
}

/// Contacts: parts add up to the force of each disc; stresses of discs add up to that of all contacts.
TEST(Frames, OfDiscsHoldForcesStressesAndEnergiesThatAddUp) {
  const MemoryRecorder r = recorded(dynamics(40, "frames = 3\n"));
  const RunInfo<2>& info = r.info;
  for (const Frame<2>& f : r.frames) {
    std::vector<Vec2> force(f.position.size());
    double largest = 0;
    for (const ContactRow<2>& c : f.contacts) {
      force[static_cast<std::size_t>(c.first)] += c.force;
      force[static_cast<std::size_t>(c.second)] += -1 * c.force;
      EXPECT_EQ(c.normal_force, c.elastic + c.viscous);
      EXPECT_NEAR(dot(c.force, c.force),
                  c.normal_force * c.normal_force + c.tangential_force * c.tangential_force,
                  1e-12 * dot(c.force, c.force));
      largest = std::max(largest, norm(c.force));
    }
    EXPECT_GT(largest, 0);
    double kinetic = 0;
    Mat2 sum{};
    for (std::size_t i = 0; i < force.size(); ++i) {
      EXPECT_LT(norm(force[i] - f.force[i]), 1e-12 * largest) << i;
      if (f.mobility[i] == Mobility::free) kinetic += 0.5 * info.mass[i] * dot(f.velocity[i], f.velocity[i]);
      kinetic += 0.5 * info.inertia[i] * f.spin[i] * f.spin[i];
      const double area = std::numbers::pi * info.radius[i] * info.radius[i];
      const char* names[2][2] = {{"stress_xx", "stress_xy"}, {"stress_yx", "stress_yy"}};
      for (int a = 0; a < 2; ++a)
        for (int b = 0; b < 2; ++b) sum[a][b] += area * f.body.at(names[a][b])[i];
    }
    const double cell = f.length[0] * f.length[1], scale = std::abs(f.numbers.at("contact_stress_xx"));
    EXPECT_NEAR(sum[0][0] / cell, f.numbers.at("contact_stress_xx"), 1e-10 * scale);
    EXPECT_NEAR(sum[0][1] / cell, f.numbers.at("contact_stress_xy"), 1e-10 * scale);
    EXPECT_NEAR(sum[1][1] / cell, f.numbers.at("contact_stress_yy"), 1e-10 * scale);
    EXPECT_NEAR(f.numbers.at("pressure"), 0.5 * (sum[0][0] + sum[1][1]) / cell, 1e-10 * scale);
    EXPECT_NEAR(f.numbers.at("kinetic_energy"), kinetic, 1e-9 * kinetic);
    EXPECT_GT(f.numbers.at("contact_energy"), 0);
  }
  EXPECT_GT(r.frames.back().numbers.at("tangential_energy"), 0);
}

/// The strain was stored as the time.
TEST(Frames, OfACompressionBetweenWallsHaveTheirStrainByName) {
  const MemoryRecorder r = recorded(
      "experiment = \"uniaxial_compression\"\n[bodies]\nfamily = \"disc\"\nN = 6\n"
      "[uniaxial]\nstrain = 0.1\nstep = 0.01\n[output]\nframes = 6\n");
  ASSERT_EQ(r.frames.size(), 6u);
  for (std::size_t k = 0; k < 6; ++k) {
    EXPECT_NEAR(r.frames[k].numbers.at("uniaxial_strain"), 0.02 * static_cast<double>(k), 1e-12);
    EXPECT_EQ(r.frames[k].time, 0);
    EXPECT_TRUE(r.frames[k].numbers.contains("pressure"));
  }
}

/// The instant at which the wall goes was there twice, in the table and among the frames: ParaView then lost
/// all times.
TEST(Frames, AndRowsOfASlumpHaveEachInstantOnce) {
  const MemoryRecorder r = recorded(
      "experiment = \"slump\"\n[bodies]\nfamily = \"disc\"\nN = 2\n[slump]\nspread_time = 20\n"
      "settle_time = 20\n[output]\nframes = 8\n");
  const std::vector<double> t = r.tables.at("motion").column("time");
  for (std::size_t k = 1; k < t.size(); ++k) EXPECT_GT(t[k], t[k - 1]) << "row " << k;
  ASSERT_GT(r.frames.size(), 2u);
  for (std::size_t k = 1; k < r.frames.size(); ++k)
    EXPECT_GT(r.frames[k].time, r.frames[k - 1].time) << "frame " << k;
}

}  // namespace
}  // namespace supple::testing
