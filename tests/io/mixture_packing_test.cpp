/// Packings of several kinds of particles as JSON.
#include <gmock/gmock.h>

#include <fstream>

#include "supple/core/path_kind.hpp"
#include "supple/experiment/packing.hpp"
#include "supple/experiment/pairs_of_case.hpp"
#include "tests/io/continued_run.hpp"
#include "tests/io/same_system.hpp"

namespace supple {
namespace {

using ::testing::HasSubstr;

class MixturePacking : public testing::ContinuedRun {
 protected:
  StoredPacking mixture(const char* stiffness = "relative") {
    Case c = testing::case_of(fmt::format(R"(
experiment = "jamming"
[bodies]
stiffness = "{}"
[[species]]
name = "shell"
N = 4
vertices = 10
k_perimeter = 0.3
[[species]]
family = "droplet"
N = 3
vertices = 12
[[species]]
name = "grain"
family = "disc"
N = 2
[[species]]
family = "rough_disc"
N = 2
vertices = 9
[contact.grain.shell]
law = "adhesive"
k_c = 3
[jamming]
packing_fraction = 0.3
)",
                                          stiffness));
    StoredPacking packing;
    packing.system = make_packing(c, nullptr, 0.3).system;
    packing.system.pairs = {};
    packing.keys = held_keys(c);
    return packing;
  }
  StoredPacking again(const StoredPacking& packing) {
    write_packing_json(packing, in_folder("mix_packing.json"), Existing::replace);
    return read_packing_json(in_folder("mix_packing.json"));
  }
};

TEST_F(MixturePacking, IsReadAsItIsWritten) {
  for (const char* stiffness : {"relative", "absolute"}) {
    SCOPED_TRACE(stiffness);
    const StoredPacking packing = mixture(stiffness), read = again(packing);
    const System<2>&a = packing.system, &b = read.system;
    EXPECT_EQ(a.species, b.species);
    EXPECT_EQ(a.state.position, b.state.position);
    EXPECT_EQ(a.shape.rest_facet, b.shape.rest_facet);
    for (std::size_t k = 0; k < a.shape.stiffness.size(); ++k) {
      EXPECT_NEAR(a.shape.stiffness[k].volume, b.shape.stiffness[k].volume, 1e-14) << k;
      EXPECT_NEAR(a.shape.stiffness[k].facet, b.shape.stiffness[k].facet, 1e-12) << k;
      EXPECT_NEAR(a.shape.stiffness[k].hinge, b.shape.stiffness[k].hinge, 1e-14) << k;
      EXPECT_NEAR(a.shape.stiffness[k].tension, b.shape.stiffness[k].tension, 1e-14) << k;
    }
    ASSERT_EQ(b.terms.size(), 1u);
    for (std::size_t k = 0; k < 8; ++k) EXPECT_NEAR(a.terms[0].number[k], b.terms[0].number[k], 1e-13);
    EXPECT_EQ(b.terms[0].bodies(), 4u);
  }
}

TEST_F(MixturePacking, ItsPairsOfSpeciesHoldInARunFromIt) {
  again(mixture());
  const InitialState initial = load("mix_packing.json");
  Case c = testing::case_of("experiment = \"compression\"\n[contact.2.grain]\nk_c = 5\n");
  c.initial.packing = "mix_packing.json";
  c = adopt_state(c, &initial);
  check(c, &initial);
  ASSERT_EQ(c.species.size(), 4u);
  EXPECT_EQ(c.species[1].count, 3);
  EXPECT_EQ(c.species[2].name, "grain");
  const ContactLaws laws = make_packing(c, &initial, 0).field->bodies()->laws();
  EXPECT_EQ(laws.of(0, 2).scale().stiffness, 3);
  EXPECT_EQ(laws.of(2, 0).range(), 1.1);
  EXPECT_EQ(laws.of(1, 2).scale().stiffness, 5);
}

TEST_F(MixturePacking, MistakesNameTheParticle) {
  write_packing_json(mixture(), in_folder("good.json"));
  const std::string good = read_whole_file(in_folder("good.json"), "a packing", 1 << 20);
  const auto error = [&](const std::string& from, const std::string& to) -> std::string {
    std::string text = good;
    text.replace(text.find(from), from.size(), to);
    std::ofstream(in_folder("bad.json")) << text;
    try {
      read_packing_json(in_folder("bad.json"));
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::file);
      return e.what();
    }
    return "";
  };
  EXPECT_THAT(error("\"species\": \"grain\"", "\"species\": \"grian\""),
              HasSubstr("particles[7].species is \"grian\", not one of"));
  EXPECT_THAT(error("\"species\": \"grain\"", "\"k_a\": 2, \"species\": \"grain\""),
              HasSubstr("k_a of a particle that does not deform"));
  EXPECT_THAT(error("  \"2\",\n", "  \"shell\",\n"), HasSubstr("species[1] is \"shell\" again"));
  EXPECT_THAT(error("   \"species\": \"grain\"", "   \"sigma\": 1"),
              HasSubstr("particles[7] has no \"species\""));
}

}  // namespace
}  // namespace supple
