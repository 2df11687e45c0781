/// How experiments on packings end when they are stopped, and when a minimisation leads nowhere.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "supple/core/error.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/experiment/jam.hpp"

namespace supple {
namespace {

Case small_case(const std::string& experiment, const std::string& family = "shell") {
  Case c;
  c.general.experiment = experiment;
  c.bodies.family = family;
  c.bodies.count = 8;
  c.bodies.vertices = 10;
  c.jamming.packing_fraction = 0.4;
  c.jamming.step = 0.01;
  c.jamming.pressure = 1e-4;
  resolve_family(c);
  return c;
}

/// Asks to stop from the n-th question on.
class Stopper : public MemoryRecorder {
 public:
  explicit Stopper(long after) : left_(after) {}
  bool stop_requested() override {
    if (left_ <= 0) ++late_;
    return --left_ < 0;
  }
  long late() const { return late_; }

 private:
  mutable long left_, late_ = 0;
};

class StoppingOf : public ::testing::TestWithParam<std::string> {};

/// Every evaluation asks, so a thousand questions are within one of the first minimisations.
TEST_P(StoppingOf, EndsWithinAMinimisationAndShowsThePacking) {
  Case c = small_case(GetParam());
  c.minimise.force_tolerance = 1e-13;  // a long one
  Stopper recorder(1000);
  try {
    run(c, nullptr, recorder);
    FAIL() << "was not stopped";
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::interrupted);
  }
  EXPECT_LT(recorder.late(), 40);
  EXPECT_GT(recorder.get("results", "packing_fraction"), 0.3);
  EXPECT_NO_THROW(recorder.get("results", "pressure"));
  EXPECT_FALSE(recorder.frames.empty());
  EXPECT_EQ(recorder.last_system.state.size(), 80);
}

INSTANTIATE_TEST_SUITE_P(Experiments, StoppingOf,
                         ::testing::Values("jamming", "compression", "uniaxial_compression"),
                         [](const auto& one) { return one.param; });

/// Before there is a packing: nothing is begun, and nothing handed over.
TEST_P(StoppingOf, HeedsWhileParticlesFindTheirPlaces) {
  Case c = small_case(GetParam());
  c.bodies.count = 100;
  c.jamming.packing_fraction = 0.8;
  Stopper recorder(3);
  try {
    run(c, nullptr, recorder);
    FAIL() << "was not stopped";
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::interrupted);
    EXPECT_THAT(e.what(), ::testing::HasSubstr("found their places"));
  }
  EXPECT_LT(recorder.late(), 40);
  EXPECT_EQ(recorder.last_system.state.size(), 0);
}

/// Windows of relaxation take seconds each with many discs: every fifth step asks.
TEST(StoppingOfThePreparation, EndsWithinAWindow) {
  for (const char* physics : {"documented", "particleshear-1.0.2"}) {
    Case c;
    c.general.physics = physics;
    c.particles.discs = 45;
    Stopper recorder(10);
    try {
      run(c, nullptr, recorder);
      FAIL() << physics;
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::interrupted);
      EXPECT_THAT(e.what(), ::testing::HasSubstr("interrupted while preparing"));
    }
    EXPECT_LT(recorder.late(), 3);
    EXPECT_TRUE(recorder.tables["preparation"].rows.empty()) << "a whole window was computed";
  }
}

TEST(Jamming, OneEvaluationIsNoMinimisation) {
  Case c = small_case("jamming");
  c.minimise.max_evaluations = 1;
  for (const char* search : {"root", "chapter", "pressure"}) {
    c.jamming.search = search;
    MemoryRecorder recorder;
    try {
      run(c, nullptr, recorder);
      FAIL() << search;
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::numerics) << search;
      EXPECT_THAT(e.what(), ::testing::HasSubstr("minimise.max_evaluations"));
    }
    EXPECT_FALSE(recorder.frames.empty()) << search;
  }
}

/// Energy s -> (1/2)(s^2 - 1)^2 + gamma s + (n/20)(s - 1)^2 of a droplet of n = 10 edges with k_l = 0.1.
TEST(Droplets, AreRefusedWhereTheyShrinkToAPoint) {
  Case c = small_case("jamming", "droplet");
  for (const double tension : {1.27, 1.28}) {
    const auto slope = [&](double s) {
      return 2 * s * (s * s - 1) + tension + 0.1 * c.bodies.vertices * c.bodies.k_l / 0.1 * (s - 1);
    };
    bool rests = false;
    for (double s = 1e-3; s < 1; s += 1e-4) rests |= slope(s) < 0;
    c.bodies.gamma = tension;
    if (rests) EXPECT_NO_THROW(derive(c, nullptr)) << tension;
    else EXPECT_THROW(derive(c, nullptr), Error) << tension;
    EXPECT_EQ(rests, tension < 1.275) << "k_l = " << c.bodies.k_l;
  }
}

/// The largest tension that is allowed leaves a droplet that minimisation finds.
TEST(Droplets, RestJustBelowTheLargestTension) {
  Case c = small_case("jamming", "droplet");
  c.bodies.gamma = 1.25;
  c.bodies.size_ratio = 1;
  Packing<2> packing = make_packing(c, nullptr, 0.1);
  EXPECT_TRUE(relax(packing).converged);
}

}  // namespace
}  // namespace supple
