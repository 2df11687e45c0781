/// Halving the time step from one prepared state must not move the moduli, which are of second order in it.
#include <gtest/gtest.h>

#include <cmath>

#include "supple/experiment/experiments.hpp"
#include "supple/experiment/microgel.hpp"
#include "supple/experiment/suspension.hpp"

namespace supple {
namespace {

struct Moduli {
  double storage = 0, loss = 0;
};

/// Case of 45 discs with its prepared state.
struct Prepared {
  Case c;
  InitialState state;
};

Prepared prepared(bool links, int cut_lines, std::int64_t seed) {
  Prepared p;
  p.c.general.seed = seed;
  p.c.particles.discs = 45;
  p.c.particles.permanent_links = links;
  p.c.particles.cut_lines = cut_lines;
  p.c.output.tensors = false;
  MemoryRecorder ignored;
  Suspension s = make_suspension(p.c, nullptr, ignored);
  p.state.units = s.units;
  p.state.system = s.system;
  return p;
}

Moduli moduli(Prepared p, double step_factor, const std::string& estimator = "internal") {
  p.c.time.step_factor = step_factor;
  MemoryRecorder recorder;
  run(p.c, &p.state, recorder);
  return {recorder.get("results", "storage_modulus_" + estimator),
          recorder.get("results", "loss_modulus_" + estimator)};
}

void expect_within_two_percent(const Moduli& coarse, const Moduli& fine) {
  EXPECT_NEAR(coarse.storage, fine.storage, 0.02 * std::abs(fine.storage));
  EXPECT_NEAR(coarse.loss, fine.loss, 0.02 * std::abs(fine.loss));
}

TEST(TimeStep, HalvingItDoesNotMoveTheModuliOfCrosslinkedParticles) {
  const Prepared p = prepared(true, 5, 1);
  expect_within_two_percent(moduli(p, 1), moduli(p, 0.5));
}

TEST(TimeStep, HalvingItDoesNotMoveTheModuliOfABulkScaffold) {
  const Prepared p = prepared(true, 0, 1);
  expect_within_two_percent(moduli(p, 1), moduli(p, 0.5));
}

/// What the default step is chosen by (docs/decisions/0018).
TEST(TimeStep, ModuliAtTheDefaultStepAreWithinAThousandthOfThoseOfAVanishingOne) {
  for (const int cut_lines : {0, 5}) {
    Prepared p = prepared(true, cut_lines, 1);
    p.c.shear.periods = 3;
    for (const double amplitude : {0.02, 0.2}) {
      p.c.shear.amplitude = amplitude;
      const Moduli chosen = moduli(p, 1, "virial"), fine = moduli(p, 0.125, "virial");
      EXPECT_NEAR(chosen.storage, fine.storage, 1e-3 * fine.storage) << cut_lines << ' ' << amplitude;
      EXPECT_NEAR(chosen.loss, fine.loss, 1e-3 * fine.loss) << cut_lines << ' ' << amplitude;
    }
  }
}

/// Near the stability limit: of first order, they would be off by 0.3 %.
TEST(TimeStep, ModuliOfAScaffoldAreThoseOfAVanishingStepEvenNearTheStabilityLimit) {
  Prepared p = prepared(true, 0, 2);
  p.c.shear.amplitude = 0.02;
  p.c.shear.periods = 3;
  const double period = 1 / derive_constants(p.c, &p.state).frequency;
  const auto at = [&](int steps) {
    p.c.time.time_step = period / (steps - 0.01);
    return moduli(p, 1, "virial");
  };
  const Moduli coarse = at(300), fine = at(2400);
  EXPECT_NEAR(coarse.storage, fine.storage, 1e-5 * fine.storage);
  EXPECT_NEAR(coarse.loss, fine.loss, 3e-4 * fine.loss);
}

TEST(TimeStep, HalvingItDoesNotMoveTheMeanModuliOfFreeDiscs) {
  Moduli coarse, fine;
  for (std::int64_t seed = 1; seed <= 20; ++seed) {
    const Prepared p = prepared(false, 0, seed);
    const Moduli a = moduli(p, 1), b = moduli(p, 0.5);
    coarse = {coarse.storage + a.storage, coarse.loss + a.loss};
    fine = {fine.storage + b.storage, fine.loss + b.loss};
  }
  expect_within_two_percent(coarse, fine);
}

}  // namespace
}  // namespace supple
