/// Samples of several kinds of particles.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "supple/experiment/bodies_of_case.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/io/text/case_file.hpp"
#include "supple/model/polygons.hpp"
#include "supple/observe/shape_measures.hpp"
#include "tests/experiment/error_of.hpp"

namespace supple {
namespace {

using ::testing::HasSubstr;

Case read(const std::string& text, const std::vector<std::string>& overrides = {}) {
  Case c = read_case_text(text, "mix.toml", overrides);
  resolve_family(c);
  return c;
}

std::string error_in(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    read(text, overrides);
  } catch (const Error& e) {
    return e.what();
  }
  return "no error";
}

constexpr const char* jam = R"(
experiment = "jamming"
[jamming]
pressure = 1e-3
packing_fraction = 0.3
)";

constexpr const char* mixture = R"(
[[species]]
family = "shell"
N = 6
vertices = 12
diameter = 1.3
[[species]]
family = "droplet"
N = 5
vertices = 16
k_l = 0.3
[[species]]
family = "rough_disc"
N = 4
vertices = 10
diameter = 0.8
[[species]]
family = "disc"
N = 3
[[species]]
family = "floppy"
N = 4
vertices = 18
A0_ratio = 1.1
)";

MemoryRecorder run_of(const Case& c) {
  MemoryRecorder recorder;
  run(c, nullptr, recorder);
  return recorder;
}

TEST(Species, BodiesAreTheSameAsTheirSpecies) {
  const Case bodies = read(std::string(jam) + R"(
[bodies]
N = 8
vertices = 10
size_ratio = 1.3
vertex_rule = "scaled"
large_fraction = 0.25
A0_ratio = 1.05
discs = 3
)"),
             species = read(std::string(jam) + R"(
[[species]]
N = 6
vertices = 10
A0_ratio = 1.05
[[species]]
N = 2
vertices = 13
A0_ratio = 1.05
diameter = 1.3
[[species]]
family = "disc"
N = 3
)");
  const MemoryRecorder a = run_of(bodies), b = run_of(species);
  EXPECT_EQ(a.last_system.state.position, b.last_system.state.position);
  EXPECT_EQ(a.last_system.box.length, b.last_system.box.length);
  EXPECT_EQ(a.get("results", "pressure"), b.get("results", "pressure"));
}

TEST(Species, OfAllFamiliesJamTogether) {
  const Case c = read(std::string(jam) + mixture);
  ASSERT_EQ(error_of(c), "no error");
  const MemoryRecorder recorder = run_of(c);
  EXPECT_TRUE(recorder.warnings.empty()) << recorder.warnings.front();
  EXPECT_NEAR(recorder.get("results", "pressure"), 1e-3, 1.1e-5);
  const System<2>& s = recorder.last_system;
  ASSERT_EQ(s.topology.body_count(s.state.size()), 22);
  const auto sites = [&](int body) {
    return (body + 1 < 22 ? s.topology.begin[body + 1] : s.state.size()) - s.topology.begin[body];
  };
  for (const auto& [body, wanted] :
       {std::pair{0, 12}, {5, 12}, {6, 16}, {11, 10}, {15, 1}, {17, 1}, {18, 18}})
    EXPECT_EQ(sites(body), wanted) << body;
  EXPECT_NEAR(s.shape.rest_volume[0], 1.69, 1e-14);
  EXPECT_NEAR(s.shape.rest_volume[6], 1, 1e-14);
  EXPECT_GT(s.shape.stiffness[6].tension, 0);
  EXPECT_EQ(s.shape.stiffness[0].tension, 0);
  EXPECT_GT(s.shape.stiffness[0].hinge, 0);
  EXPECT_EQ(s.shape.stiffness[18].hinge, 0);
  EXPECT_EQ(s.rigid.size(), 4u);
  // p^2/(4 pi a) of the rest lengths is as asked
  double perimeter = 0;
  for (int f = s.topology.facet_begin[18]; f < s.topology.facet_begin[19]; ++f)
    perimeter += s.shape.rest_facet[f];
  EXPECT_NEAR(perimeter * perimeter / (4 * std::numbers::pi * s.shape.rest_volume[18]),
              1.1 * least_shape_parameter(18), 1e-12);
}

TEST(Species, HaveTheNumbersOfTheirFamilyUnlessGiven) {
  const Case c = read(mixture);
  EXPECT_EQ(c.species[0].k_b, 0.05);
  EXPECT_EQ(c.species[1].gamma, 0.2);
  EXPECT_EQ(c.species[1].k_l, 0.3);
  EXPECT_EQ(c.species[4].k_b, 0);
  EXPECT_EQ(c.species[4].shape_parameter, 0);  // A0_ratio says it
}

TEST(Species, AreWrittenAsTheyAreRead) {
  Case c = read(std::string(jam) + mixture);
  const Case again = read_case_text(write_case(c, CaseStyle::resolved), "run");
  ASSERT_EQ(again.species.size(), 5u);
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_EQ(again.species[k].family, c.species[k].family);
    EXPECT_EQ(again.species[k].count, c.species[k].count);
    EXPECT_EQ(again.species[k].diameter, c.species[k].diameter);
    EXPECT_EQ(again.species[k].k_l, c.species[k].k_l);
  }
}

TEST(Species, OneOfThemIsSetByItsPlace) {
  EXPECT_EQ(read(mixture, {"species.2.N=7"}).species[1].count, 7);
  EXPECT_EQ(read(mixture, {"species.3.family=disc"}).species[2].family, "disc");
  EXPECT_THAT(error_in(mixture, {"species.9.N=7"}), HasSubstr("species.9"));
}

TEST(Species, MistakesAreNamedWithTheirPlace) {
  EXPECT_THAT(error_in("[species]\nN = 3\n"), HasSubstr("write [[species]]"));
  EXPECT_THAT(error_in("[[species]]\nN = 3\n[[species]]\nverticse = 3\n"),
              HasSubstr("unknown key 'verticse' in [species.2]"));
  EXPECT_THAT(error_in("[[species]]\nN = 3\n[[species]]\nN = 0\n"), HasSubstr("species.2.N = 0"));
  EXPECT_THAT(error_of(read(std::string(jam) + mixture + "[bodies]\nN = 5\n")),
              HasSubstr("bodies.N with [[species]]"));
  EXPECT_THAT(error_of(read(std::string(jam) + "[[species]]\nA0 = 0.9\n")), HasSubstr("species.1.A0 = 0.9"));
  EXPECT_THAT(error_of(read("[[species]]\nN = 3\n")), HasSubstr("species.1.N has no effect"));
}

}  // namespace
}  // namespace supple
