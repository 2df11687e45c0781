/// Elastic solids of a case: how they are made, jam, move and go on.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "supple/build/solid_bodies.hpp"
#include "supple/experiment/adopt_state.hpp"
#include "supple/experiment/bodies_of_case.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/experiment/given_packing.hpp"
#include "supple/experiment/jam.hpp"
#include "supple/io/text/case_file.hpp"
#include "tests/experiment/error_of.hpp"

namespace supple {
namespace {

using ::testing::HasSubstr;

Case read(const std::string& text) {
  Case c = read_case_text(text, "solids.toml");
  resolve_family(c);
  experiment_of(c).complete(c);
  return c;
}

Case jam_of(const std::string& bodies) {
  return read("experiment = \"jamming\"\n[bodies]\nlarge_fraction = 0.5\n" + bodies +
              "[jamming]\npacking_fraction = 0.4\nstep = 0.02\npressure = 1e-4\n");
}

TEST(Solids, OfACaseAreAsStiffAsItSays) {
  const auto first = [](const Case& c) { return *nominal_constants(particles_apart(c), 0); };
  const auto by_spring = first(jam_of("family = \"network\"\nN = 2\nvertices = 120\nk_s = 0.5\n"));
  // Of the triangular lattice; a disc of few nodes has fewer springs, as those of its boundary have no
  // others.
  EXPECT_NEAR(by_spring.young_modulus, 1 / std::numbers::sqrt3, 0.06);
  EXPECT_NEAR(by_spring.poisson_ratio, 1.0 / 3, 1e-15);
  EXPECT_NEAR(first(jam_of("family = \"network\"\nN = 2\nE = 2.5\n")).young_modulus, 2.5, 1e-13);
  const auto elastic = first(jam_of("family = \"elastic\"\nN = 2\nE = 2.5\nnu = 0.7\n"));
  EXPECT_NEAR(elastic.young_modulus, 2.5, 1e-13);
  EXPECT_NEAR(elastic.poisson_ratio, 0.7, 1e-13);
}

TEST(Solids, ContradictionsAreRefused) {
  EXPECT_THAT(error_of(jam_of("family = \"network\"\nE = 1\nk_s = 1\n")),
              HasSubstr("one follows from the other"));
  EXPECT_THAT(error_of(jam_of("family = \"network\"\nk_s = 0\n")),
              HasSubstr("nothing keeps the network together"));
  EXPECT_THAT(error_of(jam_of("dim = 3\nfamily = \"elastic\"\nnu = 0.5\n")), HasSubstr("give less than 0.5"));
  EXPECT_THAT(error_of(jam_of("dim = 3\nfamily = \"elastic\"\nvertices = 50\n")), HasSubstr("take 42"));
  EXPECT_EQ(error_of(jam_of("dim = 3\nfamily = \"network\"\nvertices = 50\n")), "no error");
}

TEST(Solids, JamBesideShells) {
  const Case c = read(R"(
experiment = "jamming"
[[species]]
family = "network"
N = 4
vertices = 40
[[species]]
family = "elastic"
N = 4
vertices = 16
E = 2
[[species]]
family = "shell"
N = 4
vertices = 16
[jamming]
packing_fraction = 0.4
step = 0.02
pressure = 1e-3
)");
  MemoryRecorder recorder;
  run(c, nullptr, recorder);
  EXPECT_GT(recorder.get("results", "pressure"), 1e-3);
  EXPECT_LT(recorder.get("results", "pressure"), 1.01e-3);
  EXPECT_EQ(recorder.last_system.solid.bodies(), 8);
  EXPECT_FALSE(recorder.info.bond.empty());
  EXPECT_EQ(recorder.info.boundary_sites.size(), 12u);
}

/// The bound by which a search gives a minimisation up must hold for what is inside, too.
TEST(Solids, HaveTheEnergyThatTheirPressureNeeds) {
  for (const char* family : {"network", "elastic"}) {
    Case c = jam_of("N = 8\nvertices = 30\nfamily = \"" + std::string(family) + "\"\n");
    c.jamming.pressure = 1e-3;
    c.contact.k_c = 0.05;  // so soft that a bound by contacts alone would be far too high
    Packing<2> packing = make_packing(c, nullptr, 0.4);
    jam(packing, jam_spec(c));
    const PackingState<2> s = observe(packing);
    EXPECT_LT(least_energy(packing, s.full_pressure), s.energy) << family;
  }
}

TEST(Solids, JamIn3D) {
  for (const std::string family :
       {"family = \"network\"\nvertices = 60\n", "family = \"elastic\"\nvertices = 42\n"}) {
    const Case c = read("experiment = \"jamming\"\n[bodies]\ndim = 3\nN = 4\n" + family +
                        "[jamming]\npacking_fraction = 0.05\nstep = 0.02\npressure = 1e-3\n");
    MemoryRecorderOf<3> recorder;
    run(c, nullptr, recorder);
    EXPECT_GT(recorder.get("results", "pressure"), 1e-3);
    EXPECT_LT(recorder.get("results", "pressure"), 1.01e-3);
  }
}

/// Undamped solids in a periodic cell keep their energy: the bound of the time step knows them. They are much
/// stiffer than their contacts, which would give a longer step.
TEST(Solids, KeepTheirEnergyInMotion) {
  for (const auto& [family, stiffness] :
       {std::pair<std::string, std::string>("network", "k_s = 1e5"), {"elastic", "E = 1e5"}}) {
    const Case c = read(
        "experiment = \"dynamics\"\nphysics = \"deformable\"\n[bodies]\nN = 6\nvertices = 30\nfamily = \"" +
        family + "\"\n" + stiffness +
        "\n[jamming]\npacking_fraction = 0.5\n[motion]\nkinetic_energy = 1e-3\n[time]\nsteps = 2000\n");
    MemoryRecorder recorder;
    run(c, nullptr, recorder);
    const std::vector<double> total = recorder.tables.at("motion").column("total_energy");
    const auto [least, most] = std::minmax_element(total.begin(), total.end());
    EXPECT_GT(recorder.tables.at("motion").column("potential_energy").back(), 0.05 * total[0]) << family;
    EXPECT_LT(*most - *least, 0.01 * total[0]) << family;
  }
}

TEST(Solids, GoOnWithOtherStiffnesses) {
  const Case c = jam_of("family = \"network\"\nN = 2\nvertices = 30\nk_s = 0.5\n");
  const System<2> system = particles_apart(c);
  Case next = read("experiment = \"jamming\"\n");
  adopt_stiffness(next, system);
  EXPECT_EQ(next.bodies.k_s, 0.5);
  Case other = read("experiment = \"jamming\"\n[bodies]\nk_s = 2\n");
  System<2> stiffer = system;
  give_stiffness(other, stiffer);
  EXPECT_EQ(stiffer.solid.stiffness[1].bond, 2);
  other = read("experiment = \"jamming\"\n[bodies]\nE = 3\n");
  give_stiffness(other, stiffer);
  EXPECT_NEAR(nominal_constants(stiffer, 1)->young_modulus, 3, 1e-13);
  System<2> elastic = particles_apart(jam_of("family = \"elastic\"\nN = 2\nE = 2\nnu = 0.2\n"));
  other = read("experiment = \"jamming\"\n[bodies]\nnu = 0.4\n");
  give_stiffness(other, elastic);
  EXPECT_NEAR(nominal_constants(elastic, 0)->young_modulus, 2, 1e-13);
  EXPECT_NEAR(nominal_constants(elastic, 0)->poisson_ratio, 0.4, 1e-13);
}

}  // namespace
}  // namespace supple
