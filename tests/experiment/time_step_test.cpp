/// Halving the time step from one prepared state must not move the moduli.
#include <gtest/gtest.h>

#include <cmath>

#include "supple/experiment/experiments.hpp"
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

Moduli moduli(Prepared p, double step_factor) {
  p.c.time.step_factor = step_factor;
  MemoryRecorder recorder;
  run(p.c, &p.state, recorder);
  return {recorder.get("results", "storage_modulus_internal"),
          recorder.get("results", "loss_modulus_internal")};
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
