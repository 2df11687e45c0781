/// Contacts of pairs of species in a case: [contact.A.B].
#include "supple/experiment/pairs_of_case.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "supple/experiment/body_rheology.hpp"
#include "supple/experiment/jam.hpp"
#include "supple/experiment/packing_record.hpp"
#include "supple/io/text/case_file.hpp"
#include "supple/model/bodies.hpp"
#include "tests/experiment/error_of.hpp"

namespace supple {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr const char* mixture = R"(
experiment = "jamming"
[[species]]
name = "soft"
N = 9
vertices = 10
[[species]]
family = "disc"
N = 6
[[species]]
name = "stiff"
family = "rough_disc"
N = 5
vertices = 9
[jamming]
pressure = 1e-3
packing_fraction = 0.3
[contact]
k_c = 2
)";
constexpr const char* pairs = R"(
[contact.stiff.soft]
law = "adhesive"
k_c = 3
[contact.soft.soft]
k_c = 0.5
[contact.2.stiff]
law = "hertz"
)";

Case read(const std::string& text, const std::vector<std::string>& overrides = {}) {
  Case c = read_case_text(text, "mix.toml", overrides);
  resolve_family(c);
  return c;
}

std::string error_in(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    return error_of(read(text, overrides));
  } catch (const Error& e) {
    return e.what();
  }
}

TEST(PairsOfCase, TakeWhatTheyAreNotGivenFromContact) {
  const Case c = read(std::string(mixture) + pairs, {"contact.attraction_range=0.2"});
  ASSERT_EQ(error_of(c), "no error");
  EXPECT_THAT(find_doubts(c), IsEmpty());
  const ContactLaws laws = contact_laws(c);
  EXPECT_EQ(laws.common().scale().stiffness, 2);
  for (const auto& [a, b, k, range] :
       {std::tuple{0, 2, 3., 1.2}, {2, 0, 3., 1.2}, {0, 0, 0.5, 1.}, {1, 2, 2., 1.}, {2, 2, 2., 1.}}) {
    EXPECT_EQ(laws.of(a, b).scale().stiffness, k) << a << b;
    EXPECT_EQ(laws.of(a, b).range(), range) << a << b;
    EXPECT_TRUE(laws.of(a, b).scale().relative);
  }
  EXPECT_FALSE(laws.of(2, 1).is_harmonic());
  EXPECT_TRUE(laws.of(1, 1).is_harmonic());
}

TEST(PairsOfCase, AreSetByEitherOrderAndWrittenAsRead) {
  const Case c = read(std::string(mixture) + pairs,
                      {"contact.soft.stiff.k_c=7", "contact.2.2.law=hertz", "contact.soft.2.k_c = 4"});
  const Case again = read_case_text(write_case(c, CaseStyle::resolved), "run");
  for (const Case& made : {c, again}) {
    const ContactLaws laws = contact_laws(made);
    EXPECT_EQ(laws.of(2, 0).scale().stiffness, 7);
    EXPECT_EQ(laws.of(0, 1).scale().stiffness, 4);
    EXPECT_FALSE(laws.of(1, 1).is_harmonic());
    EXPECT_EQ(made.pairs.size(), 5u);
  }
  // What is not given is as in [contact] also in what is written.
  EXPECT_THAT(write_case(c, CaseStyle::resolved), Not(HasSubstr("[contact.2.2]\nlaw = \"hertz\"\nk_c")));
  EXPECT_EQ(
      contact_laws(read(write_case(c, CaseStyle::resolved), {"contact.k_c=9"})).of(1, 1).scale().stiffness,
      9);
}

TEST(PairsOfCase, MistakesNameTheNearestChoice) {
  const std::string m = mixture;
  EXPECT_THAT(error_in(m + "[contact.soft.stif]\nk_c = 1\n"),
              HasSubstr("[contact.soft.stif] (there is no species \"stif\"); did you mean \"stiff\"?"));
  EXPECT_THAT(error_in(m + "[contact.soft.1]\nk_c = 1\n"), HasSubstr("the species are soft, 2, stiff"));
  EXPECT_THAT(error_in("experiment = \"jamming\"\n[contact.a.b]\nk_c = 1\n"),
              HasSubstr("there are no [[species]]"));
  EXPECT_THAT(error_in(m + "[contact.soft.stiff]\nk_c = 1\n[contact.stiff.soft]\nk_c = 2\n"),
              HasSubstr("[contact.stiff.soft] and [contact.soft.stiff] are the same"));
  EXPECT_THAT(error_in(m + "[contact.soft]\nk_c = 1\n"), HasSubstr("[contact.soft] names one species"));
  EXPECT_THAT(error_in(m, {"contact.soft.k_c=1"}), HasSubstr("does not name two species"));
  EXPECT_THAT(error_in(m + "[contact.soft.soft]\nk_p = 1\n"), HasSubstr("'k_p' belongs in [contact]"));
  EXPECT_THAT(error_in(m + "[contact.soft.soft]\nk_cc = 1\n"), HasSubstr("did you mean 'k_c'?"));
  EXPECT_THAT(error_in(m + "[contact.soft.soft]\nlaw = \"adhesiv\"\n"),
              HasSubstr("did you mean \"adhesive\"?"));
  EXPECT_THAT(error_in(m + "[contact.soft.soft]\nk_c = 0\n"),
              HasSubstr("contact.soft.soft.k_c = 0 is out of range"));
  EXPECT_THAT(error_in(m + "[contact.soft.soft]\nfriction = 1\n"),
              HasSubstr("contact.soft.soft.friction has no effect"));
  EXPECT_THAT(error_in("[contact.a.b]\nk_c = 1\n"), HasSubstr("contact.a.b.k_c has no effect"));
}

