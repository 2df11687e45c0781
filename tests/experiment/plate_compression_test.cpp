#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "supple/core/error.hpp"
#include "supple/experiment/between_plates.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/io/text/case_file.hpp"
#include "supple/model/polygons.hpp"

namespace supple {
namespace {

using std::numbers::pi;

Case case_of(const std::string& text) {
  Case c = read_case_text("experiment = \"plate_compression\"\n" + text, "case.toml");
  resolve_family(c);
  experiment_of(c).complete(c);
  check(c);
  return c;
}

/// The text of the error that `act` ends with.
template <class Act>
std::string caught(Act&& act) {
  try {
    act();
  } catch (const Error& e) {
    return e.what();
  }
  return "";
}

template <int Dim>
MemoryRecorderOf<Dim> run_of(const std::string& text, const InitialState* initial = nullptr) {
  MemoryRecorderOf<Dim> recorder;
  run(case_of(text), initial, recorder);
  return recorder;
}

template <int Dim>
std::vector<double> column(const MemoryRecorderOf<Dim>& r, const char* name) {
  return r.tables.at("plates").column(name);
}

TEST(PlateCourse, GoesThereAndBackThroughTheSameCompressions) {
  PlateCompression plates;
  plates.first = 1e-3;
  plates.strain = 1e-1;
  plates.steps = 5;
  const PlateCourse course = plate_course(plates);
  ASSERT_EQ(course.compression.size(), 11u);
  EXPECT_EQ(course.turn, 5u);
  for (std::size_t k = 0; k <= 5; ++k) EXPECT_EQ(course.compression[k], course.compression[10 - k]);
  EXPECT_EQ(course.compression[0], 0);
  EXPECT_EQ(course.compression[1], 1e-3);
  EXPECT_NEAR(course.compression[3], 1e-2, 1e-15);
  EXPECT_EQ(course.compression[5], 1e-1);
  EXPECT_TRUE(course.is_down(5));
  EXPECT_FALSE(course.is_down(6));
  plates.spacing = "linear";
  plates.decompress = false;
  EXPECT_THAT(plate_course(plates).compression,
              ::testing::Pointwise(::testing::DoubleNear(1e-15), {0.0, 0.02, 0.04, 0.06, 0.08, 0.1}));
  plates.steps = 1;
  plates.spacing = "logarithmic";
  EXPECT_THAT(plate_course(plates).compression, ::testing::ElementsAre(0, 0.1));
}

/// A disc or a ball does not deform: both plates press with springs k_p k_c/sigma^2, each half as far.
template <int Dim>
void expect_two_springs(const char* family) {
  const auto r = run_of<Dim>(std::string("[bodies]\ndim = ") + std::to_string(Dim) + "\nfamily = \"" +
                             family + "\"\n[contact]\nk_c = 3\nk_p = 2\n[plates]\nsteps = 10\n");
  const double diameter = r.get("results", "diameter"), spring = 6 / (diameter * diameter);
  EXPECT_NEAR(diameter, Dim == 2 ? 2 / std::sqrt(pi) : std::cbrt(6 / pi), 1e-12);
  const std::vector<double> x = column(r, "compression"), upper = column(r, "upper_force"),
                            lower = column(r, "lower_force"), energy = column(r, "energy"),
                            gap = column(r, "gap");
  ASSERT_EQ(x.size(), 21u);
  for (std::size_t k = 1; k + 1 < x.size(); ++k) {
    const double depth = 0.5 * x[k] * diameter;
    EXPECT_NEAR(gap[k], diameter * (1 - x[k]), 1e-14);
    EXPECT_NEAR(upper[k], spring * depth, 1e-5 * spring * depth) << x[k];
    EXPECT_NEAR(lower[k], spring * depth, 1e-5 * spring * depth) << x[k];
    EXPECT_NEAR(energy[k], spring * depth * depth, 1e-5 * spring * depth * depth) << x[k];
    EXPECT_EQ(column(r, "upper_nodes")[k], 1);
    EXPECT_EQ(column(r, "width")[k], 1);
    EXPECT_EQ(column(r, "rotation")[k], 0);
  }
  EXPECT_NEAR(r.get("results", "exponent"), 1, 1e-5);
  EXPECT_NEAR(r.get("results", "exponent_up"), 1, 1e-5);
  EXPECT_NEAR(r.get("results", "hysteresis"), 0, 1e-5);
  EXPECT_NEAR(r.get("results", "largest_force"),
              upper[10] / r.get("constants", "pressure_unit") / std::pow(diameter, Dim - 1), 1e-12);
}
TEST(PlateCompression, ADiscIsTwoSprings) { expect_two_springs<2>("disc"); }
TEST(PlateCompression, ABallIsTwoSprings) { expect_two_springs<3>("sphere"); }

const std::string ring = "[bodies]\nvertices = 100\nk_b = 0.05\n";

/// Half the compression of an inextensible ring is that of bending alone, delta = (pi/4 - 2/pi) F R^3/B with
/// the bending stiffness B = k_b l [Timoshenko, Strength of Materials; Love, Mathematical Theory of
/// Elasticity].
TEST(PlateCompression, AShellIn2dIsAThinRing) {
  const auto r = run_of<2>(ring + "[plates]\nfit_from = 1e-4\nfit_to = 1e-2\n");
  EXPECT_TRUE(r.warnings.empty());
  const double radius = 50 / pi * std::sqrt(4 * std::tan(pi / 100) / 100), edge = 2 * pi * radius / 100;
  const double per_length = 0.05 * edge / ((pi / 4 - 2 / pi) * std::pow(radius, 3));
  const std::vector<double> x = column(r, "compression"), force = column(r, "upper_force"),
                            lower = column(r, "lower_force");
  const double diameter = r.get("results", "diameter");
  for (std::size_t k = 1; k < 20; ++k)
    EXPECT_NEAR(force[k], per_length * x[k] * diameter, 0.01 * force[k]) << x[k];
  for (std::size_t k = 1; k + 1 < x.size(); ++k) EXPECT_NEAR(force[k], lower[k], 1e-5 * force[k]);
  EXPECT_NEAR(r.get("results", "exponent"), 1, 0.01);
  EXPECT_EQ(r.get("results", "fit_nodes"), 2);
  EXPECT_NEAR(r.get("results", "hysteresis"), 0, 1e-5);
  // Its area is kept better than its height: it widens, and the force grows faster than the compression.
  EXPECT_GT(column(r, "width")[60], 1.07);
  EXPECT_LT(column(r, "volume_change")[60], 0);
  const std::vector<double> local = r.tables.at("local_exponents").column("exponent");
  EXPECT_NEAR(local.front(), 1, 1e-3);
  EXPECT_GT(*std::max_element(local.begin(), local.end()), 1.1);
}

TEST(PlateCompression, StandsBetweenTwoPlatesAlone) {
  const auto p = packing_between_plates<3>(case_of("[bodies]\ndim = 3\n[contact]\nk_p = 5\n"), nullptr, {});
  using Stands = std::array<std::array<bool, 2>, 3>;
  EXPECT_EQ(p.field->walls()->stands, (Stands{{{false, false}, {false, false}, {true, true}}}));
  EXPECT_EQ(p.field->walls()->repulsion.stiffness, 5);
  EXPECT_EQ(p.system.box.periodic, (std::array{false, false, false}));
}

/// Where plates yield more than the shell, five vertices touch each over a decade of a force in proportion.
TEST(PlateCompression, AStiffShellTouchesWithFiveVerticesOverADecade) {
  const auto r = run_of<2>(
      "[bodies]\nvertices = 100\nk_a = 14\nk_l = 100\nk_b = 1000\n[plates]\nstrain = 0.5\nsteps = "
      "74\ndecompress = "
      "false\n");
  EXPECT_GE(r.get("results", "fit_nodes"), 5);
  EXPECT_GT(r.get("results", "fit_to"), 9.9 * r.get("results", "fit_from"));
  EXPECT_NEAR(r.get("results", "exponent"), 1, 0.05);
}

/// Each step begins where the last two lead to, which is near its minimum.
TEST(PlateCompression, StepsNeedFewEvaluations) {
  const auto per_step = [](const std::string& text) {
    const auto r = run_of<2>(text);
    return r.get("results", "evaluations") / r.get("results", "minimisations");
  };
  const std::string plates = "[plates]\nstrain = 0.02\n";
  EXPECT_LT(per_step(ring + plates), 10);
  EXPECT_LT(per_step(ring + plates + "[minimise]\nmethod = \"auto\"\n"), 600);
  EXPECT_EQ(case_of("[bodies]\ndim = 3\nvertices = 642\n").minimise.method, "auto");
}

/// What the plate does is what the particle stores: by the trapezoidal rule, as fine as the steps are.
TEST(PlateCompression, TheWorkOfThePlateIsStored) {
  const auto r =
      run_of<2>("[bodies]\nvertices = 30\n[plates]\nstrain = 0.2\nsteps = 100\nspacing = \"linear\"\n");
  EXPECT_NEAR(column(r, "energy")[100] / r.get("results", "work"), 1, 3e-4);
  const auto solid =
      run_of<3>("[bodies]\ndim = 3\nvertices = 42\n[plates]\nsteps = 50\nspacing = \"linear\"\n");
  EXPECT_NEAR(column(solid, "energy")[50] / solid.get("results", "work"), 1, 1e-3);
  EXPECT_NEAR(solid.get("results", "hysteresis"), 0, 1e-5);
}

TEST(PlateCompression, AShellIn3dYieldsInProportion) {
  const auto r = run_of<3>(
      "[bodies]\ndim = 3\nvertices = 162\n[plates]\nsteps = 25\nstrain = 0.02\nfit_from = 1e-4\nfit_to = "
      "1e-2\ndecompress = false\n");
  EXPECT_NEAR(r.get("results", "exponent"), 1, 0.02);
  EXPECT_EQ(r.get("results", "fit_nodes"), 3);
  EXPECT_EQ(r.info.body_begin.size(), 2u);
  EXPECT_EQ(r.tables.at("plates").columns[2].unit, "k_v v0 D^2");
  EXPECT_GT(column(r, "width").back(), 1.001);
}

/// Nodes that touch each plate at the first of two compressions.
template <int Dim>
std::pair<double, double> first_nodes(const std::string& bodies, const char* orientation) {
  const auto r = run_of<Dim>(bodies + "[plates]\nsteps = 2\nfirst = 1e-5\nstrain = 2e-5\ndecompress = " +
                             "false\norientation = \"" + orientation + "\"\n");
  return {column(r, "lower_nodes")[1], column(r, "upper_nodes")[1]};
}

TEST(PlateCompression, TurnsAnEdgeATriangleOrAVertexDown) {
  using Nodes = std::pair<double, double>;
  const std::string flat = "[bodies]\nvertices = 10\n", odd = "[bodies]\nvertices = 9\n",
                    rigid = "[bodies]\nvertices = 10\nfamily = \"rough_disc\"\n",
                    solid = "[bodies]\ndim = 3\nvertices = 42\n",
                    ball = "[bodies]\ndim = 3\nvertices = 42\nfamily = \"rough_sphere\"\n";
  for (const std::string& one : {flat, rigid}) {
    EXPECT_EQ(first_nodes<2>(one, "flat"), Nodes(2, 2)) << one;
    EXPECT_EQ(first_nodes<2>(one, "corner"), Nodes(1, 1)) << one;
  }
  EXPECT_EQ(first_nodes<2>(odd, "flat"), Nodes(2, 1));
  for (const std::string& one : {solid, ball}) {
    EXPECT_EQ(first_nodes<3>(one, "flat"), Nodes(3, 3)) << one;
    EXPECT_EQ(first_nodes<3>(one, "corner"), Nodes(1, 1)) << one;
  }
}

/// A rigid polygon on a corner between plates that come nearer rolls until it lies on edges.
TEST(PlateCompression, SaysHowFarAParticleHasRolled) {
  const std::string rigid =
      "[bodies]\nvertices = 6\nfamily = \"rough_disc\"\n[plates]\nstrain = 0.05\nsteps = "
      "20\nspacing = \"linear\"\ndecompress = false\norientation = ";
  EXPECT_NEAR(run_of<2>(rigid + "\"flat\"").get("results", "largest_rotation"), 0, 1e-6);
  const auto rolled = run_of<2>(rigid + "\"as_made\"");
  EXPECT_GT(rolled.get("results", "largest_rotation"), 0.1);
  EXPECT_GT(column(rolled, "rotation").back(), 0.1);
}

/// Turned at random, it is as high as a polygon is between lying on edges and standing on corners.
TEST(PlateCompression, LeavesAParticleAsItIsMade) {
  const auto diameter = [](const char* orientation, int seed) {
    return run_of<2>("seed = " + std::to_string(seed) +
                     "\n[bodies]\nvertices = 4\n[plates]\nsteps = 1\norientation = \"" + orientation + "\"\n")
        .get("results", "diameter");
  };
  EXPECT_LT(diameter("flat", 1) + 0.05, diameter("as_made", 1));
  EXPECT_LT(diameter("as_made", 1) + 0.02, diameter("corner", 1));
  EXPECT_NE(diameter("as_made", 1), diameter("as_made", 2));
  EXPECT_NEAR(diameter("corner", 1), diameter("corner", 2), 1e-12);
}

/// The square of the state lies on its third edge, which the first one would be turned to.
TEST(PlateCompression, GoesOnFromAStateAsItLies) {
  InitialState state;
  System<2>& square = state.system.emplace<System<2>>();
  add_polygon(square, {1, 1}, 1, 4, pi / 4, 1, {});
  square.box.length = {9, 9};
  const auto r = run_of<2>("[plates]\nsteps = 4\n", &state);
  EXPECT_EQ(column(r, "lower_nodes")[1], 2);
  const std::vector<Vec2>& x = r.last_system.state.position;
  EXPECT_GT(x[0][1], x[3][1] + 0.9);
  EXPECT_EQ(r.last_system.box.periodic, (std::array{false, false}));
  EXPECT_NEAR(r.last_system.box.length[1], r.get("results", "diameter"), 1e-15);
}

TEST(PlateCompression, FitsFromFiveNodesOnOrADecade) {
  const auto r = run_of<2>(
      "[bodies]\nvertices = 100\nk_b = 1e-3\n[plates]\nstrain = 0.4\nfirst = 1e-2\nsteps = 30\ndecompress = "
      "false\n");
  EXPECT_NEAR(r.get("results", "fit_from"), 0.04, 0.004);  // five nodes touch later: a decade
  EXPECT_NEAR(r.get("results", "fit_to"), 0.4, 1e-12);
  EXPECT_GT(r.get("results", "touching_nodes"), 10);
}

TEST(PlateCompression, KeepsFramesWithTheirCompression) {
  const auto r = run_of<2>("[bodies]\nvertices = 10\n[plates]\nsteps = 10\n[output]\nframes = 5\n");
  ASSERT_EQ(r.frames.size(), 5u);
  const std::vector<double> x = column(r, "compression");
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_EQ(r.frames[k].numbers.at("uniaxial_strain"), x[5 * k]);
    EXPECT_EQ(r.frames[k].length[1], column(r, "gap")[5 * k]);
  }
}

TEST(PlateCompression, RefusesWhatCannotBe) {
  const auto refuses = [](const std::string& text, const char* what) {
    EXPECT_THAT(caught([&] { case_of(text); }), ::testing::HasSubstr(what)) << text;
  };
  refuses("[bodies]\nN = 2\n", "bodies.N = 2");
  refuses("[plates]\nfirst = 0.2\n", "plates.first = 0.2 is not below plates.strain = 0.1");
  refuses("[plates]\nfit_from = 0.02\nfit_to = 0.01\n", "plates.fit_from = 0.02");
  refuses("[plates]\nfit_from = 0.2\n", "plates.strain = 0.1");
  refuses("[bodies]\nsize_ratio = 2\n", "bodies.size_ratio");
  refuses("[[species]]\nN = 1\n", "species.1.N");
  InitialState two;
  System<2>& system = two.system.emplace<System<2>>();
  for (const double x : {1.0, 4.0}) add_polygon(system, {x, 1}, 1, 6, 0, 1, {});
  system.box.length = {9, 9};
  MemoryRecorder recorder;
  EXPECT_THAT(caught([&] { run(case_of(""), &two, recorder); }),
              ::testing::HasSubstr("2 particles between the plates"));
}

TEST(PlateCompression, DoubtsKeysWithoutEffect) {
  EXPECT_THAT(find_doubts(case_of("[plates]\nspacing = \"linear\"\nfirst = 1e-3\n")),
              ::testing::Contains(::testing::HasSubstr("plates.first has no effect")));
  EXPECT_THAT(find_doubts(case_of("[bodies]\nfamily = \"disc\"\n[plates]\norientation = \"corner\"\n")),
              ::testing::Contains(::testing::HasSubstr("plates.orientation has no effect")));
}

}  // namespace
}  // namespace supple
