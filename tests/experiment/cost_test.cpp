/// What is said of a run before it begins must cost nothing, however absurd the case.
#include <gtest/gtest.h>

#include <cmath>
#include <ctime>

#include "supple/core/error.hpp"
#include "supple/experiment/adopt_state.hpp"
#include "supple/experiment/bodies_of_case.hpp"
#include "supple/experiment/cost.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/experiment/packing_record.hpp"
#include "supple/model/polygons.hpp"

namespace supple {
namespace {

Case bodies_case(const std::string& experiment, const std::string& family = "shell") {
  Case c;
  c.general.experiment = experiment;
  c.general.physics = "deformable";
  c.bodies.family = family;
  c.given.insert("bodies.family");
  c.bodies.count = 12;
  c.bodies.vertices = 12;
  c.jamming.packing_fraction = 0.4;
  if (experiment == "dynamics") {
    c.time.steps = 10;
    c.given.insert("time.steps");
  }
  resolve_family(c);
  return c;
}

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

TEST(Cost, NumbersKnownBeforehandAreThoseOfTheRun) {
  for (const char* experiment : {"slump", "dynamics"})
    for (const char* family : {"shell", "floppy", "disc", "rough_disc"}) {
      SCOPED_TRACE(std::string(experiment) + " of " + family);
      Case c = bodies_case(experiment, family);
      c.slump.settle_time = c.slump.spread_time = 0.05;
      MemoryRecorder recorder;
      run(c, nullptr, recorder);
      for (const Derived& d : derive(c, nullptr)) {
        const double of_run = recorder.get("constants", d.name.name);
        EXPECT_NEAR(d.value, of_run, 1e-9 * std::abs(of_run)) << d.name.name;
      }
    }
}

TEST(Cost, ManyParticlesSetApartAreStillACellThatCanBeComputedWith) {
  Case c = bodies_case("jamming");
  c.bodies.count = 1000;  // in one row they would reach beyond 1e9 of these radii
  c.bodies.vertices = 20;
  c.bodies.diameter_ratio = 0.05;
  c.contact.kind = "smooth";
  EXPECT_NO_THROW(derive(c, nullptr));
}

TEST(Cost, ParticlesSetApartAreThoseOfTheCell) {
  for (const char* family : {"shell", "floppy", "disc", "rough_disc"})
    for (const double ratio :
         {1.4, 100.0}) {  // the largest are wider than the usual distance between particles
      SCOPED_TRACE(family);
      Case c = bodies_case("jamming", family);
      c.bodies.size_ratio = ratio;
      c.jamming.packing_fraction = ratio < 2 ? 0.4 : 0.05;
      const std::vector<Derived> row = derived_equilibria(
                                     make_packing(c, nullptr, c.jamming.packing_fraction, set_apart)),
                                 cell =
                                     derived_equilibria(make_packing(c, nullptr, c.jamming.packing_fraction));
      for (std::size_t k = 0; k < row.size(); ++k)
        EXPECT_NEAR(row[k].value, cell[k].value, 1e-9 * cell[k].value) << row[k].name.name;
    }
}

/// check has no time to measure a million vertices one body after the other.
TEST(Cost, ParticlesOfOneKindAreMeasuredOnceAndAreThoseOfEach) {
  for (const char* family : {"shell", "droplet", "floppy", "disc", "rough_disc"})
    for (const char* kind : {"rough", "smooth"}) {
      Case c = bodies_case("jamming", family);
      c.contact.kind = std::string(family) == "rough_disc" ? "rough" : kind;
      c.bodies.discs = std::string(family) == "disc" ? 0 : 3;
      c.bodies.vertex_rule = "scaled";
      c.bodies.shape_ratio_large = std::string(family) == "shell" ? 1.2 : 0;
      SCOPED_TRACE(std::string(family) + ", " + kind);
      const System<2> apart = particles_apart(c);
      const LooseBodies each = loose_bodies(c, 0.2), kinds = loose_bodies(c, 0.2, {}, &apart);
      EXPECT_NEAR(kinds.area, each.area, 1e-9 * each.area);
      ASSERT_EQ(kinds.radius.size(), each.radius.size());
      for (std::size_t b = 0; b < each.radius.size(); ++b)
        EXPECT_NEAR(kinds.radius[b], each.radius[b], 1e-9 * each.radius[b]) << b;
    }
}

/// Each of 64 stood in a cell 64 times as wide, with a tolerance that took 6e-5 of their area away.
TEST(Cost, AreasOfDrawnParticlesAreExactHoweverManyThereAre) {
  for (const double shape : {1.04, 6.0})  // of the second, more than neighbours meet
    for (const char* kind : {"rough", "smooth"}) {
      Case c = bodies_case("jamming", "floppy");
      c.contact.kind = kind;
      c.bodies.count = 64;
      c.bodies.vertices = 100;
      c.bodies.shape_parameter = shape;
      const System<2> apart = particles_apart(c);
      System<2> one;
      double exact = 0;
      for (int b = 0; b < 64; ++b) {
        one = {};
        const auto begin = apart.state.position.begin() + apart.topology.body_begin(b);
        std::vector<Vec2> ring(begin, begin + apart.topology.body_size(b));
        const Vec2 there = ring[0];
        for (Vec2& x : ring) x -= there;
        const std::vector<double> rest(ring.size(), 1.0);
        add_ring(one, ring, apart.state.radius[apart.topology.body_begin(b)], {}, 1, rest, rest);
        one.box.length = {8, 8};
        exact +=
            64 * packing_fraction(one, std::string(kind) == "rough" ? Outline::rough : Outline::smooth).total;
      }
      SCOPED_TRACE(kind);
      EXPECT_NEAR(loose_bodies(c, 0.2).area, exact, 1e-9 * exact) << shape;
      EXPECT_NEAR(loose_bodies(c, 0.2, {}, &apart).area, exact, 1e-9 * exact) << shape;
    }
}

/// A push by 1 % of the radius, 17 edges of such a ring, made teeth between whose ends vertices passed.
TEST(Cost, ABuckledRingOfVeryManyVerticesIsNoSaw) {
  Case c = bodies_case("jamming", "floppy");
  c.bodies.count = 4;
  c.bodies.vertices = 10000;
  EXPECT_NO_THROW(derive(c, nullptr));
  const System<2> s = particles_apart(c);
  const Topology<2>& t = s.topology;
  double shortest = 1e300, longest = 0;
  for (const auto& facet : t.facet) {
    const double length = norm(s.state.position[facet[1]] - s.state.position[facet[0]]);
    shortest = std::min(shortest, length / s.state.radius[facet[0]]);
    longest = std::max(longest, length / s.state.radius[facet[0]]);
  }
  EXPECT_GT(longest, 1.05 * shortest) << "not pushed";
  EXPECT_LT(longest, 2.3);
}

/// A body of 900 vertices has 3.2 million pairs of coordinates: what is asked of thousands of them before a
/// run must not list them.
TEST(Cost, ATimeStepIsKnownForAsManyVerticesAsARunCanHave) {
  Case c = bodies_case("dynamics");
  c.bodies.count = 3;
  c.bodies.vertices = 20000;
  const double before = cpu_seconds();
  EXPECT_GT(derive(c, nullptr).size(), 0u);
  EXPECT_LT(cpu_seconds() - before, 20) << "60 000 vertices: 10 GB for each body as pairs";
}

TEST(Cost, SitesAreCountedBeforeTheyAreMade) {
  for (const char* family : {"shell", "disc"}) {
    Case c = bodies_case("jamming", family);
    c.bodies.discs = 3;
    c.bodies.vertex_rule = "scaled";
    EXPECT_EQ(sample_size(c).sites, make_packing(c, nullptr, 0.3).system.state.size());
  }
}

TEST(Cost, VerticesBeyondAnyMemoryAreRefusedAtOnce) {
  Case c = bodies_case("jamming");
  for (const auto& [count, vertices] : {std::pair{64, 20000}, {1000000, 100000}}) {
    c.bodies.count = count;
    c.bodies.vertices = vertices;
    const double begin = cpu_seconds();
    try {
      derive(c, nullptr);
      ADD_FAILURE();
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::input);
      EXPECT_NE(std::string(e.what()).find("GB of memory"), std::string::npos) << e.what();
      EXPECT_NE(std::string(e.what()).find("lower bodies.N or bodies.vertices"), std::string::npos)
          << e.what();
    }
    EXPECT_LT(cpu_seconds() - begin, 0.5);
  }
}

TEST(Cost, AThousandsSidedRingCostsNoSquareOfItsSides) {
  Case c = bodies_case("jamming");
  c.bodies.count = 4;
  c.bodies.vertices = 10000;
  const double begin = cpu_seconds();
  derive(c, nullptr);
  EXPECT_LT(cpu_seconds() - begin, 3);  // 0.3 s here; with all pairs of sides looked at, a minute
}

/// A thousand edges wide, each of 400 000 vertices meets a thousand others: the outline alone took minutes.
TEST(Cost, VerticesThatReachOverAThousandEdgesAreRefusedAtOnce) {
  for (const bool is_shape : {false, true}) {
    Case c = bodies_case("jamming");
    c.bodies.count = 4;
    c.bodies.vertices = 100000;
    (is_shape ? c.bodies.shape_parameter : c.bodies.diameter_ratio) = is_shape ? 1e6 : 1e3;
    try {
      derive(c, nullptr);
      ADD_FAILURE();
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::input);
      EXPECT_NE(std::string(e.what()).find("lower bodies.diameter_ratio"), std::string::npos) << e.what();
    }
  }
}

