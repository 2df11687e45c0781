/// Whole runs of the published package: derived numbers, preparation, and the oscillation from a given state.
#include <gtest/gtest.h>

#include <numeric>

#include "supple/compat/particleshear/demodulate.hpp"
#include "supple/compat/particleshear/protocol.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/model/links.hpp"
#include "supple/observe/demodulate.hpp"
#include "supple/observe/stress.hpp"
#include "tests/package/reference.hpp"

namespace supple::testing {
namespace {

nlohmann::json read_run(const std::string& name) {
  return nlohmann::json::parse(read_gzip(reference_path(name + ".json.gz")));
}

/// The case that made the reference runs: all defaults of the package.
Case package_case(const nlohmann::json& run) {
  Case c;
  c.general.physics = "particleshear-1.0.2";
  c.material.density = 50;
  c.particles.discs = run["results"]["args"]["N"];
  c.particles.cut_lines = run["results"]["args"]["cut_lines"];
  c.particles.permanent_links = run["results"]["args"]["do_permanent_links"];
  experiment_of(c).complete(c);  // three periods, as published
  return c;
}

class Protocol : public ::testing::TestWithParam<const char*> {};

TEST_P(Protocol, DerivedNumbersAreThePackages) {
  const auto reference = read_run(GetParam());
  const ParticleShearRun run = derive_particleshear(package_case(reference));
  EXPECT_EQ(run.steps, reference["results"]["steps_shear"]);
  const auto expect = [](double mine, double theirs) {
    EXPECT_LE(std::abs(mine / theirs - 1), 1e-14) << theirs;
  };
  expect(run.dt, reference["dt"]);
  expect(run.frequency, reference["f"]);
  expect(run.damping, reference["cool_factor"]);
  expect(run.scales.tau, reference["results"]["tau"]);
  expect(run.constants.k, reference["params"]["k"]);
  expect(run.constants.nu, reference["params"]["nu"]);
  expect(run.constants.k_t, reference["params"]["k_t"]);
  expect(run.constants.nu_t, reference["params"]["nu_t"]);
}

TEST_P(Protocol, PreparationHasThePackagesStages) {
  const auto reference = read_run(GetParam());
  const Case c = package_case(reference);
  const ParticleShearRun run = derive_particleshear(c);
  const auto stages = particleshear_preparation(c, run);
  auto stage = stages.begin();
  for (const auto& theirs : reference["results"]["stages"]) {
    std::int64_t steps = 0;
    EXPECT_NEAR(stage->dt, theirs["dt_max"], 1e-14 * stage->dt) << theirs["stage"];
    for (const std::int64_t end = theirs["steps"]; steps < end; ++stage) {
      ASSERT_NE(stage, stages.end());
      steps += stage->steps;
    }
    EXPECT_EQ(steps, theirs["steps"]) << theirs["stage"];
    EXPECT_NEAR((stage - 1)->dt, theirs["dt"], 1e-14 * run.dt) << theirs["stage"];
  }
  EXPECT_EQ(stage, stages.end());
}

TEST_P(Protocol, PreparedSuspensionIsAsThePackages) {
  const auto reference = read_run(GetParam());
  const Case c = package_case(reference);
  const ParticleShearRun run = derive_particleshear(c);
  ParticleShearStepper stepper(run.constants), again(run.constants);
  ParticleShearPreparation preparation = begin_preparation(c);
  prepare_particleshear(c, run, stepper, preparation);
  System<2>& system = preparation.system;
  const StressTensors t =
      stress_tensors(system, stepper.evaluate(system, {}), particleshear_units().stress());
  // The reference runs of 45 discs: 1023 to 1367 Pa, 8 to 12 discs on the plates.
  EXPECT_NEAR(0.5 * (t.love_weber[0][0] + t.love_weber[1][1]), 1195, 250);
  const auto held = system.state.size() -
                    std::count(system.state.mobility.begin(), system.state.mobility.end(), Mobility::free);
  EXPECT_GE(held, 5);
  EXPECT_LE(held, 15);
  EXPECT_EQ(system.time, 0);
  EXPECT_EQ(system.box.strain, 0);
  EXPECT_EQ(stepper.friction(), run.constants.mu);
  EXPECT_EQ(connected_particles(system, LinkKind::all) == std::vector<std::int32_t>(system.state.size(), 0),
            c.particles.permanent_links);
  ParticleShearPreparation other = begin_preparation(c);
  prepare_particleshear(c, run, again, other);
  const System<2>& twin = other.system;
  EXPECT_EQ(twin.state.position, system.state.position);
}

/// mine[c][r] against theirs[c][r], each column to 1e-9 of its largest entry.
void expect_series(const ReferenceTable& table, const std::vector<std::vector<double>>& rows) {
  ASSERT_EQ(rows.size(), table.rows.size());
  for (std::size_t c = 0; c < table.header.size(); ++c) {
    double largest = 0, difference = 0;
    for (std::size_t r = 0; r < rows.size(); ++r) {
      const double theirs = std::stod(table.rows[r][c]);
      largest = std::max(largest, std::abs(theirs));
      difference = std::max(difference, std::abs(rows[r][c] - theirs));
    }
    EXPECT_LE(difference, 1e-9 * largest) << table.header[c];
  }
}

TEST_P(Protocol, OscillationIsReproduced) {
  const std::string name = GetParam();
  const auto reference = read_run(name);
  const ReferenceTable table = read_reference_table(name + ".tsv.gz", '\t');
  System<2> system = reference_system(reference["params"], reference["initial"]);
  const ParticleShearRun run = derive_particleshear(package_case(reference));
  ParticleShearStepper stepper(run.constants);
  stepper.set_plates(Plates::capture);

  std::vector<std::vector<double>> rows;
  std::vector<double> time, internal, external;
  for (std::int64_t step = 0; step < run.steps; ++step) {
    const double rate = run.rate_at(step, system.time);
    const Evaluation<2>& e = stepper.evaluate(system, {rate, rate});
    const StressTensors t = stress_tensors(system, e, particleshear_units().stress());
    time.push_back(system.time);
    internal.push_back(t.shear_internal());
    external.push_back(t.shear_external());
    if (step % 16 == 0 || step == run.steps - 1)
      rows.push_back({static_cast<double>(step), system.time, system.box.strain, system.box.strain_rate,
                      external.back(), internal.back(), t.love_weber[0][0], t.love_weber[0][1],
                      t.love_weber[1][0], t.love_weber[1][1]});
    stepper.advance(system, {rate, rate}, run.dt, run.damping);
  }
  expect_series(table, rows);

  const supple::Protocol protocol{run.frequency, run.amplitude, run.pre_periods, run.periods,
                                  run.post_periods};
  const auto expect_moduli = [&](const std::vector<double>& stress, const nlohmann::json& theirs) {
    const Demodulation d = demodulate(time, stress, protocol, demodulate_as_published);
    const double mine[] = {d.in_phase, d.out_of_phase, d.storage.value, d.loss.value};
    for (int i = 0; i < 4; ++i) EXPECT_LE(std::abs(mine[i] / theirs[i].get<double>() - 1), 1e-9) << i;
  };
  expect_moduli(internal, reference["results"]["G_internal"]);
  expect_moduli(external, reference["results"]["G_external"]);
  EXPECT_EQ(std::count(system.state.mobility.begin(), system.state.mobility.end(), Mobility::free),
            reference["results"]["n_movable"]);
}

INSTANTIATE_TEST_SUITE_P(ParticleShear, Protocol, ::testing::Values("protocol_a_103", "protocol_c_102"),
                         [](const auto& param) { return std::string(param.param); });

}  // namespace
}  // namespace supple::testing