TEST(PairsOfCase, NamesOfSpeciesAreWords) {
  const auto named = [](const char* name) {
    return error_in(mixture, {fmt::format("species.2.name='{}'", name)});
  };
  EXPECT_EQ(named("a-b_7"), "no error");
  EXPECT_THAT(named("a b"), HasSubstr("use letters, digits, - and _"));
  EXPECT_THAT(named("12"), HasSubstr("numbers are the places of species"));
  EXPECT_THAT(named("law"), HasSubstr("contact.law is a key"));
  EXPECT_THAT(named("soft"), HasSubstr("species.1 has this name, too"));
}

TEST(PairsOfCase, KeysWithoutEffectAreDoubted) {
  const Case c =
      read(std::string(mixture) + "[contact.soft.soft]\nattraction_range = 0.3\n[contact.2.soft]\n");
  EXPECT_THAT(find_doubts(c),
              ElementsAre(HasSubstr("[contact.2.soft] has no keys"),
                          HasSubstr("contact.soft.soft.attraction_range has no effect without "
                                    "contact.soft.soft.law = \"adhesive\"")));
}

TEST(PairsOfCase, ParticlesKnowTheirSpecies) {
  const Case c = read(mixture);
  for (const Places places : {Places::random, Places::apart}) {
    const Packing<2> packing = make_packing(c, nullptr, 0.3, {places});
    const std::vector<std::int32_t>& species = packing.system.species;
    ASSERT_EQ(species.size(), 20u);
    EXPECT_EQ(std::count(species.begin(), species.end(), 0), 9);
    EXPECT_EQ(std::count(species.begin(), species.end(), 1), 6);
    EXPECT_EQ(species.back(), 2);
    EXPECT_EQ(packing.system.topology.body_size(14), 1);
  }
}

/// A packing whose pairs adhere, or are soft: its stress is -(1/A) dU/d(strain), and the minimiser has found
/// its equilibrium.
TEST(PairsOfCase, StressOfAJammedMixtureIsTheSlopeOfItsEnergy) {
  bool pulls = false;  // which contacts are stretched depends on the way to the packing
  for (const char* kind : {"rough", "smooth"}) {
    SCOPED_TRACE(kind);
    std::string text = std::string(mixture) + pairs;
    std::vector<std::string> more{std::string("contact.kind=") + kind, "jamming.pressure=2e-2"};
    if (std::string(kind) == "smooth") more.push_back("species.3.family=disc");
    const Case c = read(text, more);
    ASSERT_EQ(error_of(c), "no error");
    Packing<2> packing = make_packing(c, nullptr, c.jamming.packing_fraction);
    const JamProgress<2> end = jam(packing, jam_spec(c));
    EXPECT_TRUE(end.last.converged);
    EXPECT_NEAR(end.state.pressure, 2e-2, 2.1e-4);
    const PackingReport<2> report = report_packing(packing);
    const auto energy_at = [&](double strain) {
      Packing<2> moved = packing;
      for (Vec2& x : moved.system.state.position) x[0] += strain * x[1];
      for (Vec2& x : moved.system.rigid.centre) x[0] += strain * x[1];
      moved.system.box.strain += strain;
      moved.field->invalidate();
      Evaluation<2> out;
      moved.field->evaluate(moved.system, Detail::energies, out);
      return out.energy.stored();
    };
    constexpr double h = 1e-5;
    const double slope = (energy_at(h) - energy_at(-h)) / (2 * h);
    const Mat2& virial = report.evaluation.virial;
    if (packing.system.rigid.empty()) {  // else its sites would turn, and the others follow
      EXPECT_NEAR(virial[0][1], -slope, 1e-7 * (virial[0][0] + virial[1][1]));
    }
    const Mat2 of_bodies = report.stresses.virial();
    EXPECT_NEAR(of_bodies[0][0] * packing.system.box.volume(), virial[0][0], 1e-9 * virial[0][0]);
    for (const SiteContact<2>& contact : report.contacts) {
      const auto a = packing.system.species[contact.body], b = packing.system.species[contact.other_body];
      EXPECT_EQ(contact.holds, a != b && a != 1 && b != 1);
      pulls = pulls || contact.pulls;
    }
  }
  EXPECT_TRUE(pulls);
}

