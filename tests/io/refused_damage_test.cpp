/// What of a run file is looked at before it is used, and what is said where it cannot be.
#include <gmock/gmock.h>

#include "supple/io/run/run_file.hpp"
#include "tests/io/continued_run.hpp"
#include "tests/io/damage.hpp"

namespace supple::testing {
namespace {

using ::testing::HasSubstr;

struct Refused {
  const char* dataset;
  Damage damage;
  const char* text;
};

class RefusedDamage : public ContinuedRun {
 protected:
  /// Six rigid bodies of eight sites, which have everything that a file can hold.
  void record_bodies() const {
    record("run.h5", case_of("experiment = \"jamming\"\n[bodies]\nfamily = \"rough_disc\"\nN = 6\n"
                             "vertices = 8\n[jamming]\npressure = 1e-3\npacking_fraction = 0.6\n"
                             "step = 0.02\n"));
  }
  /// What reading says of a run with this damage.
  template <class Act>
  std::string error_of(const std::string& dataset, Damage damage, Act&& act) const {
    std::filesystem::copy_file(in_folder("run.h5"), in_folder("damaged.h5"),
                               std::filesystem::copy_options::overwrite_existing);
    EXPECT_TRUE(damage_dataset(in_folder("damaged.h5"), dataset, damage, 3)) << dataset;
    return file_error_of([&] { act(RunFile(in_folder("damaged.h5"))); });
  }
};

TEST_F(RefusedDamage, OfFrames) {
  record_bodies();
  const auto read = [](const RunFile& run) {
    for (std::int64_t k = 0; k < run.frames(); ++k) run.frame(k);
  };
  for (const Refused& r : {
           Refused{"frames/step", Damage::nested, "frames/step is no column"},
           {"frames/time", Damage::longer, "time has another shape than the frames"},
           {"frames/position", Damage::shorter, "position has another shape than the frames"},
           {"frames/spin", Damage::flattened, "spin has another shape than the frames"},
           {"frames/body/area", Damage::flattened, "area has another shape than the frames"},
           {"frames/contact_second", Damage::nested, "contact_second has another shape than contacts"},
           {"frames/contact_second", Damage::shorter, "rows are missing"},
           {"frames/contact_begin", Damage::minus_one, "rows are missing"},
           {"frames/contact_count", Damage::large, "rows are missing"},
           {"frames/contact_first", Damage::largest, "a contact of sites that do not exist"},
           {"frames/contact_first", Damage::minus_one, "a contact of sites that do not exist"},
           {"frames/contact_second", Damage::large, "a contact of sites that do not exist"},
           {"frames/contact_state", Damage::large, "a code without a meaning"},
           {"frames/mobility", Damage::large, "a code without a meaning"},
           {"frames/length", Damage::minus_one, "a cell that is none"},
           {"frames/length", Damage::infinite, "a cell that is none"},
           {"frames/strain", Damage::far, "a cell that is none"},
           {"frames/position", Damage::infinite, "a position that is not finite, or far away"},
           {"frames/position", Damage::far, "a position that is not finite, or far away"},
           {"discs/mass", Damage::shorter, "its arrays differ in length"},
           {"discs/inertia", Damage::longer, "its arrays differ in length"},
           {"discs/radius", Damage::minus_one, "a site without size"},
           {"discs/radius", Damage::not_a_number, "a site without size"},
           {"discs/particle", Damage::large, "of a particle that does not exist"},
           {"discs/particle", Damage::minus_one, "of a particle that does not exist"},
           {"discs/body_begin", Damage::large, "its bodies do not cover the sites"},
           {"discs/body_begin", Damage::shorter, "its bodies do not cover the sites"},
           {"box/length", Damage::not_a_number, "a cell that is none"},
           {"box/strain", Damage::infinite, "a cell that is none"},
       })
    EXPECT_THAT(error_of(r.dataset, r.damage, read), HasSubstr(r.text)) << r.dataset;
}

TEST_F(RefusedDamage, OfTables) {
  record_bodies();
  const std::string second = RunFile(in_folder("run.h5")).columns("packing").at(1).name;
  const auto read = [&](const RunFile& run) { run.column("packing", second); };
  EXPECT_THAT(error_of("tables/packing/" + second, Damage::longer, read),
              HasSubstr("columns of table 'packing' differ in length"));
  EXPECT_THAT(error_of("tables/packing/" + second, Damage::nested, read), HasSubstr("is no column"));
}

TEST_F(RefusedDamage, OfAState) {
  record_bodies();
  const auto read = [](const RunFile& run) { run.final_state(); };
  for (const Refused& r : {
           Refused{"box/length", Damage::longer, "length has another dimension"},
           {"sites/position", Damage::flattened, "position has another dimension"},
           {"sites/velocity", Damage::shorter, "arrays of the sites differ in length"},
           {"sites/radius", Damage::longer, "arrays of the sites differ in length"},
           {"sites/mobility", Damage::large, "mobility: a code without a meaning"},
           {"topology/begin", Damage::large, "its bodies do not cover the sites"},
           {"topology/facet_begin", Damage::shorter, "its bodies differ in number"},
           {"topology/facet_begin", Damage::large, "facets and bodies disagree"},
           {"topology/facet", Damage::minus_one, "facet of a site that does not exist"},
           {"topology/facet", Damage::large, "facet of a site that does not exist"},
           {"topology/facet", Damage::flattened, "facet has another dimension"},
           {"topology/hinge_begin", Damage::large, "hinges and bodies disagree"},
           {"shape/rest_volume", Damage::shorter, "preferred shapes and bodies disagree"},
           {"shape/rest_facet", Damage::longer, "preferred shapes and bodies disagree"},
           {"rigid/centre", Damage::flattened, "centre has another dimension"},
           {"rigid/mass", Damage::shorter, "arrays of the rigid bodies differ in length"},
           {"rigid/body", Damage::large, "rigid bodies and bodies disagree"},
           {"evaluation/force", Damage::shorter, "forces and torques differ in number"},
           {"evaluation/virial", Damage::shorter, "virial has another dimension"},
       })
    EXPECT_THAT(error_of(std::string("final_state/") + r.dataset, r.damage, read), HasSubstr(r.text))
        << r.dataset;
}

/// Of discs that touch, as bodies of many sites have no pairs that remember.
TEST_F(RefusedDamage, OfPairs) {
  record("run.h5",
         case_of("experiment = \"dynamics\"\n[particles]\nN = 24\ncut_lines = 0\n[time]\nsteps = 1\n"));
  const auto read = [](const RunFile& run) { run.final_state(); };
  for (const Refused& r : {
           Refused{"pairs/second", Damage::shorter, "columns of the pairs differ in length"},
           {"pairs/begin", Damage::large, "pairs and sites disagree"},
           {"pairs/begin", Damage::shorter, "pairs and sites disagree"},
           {"pairs/first", Damage::minus_one, "a pair of sites that do not exist"},
           {"pairs/second", Damage::large, "a pair of sites that do not exist"},
           {"pairs/state", Damage::large, "state: a code without a meaning"},
       })
    EXPECT_THAT(error_of(std::string("final_state/") + r.dataset, r.damage, read), HasSubstr(r.text))
        << r.dataset;
}

}  // namespace
}  // namespace supple::testing
