/// Two particles, one of which slides over the other [MacKeith 2025, section 9.3.3].
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "supple/core/error.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/experiment/sliding_record.hpp"
#include "tests/experiment/sliding.hpp"

namespace supple {
namespace {

using namespace testing_pairs;

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(Friction, RoughShellsReachTheBoundFromBelow) {
  const std::vector<std::string> fine{"sliding.overlap=1e-4", "sliding.step=5e-4", "sliding.from=-0.01",
                                      "sliding.to=0.02"};
  for (const auto& [keys, bound] : {std::pair(fine, 0.57735), std::pair(wider(fine), 0.28233)}) {
    const MemoryRecorder r = slide_shells(keys);
    EXPECT_NEAR(r.get("results", "friction_bound"), bound, 1e-5);
    EXPECT_NEAR(r.get("constants", "friction_bound"), bound, 1e-5);
    EXPECT_LT(maximum(r), bound);
    EXPECT_GT(maximum(r), 0.99 * bound);
    EXPECT_LT(r.get("results", "friction_max_x"), 0.001);
  }
}

TEST(Friction, IsThePublishedOneAtMatchingHeights) {
  EXPECT_NEAR(maximum(slide_shells({"sliding.overlap=0.065"})), 0.537, 0.04);
  EXPECT_NEAR(maximum(slide_shells(wider({"sliding.overlap=0.013"}))), 0.261, 0.04);
  const MemoryRecorder smooth = slide_shells({"sliding.overlap=0.114", "contact.kind=smooth"});
  EXPECT_NEAR(maximum(smooth), 0.190, 0.04);
  EXPECT_NEAR(smooth.get("results", "friction_max_x"), 0.1, 0.04);
}

TEST(Friction, IsZeroInTheMiddleAndAntisymmetric) {
  for (const char* kind : {"rough", "smooth"}) {
    const MemoryRecorder r = slide_shells({std::string("contact.kind=") + kind});
    const auto& table = r.tables.at("friction");
    const std::vector<double> x = table.column("x"), mu = table.column("friction"),
                              force = table.column("normal_force");
    const std::size_t last = x.size() - 1, middle = last / 2;
    ASSERT_EQ(last % 2, 0u);
    EXPECT_EQ(x[middle], 0);
    EXPECT_GT(force[middle], 0);
    EXPECT_NEAR(mu[middle], 0, 1e-9);
    for (std::size_t k = 0; k <= last; ++k) {
      EXPECT_EQ(x[k], -x[last - k]);
      EXPECT_NEAR(mu[k], -mu[last - k], 1e-6) << kind << " at " << x[k];
    }
    EXPECT_EQ(force.front(), 0);
    EXPECT_EQ(mu.front(), 0);
    EXPECT_EQ(force.back(), 0);
    EXPECT_TRUE(r.warnings.empty());
  }
}

/// The force of smooth shells is continuous: the largest change of mu_eff shrinks with the step. That of
/// rough ones jumps from one tooth to the next.
TEST(Friction, OnlyRoughShellsJump) {
  const auto jump = [&](const char* kind, const char* overlap, const char* step) {
    return slide_shells({std::string("contact.kind=") + kind, std::string("sliding.overlap=") + overlap,
                         std::string("sliding.step=") + step})
        .get("results", "friction_jump");
  };
  const double coarse = jump("smooth", "0.114", "0.016"), fine = jump("smooth", "0.114", "0.001");
  EXPECT_LT(coarse, 0.1);
  EXPECT_LT(fine, 0.3 * coarse);
  EXPECT_GT(jump("rough", "5e-4", "0.016"), 0.5);
  EXPECT_GT(jump("rough", "5e-4", "0.001"), 0.5);
}

/// The stiffnesses are ratios in the chapter. Here from their definitions, of relative and of absolute ones.
TEST(Friction, StiffnessesAreThoseOfTheChapter) {
  const std::string absolute =
      "experiment = \"friction\"\n[bodies]\nvertices = 8\nstiffness = "
      "\"absolute\"\nk_l = 200\nk_b = 1\nk_a = 1\n[contact]\nk_c = 2\n";
  struct Wanted {
    Case c;
    double k_l, k_b, k_a;
  };
  const double sigma = 0.45508986056222733;  // of an octagon of area 1
  for (const Wanted& w :
       {Wanted{case_of(shells), 100, 171, 14}, Wanted{case_of(shells, wider({})), 100, 171, 14},
        Wanted{case_of(absolute), 100, 0.5 / (sigma * sigma), 0.5 / (sigma * sigma)}}) {
    const SlidingPair pair = make_sliding_pair(w.c);
    const System<2>& s = pair.packing.system;
    for (const int b : {0, 1}) {
      const ShapeStiffness& k = s.shape.stiffness[static_cast<std::size_t>(b)];
      const double a0 = s.shape.rest_volume[static_cast<std::size_t>(b)], width = 2 * s.state.radius[0];
      const double k_c = pair.packing.field->bodies()->laws().common().spring(width);
      EXPECT_NEAR(k.facet / k_c, w.k_l, 1e-3 * w.k_l);
      EXPECT_NEAR(k.hinge / (k_c * width * width), w.k_b, 1e-3 * w.k_b);
      EXPECT_NEAR(k.volume * a0 * a0 / (k_c * width * width), w.k_a, 1e-3 * w.k_a);
    }
    EXPECT_NEAR(pair.moved.front().stiffness / pair.spring, 100, 1e-9);
  }
  const MemoryRecorder r = slide_shells(wider({"sliding.to=0.01"}));
  EXPECT_NEAR(r.get("constants", "k_l_ratio"), 100, 1e-3);
  EXPECT_NEAR(r.get("constants", "k_b_ratio"), 171, 1e-9);
  EXPECT_NEAR(r.get("constants", "radius_ratio"), 0.71, 1e-5);
}

/// The centre distance at first touch by hand: R (1 + cos pi/8) and the height of a vertex in a groove, or
/// over an edge.
TEST(Friction, HeightsAreThoseOfTheGeometry) {
  const auto touch = [&](const std::vector<std::string>& more) {
    return slide_shells(more).get("constants", "touch_distance");
  };
  EXPECT_NEAR(touch({"sliding.to=0.01"}), 2.587, 1e-3);
  EXPECT_NEAR(touch(wider({"sliding.to=0.01"})), 3.279, 1e-3);
  EXPECT_NEAR(touch({"sliding.to=0.01", "contact.kind=smooth"}), 2.689, 1e-3);
  const MemoryRecorder r = slide_shells({"sliding.centre_distance=2.56", "sliding.to=0.01"});
  EXPECT_NEAR(r.get("constants", "overlap"), (2.5867067 - 2.56) * 1.3065630, 1e-6);
  // At x = 0 the centres are there but for what the particles yield.
  EXPECT_NEAR(r.tables.at("friction").column("distance").front() / r.get("constants", "radius_ratio") /
                  r.get("constants", "sigma"),
              2.56, 1e-3);
}

/// In equilibrium the springs bear the force between the particles, and their work is what is stored.
TEST(Friction, SpringsBearTheForceAndDoTheWork) {
  for (const char* kind : {"rough", "smooth"}) {
    Case c = case_of(shells, {std::string("contact.kind=") + kind, "sliding.from=0.05", "sliding.to=0.0502",
                              "sliding.step=1e-4", "minimise.force_tolerance=1e-10"});
    SlidingPair pair = make_sliding_pair(c);
    ASSERT_EQ(pair.path.places(), 3);
    SlidingInstant at[3];
    Vec2 pulled{};
    for (int place : {0, 1, 2}) {
      pair.packing.field->external().tethers = pair.tethers(place);
      ASSERT_TRUE(relax(pair.packing).converged);
      at[place] = look_at_pair(pair, place);
      if (place != 1) continue;
      for (std::size_t t = pair.held.size(); t < pair.tethers(1).size(); ++t) {
        const Tether<2> spring = pair.tethers(1)[t];
        pulled += spring.stiffness * (spring.anchor - pair.packing.system.state.position[spring.site]);
      }
    }
    const Vec2 pushed = at[1].force.force;
    EXPECT_GT(norm(pushed), 0.01);
    EXPECT_LT(norm(pushed + pulled), 1e-7 * norm(pushed)) << kind;
    EXPECT_NEAR(-(at[2].energy - at[0].energy) / (at[2].x - at[0].x), pushed[0], 1e-5 * norm(pushed)) << kind;
  }
}

TEST(Friction, DampedMotionEndsInTheSameStates) {
  for (const char* kind : {"rough", "smooth"}) {
    const std::vector<std::string> part{std::string("contact.kind=") + kind, "sliding.from=-0.05",
                                        "sliding.to=0.05", "minimise.force_tolerance=1e-9"};
    std::vector<std::string> moving = part;
    moving.push_back("sliding.relaxation=dynamics");
    const MemoryRecorder a = slide_shells(part), b = slide_shells(moving);
    const std::vector<double> mu = a.tables.at("friction").column("friction"),
                              other = b.tables.at("friction").column("friction");
    ASSERT_EQ(mu.size(), other.size());
    for (std::size_t k = 0; k < mu.size(); ++k) EXPECT_NEAR(mu[k], other[k], 1e-7) << kind;
    for (const double kinetic : b.tables.at("friction").column("kinetic_energy")) {
      EXPECT_GT(kinetic, 0);
      EXPECT_LT(kinetic, 1e-20);
    }
  }
}

TEST(Friction, MotionThatDoesNotDieDownEndsTheRun) {
  MemoryRecorder r;
  const std::string error = error_of(
      case_of(shells, {"sliding.relaxation=dynamics", "sliding.from=-0.05", "sliding.most_steps=100"}), r);
  EXPECT_THAT(error, HasSubstr("not at rest after 100 steps"));
  EXPECT_THAT(error, HasSubstr("sliding.most_steps"));
  EXPECT_EQ(r.last_system.state.size(), 16);
}

TEST(Friction, GoesForwardBackwardAndInCycles) {
  const std::vector<std::string> part{"sliding.from=-0.02", "sliding.to=0.02", "sliding.step=0.02"};
  const auto places = [&](const std::string& path) {
    std::vector<std::string> keys = part;
    keys.push_back("sliding.path=" + path);
    if (path == "cyclic") keys.push_back("sliding.cycles=2");
    return slide_shells(keys).tables.at("friction");
  };
  EXPECT_THAT(places("forward").column("x_over_width"), ElementsAre(-0.02, 0, 0.02));
  EXPECT_THAT(places("backward").column("x_over_width"), ElementsAre(0.02, 0, -0.02));
  const auto cyclic = places("cyclic");
  EXPECT_THAT(cyclic.column("x_over_width"), ElementsAre(-0.02, 0, 0.02, 0, -0.02, 0, 0.02, 0, -0.02));
  EXPECT_THAT(cyclic.column("leg"), ElementsAre(0, 0, 0, 1, 1, 2, 2, 3, 3));
  const std::vector<double> mu = cyclic.column("friction");  // shells do not remember
  for (std::size_t k = 4; k < mu.size(); ++k) EXPECT_NEAR(mu[k], mu[k - 4], 1e-6);
}

/// A vertex that comes from below the others is within the other particle before it has left it.
TEST(Friction, ParticlesWithinEachOtherEndTheRun) {
  MemoryRecorder r;
  const std::vector<std::string> deep{"sliding.centre_distance=1.2", "bodies.k_b=1", "sliding.step=0.1"};
  EXPECT_THAT(error_of(case_of(shells, deep), r), HasSubstr("contact.unsound = \"mark\""));
  EXPECT_EQ(r.last_system.state.size(), 16);
  std::vector<std::string> on = deep;
  on.push_back("contact.unsound=mark");
  MemoryRecorder marked;
  EXPECT_EQ(error_of(case_of(shells, on), marked), "");
}

TEST(Friction, SaysWhereNothingTouches) {
  const MemoryRecorder apart = slide_shells({"sliding.from=-2", "sliding.to=-1.9"});
  EXPECT_THAT(apart.warnings, ElementsAre(HasSubstr("touch at no place")));
  EXPECT_EQ(apart.get("results", "places_in_contact"), 0);
  EXPECT_THAT(slide_shells({"sliding.to=0.5"}).warnings,
              ElementsAre(HasSubstr("touch at an end of the way")));
  MemoryRecorder r;
  EXPECT_THAT(error_of(case_of(shells, {"sliding.overlap=-5"}), r), HasSubstr("never touch"));
  EXPECT_THAT(error_of(case_of(shells, {"bodies.diameter_ratio=0.3", "contact.unsound=mark"}), r),
              HasSubstr("pass between"));
  EXPECT_THAT(error_of(case_of(shells, {"sliding.overlap=50"}), r), HasSubstr("below the lower one"));
}

TEST(Friction, RefusesWhatIsNoPair) {
  EXPECT_THAT(refusal({"bodies.N=3"}), HasSubstr("3 particles with experiment = \"friction\""));
  EXPECT_THAT(refusal({"bodies.discs=1"}), HasSubstr("3 particles"));
  EXPECT_THAT(refusal({}, "experiment = \"friction\"\n[bodies]\nfamily = \"disc\"\n"),
              HasSubstr("mu_eff is 0 everywhere"));
  EXPECT_THAT(refusal({"sliding.overlap=0.1", "sliding.centre_distance=2"}), HasSubstr("leave one away"));
  EXPECT_THAT(refusal({"sliding.from=1"}), HasSubstr("make sliding.to larger"));
  EXPECT_THAT(refusal({"sliding.relaxation=dynamics", "motion.damping=0"}), HasSubstr("never dies down"));
  EXPECT_THAT(refusal({"bodies.dim=3"}), HasSubstr("two dimensions"));
  EXPECT_THAT(refusal({"initial.state=\"a.h5\""}), HasSubstr("initial.state"));
}

TEST(Friction, FramesSayWhereThePairIs) {
  const MemoryRecorder r = slide_shells({"output.frames=5"});
  ASSERT_EQ(r.frames.size(), 5u);
  const auto& table = r.tables.at("friction");
  const std::vector<double> x = table.column("x_over_width"), mu = table.column("friction");
  for (std::size_t k = 0; k < 5; ++k) {
    const auto place = static_cast<std::size_t>(std::lround(0.25 * static_cast<double>(k * (x.size() - 1))));
    EXPECT_EQ(r.frames[k].numbers.at("sliding_x"), x[place]);
    EXPECT_EQ(r.frames[k].numbers.at("friction"), mu[place]);
  }
}

}  // namespace
}  // namespace supple
