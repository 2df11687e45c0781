/// Every array of a run file says what it is.
#include "supple/io/run/run_file.hpp"
#include "tests/io/continued_run.hpp"

namespace supple::testing {
namespace {

/// Names of arrays below a group that have neither a unit nor a meaning.
void collect_undescribed(const h5::Group& group, const std::string& at, std::vector<std::string>& names) {
  for (const std::string& name : group.names())
    if (group.is_group(name)) collect_undescribed(group.open_group(name), at + "/" + name, names);
    else if (const h5::Object array = group.open_dataset(name);
             !array.has_attribute("unit") && !array.has_attribute("meaning"))
      names.push_back(at + "/" + name);
}

class DescribedArrays : public ContinuedRun {
 protected:
  std::vector<std::string> undescribed_in(const std::string& text) const {
    record("run.h5", case_of(text));
    const h5::Group root = h5::open_file(in_folder("run.h5"));
    std::vector<std::string> names;
    for (const char* part : {"discs", "box", "frames", "final_state"})
      collect_undescribed(root.open_group(part), part, names);
    return names;
  }
};

TEST_F(DescribedArrays, OfDiscs) {
  EXPECT_THAT(undescribed_in("[particles]\nN = 20\ncut_lines = 2\n[shear]\nrelative_frequency = 0.2\n"
                             "periods = 3\npre_periods = 0\npost_periods = 0\n[output]\nframes = 2\n"),
              ::testing::IsEmpty());
}

TEST_F(DescribedArrays, OfBodiesInAHeapAndInShear) {
  EXPECT_THAT(
      undescribed_in("experiment = \"slump\"\n[bodies]\nN = 4\nvertices = 8\n[slump]\nsettle_time = 1\n"
                     "spread_time = 1\n[output]\nframes = 2\n"),
      ::testing::IsEmpty());
  EXPECT_THAT(
      undescribed_in(
          "experiment = \"oscillatory_shear\"\nphysics = \"deformable\"\n[bodies]\nN = 9\nvertices = 8\n"
          "[shear]\nrelative_frequency = 0.2\nperiods = 3\npre_periods = 0\npost_periods = 0\n"
          "[jamming]\npacking_fraction = 0.6\nstep = 0.02\npressure = 1e-2\n[output]\nframes = 2\n"),
      ::testing::IsEmpty());
}

TEST_F(DescribedArrays, OfASqueezedMixtureWithRigidParticles) {
  EXPECT_THAT(undescribed_in("experiment = \"uniaxial_compression\"\n[[species]]\nfamily = \"shell\"\nN = 4\n"
                             "vertices = 8\n[[species]]\nfamily = \"rough_disc\"\nN = 3\nvertices = 8\n"
                             "[uniaxial]\nstrain = 0.02\nstep = 0.01\n[output]\nframes = 2\n"),
              ::testing::IsEmpty());
}

}  // namespace
}  // namespace supple::testing
