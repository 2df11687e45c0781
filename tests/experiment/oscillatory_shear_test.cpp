/// What an oscillatory run measures, whatever its rests, length, frequency and preparation.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "supple/core/error.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/experiment/frame.hpp"
#include "supple/experiment/protocol.hpp"
#include "supple/experiment/suspension.hpp"
#include "supple/model/links.hpp"
#include "tests/support/prepared.hpp"

namespace supple {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

/// One scaffold of a few discs at 2 %.
Case scaffold() {
  Case c;
  c.general.seed = 3;
  c.particles.discs = 40;
  c.particles.cut_lines = 0;
  c.shear.amplitude = 0.02;
  c.shear.periods = 3;
  c.shear.pre_periods = c.shear.post_periods = 0.25;
  c.output.tensors = false;
  return c;
}

MemoryRecorder run_of(const Case& c) {
  MemoryRecorder recorder;
  run(c, nullptr, recorder);
  return recorder;
}

TEST(OscillatoryShear, LossDoesNotDependOnWhereTheShearStops) {
  // 29.87 Pa: an independent fit of the series of such a run. A last quarter of a period made -136 of it
  // once.
  for (const double periods : {2.25, 2.75, 3.0}) {
    Case c = scaffold();
    c.shear.periods = periods;
    c.shear.post_periods = 1;
    const MemoryRecorder recorder = run_of(c);
    EXPECT_NEAR(recorder.get("results", "loss_modulus_internal"), 29.87, 0.2) << periods;
    EXPECT_NEAR(recorder.get("results", "loss_modulus_virial"), 44.9, 0.2) << periods;
  }
}

TEST(OscillatoryShear, LossDoesNotDependOnTheRestBefore) {
  // 0.5 periods are 657.5 of 1315 steps: the phase is that of the step with which the shear begins.
  for (const double pre : {0.0, 0.1, 0.5, 1.7}) {
    Case c = scaffold();
    c.shear.pre_periods = pre;
    EXPECT_NEAR(run_of(c).get("results", "loss_modulus_internal"), 29.87, 0.05) << pre;
  }
}

TEST(OscillatoryShear, EstimatorsThatDoNotDependOnTheCutComeFirst) {
  const MemoryRecorder recorder = run_of(scaffold());
  const auto& results = recorder.values.at("results");
  EXPECT_EQ(results.front().name.name, "storage_modulus_plates");
  std::vector<std::string> order;
  for (const auto& v : results)
    if (v.name.name.starts_with("storage_modulus_")) order.push_back(v.name.name.substr(16));
  EXPECT_EQ(order, (std::vector<std::string>{"plates", "virial", "periodic", "internal", "external",
                                             "external_corrected"}));
}

TEST(OscillatoryShear, PlateForceIsTheStressOfTheGapAtLowFrequency) {
  // Force balance of a slab at rest: the plates carry what the sample does, and their thickness is what the
  // virial over the whole cell lacks. The plates of a cell without any are not there.
  Case c = scaffold();
  c.shear.relative_frequency = 0.006;
  const MemoryRecorder recorder = run_of(c);
  const MemoryRecorder::Table& stress = recorder.tables.at("stress");
  const std::vector<double> plates = stress.column("shear_stress_plates"),
                            virial = stress.column("shear_stress_virial");
  double most = 0;
  for (const double s : plates) most = std::max(most, std::abs(s));
  const double ratio =
      recorder.get("results", "storage_modulus_plates") / recorder.get("results", "storage_modulus_virial");
  EXPECT_GT(ratio, 1.1);  // two layers of about a radius of 14 % of the height
  EXPECT_LT(ratio, 1.35);
  for (std::size_t i = 0; i < plates.size(); i += 50)
    EXPECT_NEAR(plates[i] - plates[0], ratio * (virial[i] - virial[0]), 0.02 * most);

  c.box.plates = "none";
  const MemoryRecorder without = run_of(c);
  EXPECT_ANY_THROW(without.get("results", "storage_modulus_plates"));
  EXPECT_EQ(without.values.at("results").front().name.name, "storage_modulus_virial");
}

TEST(OscillatoryShear, WarnsNearTheResonanceOfTheGapAndNotFarBelow) {
  Case c = scaffold();
  EXPECT_THAT(run_of(c).warnings, Not(Contains(HasSubstr("gaps long"))));
  c.shear.relative_frequency = 0.2;
  EXPECT_THAT(run_of(c).warnings, Contains(HasSubstr("gaps long")));
}

TEST(OscillatoryShear, CheckTellsTheWavelength) {
  // c^2 = G/rho with G = sqrt(3)/4 (k + k_t), k = k_t = pi/8 E, rho = 1.5 times 1000 kg/m^3, H = 500 um.
  const Case c;
  double waves = 0, frequency = 0;
  for (const Derived& d : derive(c, nullptr)) {
    if (d.name.name == "wavelength_over_gap_of_scaffold") waves = d.value;
    if (d.name.name == "frequency") frequency = d.value;
  }
  const double g = std::numbers::sqrt3 / 4 * 2 * std::numbers::pi / 8 * 8000;
  EXPECT_NEAR(waves, std::sqrt(g / 1500) / (frequency * 500e-6), 1e-9);
}

TEST(OscillatoryShear, MoreThan2To31StepsInAPeriod) {
  Case c = scaffold();
  c.shear.relative_frequency = 3e-9;
  double steps = 0;
  for (const Derived& d : derive(c, nullptr))
    if (d.name.name == "steps_per_period") steps = d.value;
  EXPECT_GT(steps, 3e9);
  OscillatoryProtocol p;
  p.amplitude = 0.02;
  p.steps_per_period = 3285911063;
  p.pre_steps = 0;
  p.shear_steps = 3 * p.steps_per_period;
  for (const double periods : {1e-7, 0.1, 0.9, 2.2}) {
    const auto i = static_cast<std::int64_t>(periods * static_cast<double>(p.steps_per_period));
    EXPECT_NEAR(p.strain(i), 0.02 * std::sin(2 * std::numbers::pi * periods), 1e-9) << periods;
    EXPECT_GT(std::abs(p.rates(i).now), 0.01) << periods;
  }
}

TEST(OscillatoryShear, StepsThatNobodyCanCountAreRefused) {
  for (const double frequency : {1e-18, 1e-300}) {
    Case c = scaffold();
    c.shear.relative_frequency = frequency;
    EXPECT_THROW(derive(c, nullptr), Error) << frequency;
  }
}

TEST(OscillatoryShear, LessThanOnePeriodIsRefusedBeforeTheRun) {
  Case c = scaffold();
  c.shear.periods = 0.9;
  EXPECT_THROW(derive(c, nullptr), Error);
}

TEST(OscillatoryShear, AFastOscillationGetsStepsEnoughToBeDemodulated) {
  Case c = scaffold();
  c.shear.relative_frequency = 10;  // four steps of the stability criterion in a period
  for (const Derived& d : derive(c, nullptr)) {
    if (d.name.name == "steps_per_period") {
      EXPECT_GE(d.value, 8);
    }
  }
  EXPECT_GT(run_of(c).get("results", "loss_modulus_virial"), 0);
}

TEST(OscillatoryShear, OneSeedIsOneSampleWhateverTheProtocol) {
  Case c = scaffold();
  c.material.tensile_law =
      "exponential";  // whose stiffness at the largest stretch of the shear limits the step
  const System<2> expected = testing::prepared_suspension(c).system;
  for (const double amplitude : {0.002, 0.5})
    for (const double frequency : {0.001, 0.25}) {
      c.shear.amplitude = amplitude;
      c.shear.relative_frequency = frequency;
      const System<2> found = testing::prepared_suspension(c).system;
      EXPECT_EQ(found.state.position, expected.state.position) << amplitude << " " << frequency;
      EXPECT_EQ(found.pairs.history, expected.pairs.history);
    }
}

TEST(OscillatoryShear, ParticlesAreCountedOverTheBoundary) {
  // Five Voronoi points make five particles; those that lie across a side of the cell are one still.
  Case c;
  c.general.seed = 2;  // a sample where none of the five is a single disc, which would join another
  const Suspension s = testing::prepared_suspension(c);
  const std::vector<std::int32_t> particle = make_run_info(s.system, s.units).particle;
  EXPECT_EQ(1 + *std::max_element(particle.begin(), particle.end()), 5);
}

}  // namespace
}  // namespace supple