TEST(Cost, VerticesOfAnyWidthAreRefusedOrCounted) {
  for (const double ratio : {1e3, 1e9, 9007199254740992.0, 1e100, 1e308})
    for (const bool is_shape : {false, true}) {
      Case c = bodies_case("uniaxial_compression");
      c.bodies.count = 4;
      (is_shape ? c.bodies.shape_ratio : c.bodies.diameter_ratio) = ratio;
      const double begin = cpu_seconds();
      try {
        for (const Derived& d : derive(c, nullptr)) EXPECT_TRUE(std::isfinite(d.value)) << d.name.name;
      } catch (const Error& e) {
        EXPECT_EQ(e.kind(), ErrorKind::input);
      }
      EXPECT_LT(cpu_seconds() - begin, 1) << ratio;
    }
}

TEST(Cost, StepsThatNoIntegerHoldsAreRefusedByName) {
  const auto refused = [](Case c, const std::string& key) {
    try {
      derive(c, nullptr);
      ADD_FAILURE() << key;
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::input);
      EXPECT_NE(std::string(e.what()).find(key), std::string::npos) << e.what();
    }
  };
  Case c = bodies_case("slump");
  c.slump.settle_time = 1e300;
  refused(c, "slump.settle_time");
  c = bodies_case("slump");
  c.slump.width = 1e300;
  refused(c, "slump.width");
  c = bodies_case("uniaxial_compression");
  c.uniaxial.step = 5e-324;
  refused(c, "uniaxial.step");
  c = bodies_case("friction");
  c.bodies.count = 2;
  c.sliding.step = 5e-324;
  refused(c, "sliding.step");
  c = bodies_case("compression");
  c.compression.per_decade = 2000000000;
  refused(c, "compression.per_decade");
  c = Case{};
  c.general.physics = "particleshear-1.0.2";
  c.particles.cut_lines = 0;
  c.shear.relative_frequency = 5e-324;
  refused(c, "shear.relative_frequency");
}

TEST(Cost, AStateIsSaneBeforeAnythingIsReadFromIt) {
  InitialState initial;
  initial.system = make_packing(bodies_case("jamming"), nullptr, 0.3).system;
  system_of<2>(initial).state.radius[5] = 1e200;
  Case c = bodies_case("jamming");
  c.given = {"bodies.N"};
  c.bodies.count = 3;  // wrong, too: but that is said of particles that can be computed with
  try {
    adopt_state(c, &initial);
    ADD_FAILURE();
  } catch (const Error& e) {
    EXPECT_EQ(std::string(e.what()).find("the state to start from cannot be computed with"), 0u) << e.what();
  }
}

TEST(Cost, NumbersThatAreNoneAreNotSound) {
  Case c = bodies_case("slump");
  c.slump.gravity = 1e308;
  EXPECT_THROW(derive(c, nullptr), Error);
}

}  // namespace
}  // namespace supple