TEST(PairsOfCase, FrictionAndViscosityAreThoseOfThePair) {
  const Case c = read(std::string(mixture) + R"(
[contact.soft.stiff]
k_c = 8
friction = 0.7
[contact.soft.soft]
relative_viscosity = 0.3
[material]
friction = 0.1
interface_reenforcement_central = 0.5
)",
                      {"experiment=oscillatory_shear", "physics=deformable"});
  const Packing<2> packing = make_packing(c, nullptr, 0.3, {Places::apart});
  const BodyLaws laws = body_laws(c, packing);
  EXPECT_EQ(laws.touch.common().friction, 0.1);
  EXPECT_EQ(laws.touch.of(0, 2).friction, 0.7);
  EXPECT_EQ(laws.touch.of(0, 0).friction, 0.1);
  EXPECT_NEAR(laws.touch.of(0, 2).k_t, 4 * laws.touch.common().k_t, 1e-12);
  EXPECT_NEAR(laws.touch.of(2, 0).eta, 2 * laws.touch.common().eta, 1e-12);  // v sqrt(m k)
  EXPECT_NEAR(laws.touch.of(0, 0).eta, 3 * laws.touch.common().eta, 1e-12);
  EXPECT_NEAR(laws.link.of(2, 0).k, 4 * laws.link.common().k, 1e-12);
  EXPECT_NEAR(laws.link.of(2, 0).k, 8 * laws.k, 1e-12);
  double found = 0;
  for (const Derived& d : derived_laws(laws))
    if (d.name.name == "friction.soft.stiff") found = d.value;
  EXPECT_EQ(found, 0.7);
}

/// The leapfrog of a sheared mixture resolves the tangential springs and the dashpots of every pair.
TEST(PairsOfCase, PairThatRubsMostBoundsTheStepOfSheared) {
  const auto step = [](const std::string& more) {
    const Case c =
        read(std::string(mixture) + "[material]\nfriction = 0.1\nrelative_viscosity = 0.01\n" +
                 "relative_transversal_link_strength = 10\n" + more,
             {"experiment=oscillatory_shear", "physics=deformable", "particles.permanent_links=false"});
    Packing<2> packing = make_packing(c, nullptr, 0.3, {Places::apart});
    const BodyLaws laws = body_laws(c, packing);
    return sheared_body_step(c, laws, packing);
  };
  const double plain = step("");
  EXPECT_EQ(step("[contact.soft.stiff]\nfriction = 0.2\n"), plain);
  EXPECT_LT(step("[contact.soft.stiff]\nrelative_viscosity = 1\n"), 0.9 * plain);
  EXPECT_LT(step("[contact.soft.stiff]\nk_c = 200\n"), 0.2 * plain);
}

/// Friction of one pair alone: its spring is resolved, and the others do not rub.
TEST(PairsOfCase, OnePairAloneMayRub) {
  const std::vector<std::string> sheared{"experiment=oscillatory_shear", "physics=deformable",
                                         "material.friction=0", "material.relative_viscosity=0"};
  const auto laws_of = [&](const std::string& more, Packing<2>& packing, double& step) {
    const Case c = read(std::string(mixture) + more, sheared);
    packing = make_packing(c, nullptr, 0.3, {Places::apart});
    const BodyLaws laws = body_laws(c, packing);
    step = sheared_body_step(c, laws, packing);
    add_rheology(laws, packing);
    return laws;
  };
  Packing<2> smooth, rough;
  double of_smooth = 0, of_rough = 0;
  const std::string springs =
      "[material]\nrelative_transversal_link_strength = 40\n"
      "interface_reenforcement_tangential = 1000\n";
  laws_of(springs, smooth, of_smooth);
  const BodyLaws laws = laws_of(springs + "[contact.soft.stiff]\nfriction = 0.4\n", rough, of_rough);
  EXPECT_EQ(laws.touch.common().k_t, 0);
  EXPECT_GT(laws.touch.of(0, 2).k_t, 0);
  EXPECT_EQ(rough.field->interactions().size(), smooth.field->interactions().size() + 1);
  EXPECT_LT(of_rough, 0.5 * of_smooth);
}

}  // namespace
}  // namespace supple
