/// What run files weigh, and what a full disk leaves of them.
#include <gmock/gmock.h>
#include <hdf5.h>

#include <cmath>
#include <fstream>

#include "supple/io/hdf5/hdf5.hpp"
#include "supple/io/run/run_file.hpp"
#include "tests/app/command.hpp"

namespace supple {
namespace {

/// Bytes of all numbers and texts below a group, and the datasets whose layout is contiguous.
struct Weight {
  std::uint64_t bytes = 0;
  std::vector<std::string> contiguous, unchecked;

  static bool has_checksum(hid_t list) {
    unsigned int flags = 0, configuration = 0;
    std::size_t values = 0;
    return H5Pget_filter_by_id(list, H5Z_FILTER_FLETCHER32, &flags, &values, nullptr, 0, nullptr,
                               &configuration) >= 0;
  }
  void add(const h5::Group& group, const std::string& path) {
    for (const std::string& name : group.names()) {
      if (group.is_group(name)) {
        add(group.open_group(name), path + name + "/");
        continue;
      }
      const h5::Object dataset = group.open_dataset(name);
      const hid_t type = H5Dget_type(dataset.id()), space = H5Dget_space(dataset.id()),
                  list = H5Dget_create_plist(dataset.id());
      bytes += H5Tget_size(type) * static_cast<std::uint64_t>(H5Sget_simple_extent_npoints(space));
      if (H5Pget_layout(list) == H5D_CONTIGUOUS) contiguous.push_back(path + name);
      if (H5Pget_layout(list) == H5D_CHUNKED && !has_checksum(list)) unchecked.push_back(path + name);
      H5Tclose(type);
      H5Sclose(space);
      H5Pclose(list);
    }
  }
};

class RunSize : public CommandTest {
 protected:
  Weight weight_of(const std::string& name) {
    Weight weight;
    weight.add(h5::open_file(path(name).string()), "/");
    return weight;
  }
  /// A case without pictures; `output` may add keys.
  void write_case(const std::string& name, std::string text, const std::string& output = "") {
    text += "[output]\nplot = false\nsnapshot = false\n";
    text += output;
    write(name + ".toml", text);
  }
  std::uint64_t file_size(const std::string& name) { return std::filesystem::file_size(path(name)); }
};

/// 2.2 MB with pieces of a fixed number of rows.
TEST_F(RunSize, AJamOfSixteenDiscsIsBelow100kB) {
  write_case("jam", "experiment = \"jamming\"\n[bodies]\nfamily = \"disc\"\nN = 16\n");
  ASSERT_EQ(supple("run jam.toml").code, 0);
  EXPECT_LT(file_size("jam.h5"), 100000u);
}

TEST_F(RunSize, ALargeRunIsLittleMoreThanItsNumbers) {
  write_case("gel", "[particles]\nN = 40\ncut_lines = 0\n[shear]\nperiods = 2\n");
  write_case("jam", "experiment = \"jamming\"\n[bodies]\nN = 24\nvertices = 20\n");
  write_case("move",
             "experiment = \"dynamics\"\n[particles]\nN = 60\ncut_lines = 0\n[shear]\nrate = "
             "\"100\"\n[time]\nsteps = 300\n",
             "frames = 100\n");
  for (const std::string name : {"gel", "jam", "move"}) {
    const Outcome run = supple("run " + name + ".toml");
    ASSERT_EQ(run.code, 0) << run.err;
    const Weight weight = weight_of(name + ".h5");
    EXPECT_GT(file_size(name + ".h5"), 100000u) << "too small to show anything";
    EXPECT_LT(static_cast<double>(file_size(name + ".h5")), 1.3 * static_cast<double>(weight.bytes)) << name;
  }
}

/// h5repack fails on an empty contiguous dataset, R and h5wasm on empty texts of any length.
TEST_F(RunSize, ArraysStandInHeadersOrInCheckedPieces) {
  write_small_case();
  ASSERT_EQ(supple("run small.toml").code, 0);
  const Weight weight = weight_of("small.h5");
  EXPECT_THAT(weight.contiguous, testing::IsEmpty());
  EXPECT_THAT(weight.unchecked, testing::IsEmpty());
}

/// HDF5 1.10 crashes after a write that failed; files are made in memory. A limit of 300 kB stands for a full
/// disk.
TEST_F(RunSize, AFullDiskIsAFileErrorThatLeavesWhatIsComplete) {
  if (std::system("bash -c 'ulimit -f 300' >/dev/null 2>&1") != 0)
    GTEST_SKIP() << "this shell cannot limit the size of files";
  write_case("gel", "seed = 3\n[particles]\nN = 40\ncut_lines = 0\n[shear]\namplitude = 0.02\n",
             "frames = 100\n");
  const std::string line = "cd '" + path("").string() +
                           "' && bash -c \"trap '' XFSZ; ulimit -f 300; exec '" SUPPLE_COMMAND
                           "' run gel.toml\" >out 2>err";
  const int status = std::system(line.c_str());
  ASSERT_TRUE(WIFEXITED(status)) << "ended by signal " << WTERMSIG(status);
  const std::string said = read_text(path("err"));
  EXPECT_EQ(WEXITSTATUS(status), 4) << said;
  EXPECT_THAT(said, testing::HasSubstr("nothing is lost: what is complete is in gel.h5.partial, which every "
                                       "command reads: supple show gel.h5.partial; "));
  EXPECT_FALSE(exists("gel.h5"));
  const Outcome shown = supple("show gel.h5");
  EXPECT_EQ(shown.code, 0) << shown.err;
  EXPECT_EQ(supple("export gel.h5 --to hdf5 -o saved.h5").code, 0);
  const RunFile saved(path("saved.h5").string());
  EXPECT_EQ(saved.info().radius.size(), 40u);
  // More than one file of this size holds: in smaller pieces there was room for all.
  EXPECT_EQ(saved.frames(), 100);
  EXPECT_EQ(saved.rows("stress"), 5857);  // a step is longer than it was
  EXPECT_TRUE(saved.has_final_state());
}

}  // namespace
}  // namespace supple
