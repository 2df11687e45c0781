/// Checkpoints that are damaged, of another run, or that there is no room for.
#include <gmock/gmock.h>
#include <hdf5.h>
#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <map>

#include "supple/core/checksum.hpp"
#include "supple/experiment/experiments.hpp"
#include "supple/io/hdf5/system_archive.hpp"
#include "supple/io/run/file_recorder.hpp"
#include "supple/io/run/run_file.hpp"
#include "tests/io/sample_run.hpp"
#include "tests/io/temporary_folder.hpp"

namespace supple {
namespace {

using namespace supple::testing;
using ::testing::HasSubstr;

constexpr int discs = 5;
constexpr CheckpointSpec every_time{0, 1e9};
namespace fs = std::filesystem;

/// A made-up run: a row, then a checkpoint, for each number from 1 on.
class Checkpoints : public TemporaryFolder {
 protected:
  std::string path() const { return in_folder("run.h5"); }
  std::string partial() const { return path() + ".partial"; }

  static Case case_of_seed(std::int64_t seed) {
    Case c;
    c.general.seed = seed;
    return c;
  }
  FileRecorder start(std::int64_t seed = 1) const {
    return {path(), case_of_seed(seed), "seed = " + std::to_string(seed), Existing::refuse, {}, every_time};
  }
  FileRecorder resume() const { return {path(), read_start(partial()), every_time}; }

  static void begin(Recorder& to) {
    to.begin(sample_info(discs));
    to.declare("numbers", {{"n", "", ""}});
  }
  static void step(Recorder& to, int n) {
    to.append("numbers", std::vector<double>{1. * n});
    to.safe_point(
        [n](Keeper& k) {
          int kept = n;
          k("n", kept);
        },
        "at", n);
  }
  /// A run that was killed after step n.
  void die_after(int n, std::int64_t seed = 1) const {
    FileRecorder to = start(seed);
    begin(to);
    for (int k = 1; k <= n; ++k) step(to, k);
    to.append("numbers", std::vector<double>{-1});  // of the time after the checkpoint
  }
  static std::int64_t number_in(const FileRecorder& r) {
    return r.resumed() ? std::get<std::int64_t>(r.resumed()->at("n")) : 0;
  }
  std::vector<std::string> checkpoints() const {
    std::vector<std::string> all;
    for (const auto& entry : fs::directory_iterator(partial()))
      if (entry.path().filename().string().starts_with("checkpoint-")) all.push_back(entry.path().string());
    std::sort(all.begin(), all.end());
    return all;
  }
  /// Changes bytes as `change` says; with the name that the new bytes would have, or the old one.
  template <class Change>
  static void change(const std::string& file, bool keeps_name, Change&& change) {
    std::string bytes = content_of(file);
    change(bytes);
    fs::remove(file);
    char crc[9];
    std::snprintf(crc, sizeof crc, "%08x", checksum(bytes));
    write_content(keeps_name ? file : file.substr(0, file.size() - 11) + crc + ".h5", bytes);
  }
};

TEST_F(Checkpoints, ARunGoesOnWithTheRowsBeforeTheLastOfThem) {
  die_after(5);
  ASSERT_EQ(checkpoints().size(), 2u) << "the last two are kept";
  {
    FileRecorder to = resume();
    EXPECT_EQ(number_in(to), 5);
    begin(to);
    EXPECT_EQ(to.column("numbers", "n"), (std::vector<double>{1, 2, 3, 4, 5}));
    for (int k = 6; k <= 7; ++k) step(to, k);
    to.finish("complete");
  }
  EXPECT_EQ(RunFile(path()).column("numbers", "n"), (std::vector<double>{1, 2, 3, 4, 5, 6, 7}));
  EXPECT_FALSE(fs::exists(partial()));
}

TEST_F(Checkpoints, OneThatIsDamagedIsRefusedAndTheOneBeforeUsed) {
  const std::vector<std::function<void(std::string&)>> damages{
      [](std::string& bytes) { bytes.resize(bytes.size() / 2); },
      [](std::string& bytes) { bytes.clear(); },
      [](std::string& bytes) { bytes[bytes.size() / 3] ^= 4; },
      [](std::string& bytes) { bytes.back() ^= 1; },
  };
  for (const auto& damage : damages) {
    die_after(4);
    change(checkpoints()[1], true, damage);
    {
      FileRecorder to = resume();
      EXPECT_EQ(number_in(to), 3);
      ASSERT_EQ(to.refused_checkpoints().size(), 1u);
      EXPECT_THAT(to.refused_checkpoints()[0], HasSubstr("its bytes are not those that were written"));
      begin(to);
      EXPECT_EQ(to.column("numbers", "n"), (std::vector<double>{1, 2, 3}));
    }
    change(checkpoints()[0], true, damage);
    EXPECT_THAT(file_error_of([&] { resume(); }),
                HasSubstr("no checkpoint in " + partial() + " can be used"));
    fs::remove_all(partial());
  }
}

TEST_F(Checkpoints, OfAnotherVersionOrCaseTheyAreRefused) {
  die_after(2, 7);
  const std::string foreign = content_of(checkpoints()[1]), name = fs::path(checkpoints()[1]).filename();
  fs::remove_all(partial());
  die_after(1);
  write_content(partial() + "/" + name, foreign);
  EXPECT_EQ(number_in(resume()), 1);
  EXPECT_THAT(resume().refused_checkpoints().at(0), HasSubstr("is of another case"));
  fs::remove_all(partial());

  die_after(2);
  const std::string last = checkpoints()[1];
  const hid_t file = H5Fopen(last.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  const hid_t version = H5Aopen(file, "supple_version", H5P_DEFAULT), type = H5Aget_type(version);
  std::string text(H5Tget_size(type), '\0');
  text[0] = '9';
  ASSERT_GE(H5Awrite(version, type, text.data()), 0);
  H5Tclose(type);
  H5Aclose(version);
  H5Fclose(file);
  change(last, false, [](std::string&) {});
  EXPECT_EQ(number_in(resume()), 1);
  EXPECT_THAT(resume().refused_checkpoints().at(0), HasSubstr("is of another version of Supple"));
}

TEST_F(Checkpoints, WithoutTheSegmentsBeforeThemTheyAreRefused) {
  die_after(3);
  fs::remove(partial() + "/segment-000003.h5");
  FileRecorder to = resume();
  EXPECT_EQ(number_in(to), 2);
  EXPECT_THAT(to.refused_checkpoints().at(0), HasSubstr("segment-000003.h5 of the run is missing"));
}

TEST_F(Checkpoints, AFullDiskKeepsTheLast) {
  {
    FileRecorder to = start();
    begin(to);
    for (int n = 1; n <= 3; ++n) step(to, n);
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const auto signal = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{100, before.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
    EXPECT_NO_THROW(step(to, 4));
    EXPECT_NO_THROW(step(to, 5));
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, signal);
    EXPECT_EQ(checkpoints().size(), 2u);
    step(to, 6);  // there is room again
  }
  FileRecorder to = resume();
  EXPECT_EQ(number_in(to), 6);
  begin(to);
  EXPECT_EQ(to.column("numbers", "n"), (std::vector<double>{1, 2, 3, 4, 5, 6}));
}

TEST_F(Checkpoints, TwoRunsDoNotWriteIntoOneFolder) {
  FileRecorder to = start();
  begin(to);
  step(to, 1);
  EXPECT_THAT(file_error_of([&] { resume(); }), HasSubstr("a run is going on there"));
  const auto replace = [&] { FileRecorder{path(), case_of_seed(1), "seed = 1", Existing::replace}; };
  EXPECT_THAT(file_error_of(replace), HasSubstr("a run is going on there"));
  step(to, 2);
  EXPECT_EQ(checkpoints().size(), 2u);
}

TEST_F(Checkpoints, ARunThatWasKilledBeforeTheFirstStartsAgain) {
  {
    FileRecorder to = start();
    begin(to);
    to.append("numbers", std::vector<double>{1});
  }
  EXPECT_TRUE(checkpoints().empty());
  FileRecorder to = resume();
  EXPECT_EQ(to.resumed(), nullptr);
  begin(to);
  for (int n = 1; n <= 2; ++n) step(to, n);
  to.finish("complete");
  EXPECT_EQ(RunFile(path()).column("numbers", "n"), (std::vector<double>{1, 2}));
}

/// Rows that come before a run begins have no segment: the checkpoint holds them.
TEST_F(Checkpoints, HoldWhatWasRecordedBeforeARunBegan) {
  {
    FileRecorder to = start();
    to.declare("numbers", {{"n", "m", "a number"}});
    to.value("constants", {"c", "kg", "of the preparation"}, 0.1, 0.2);
    to.warning("a warning");
    step(to, 1);
    to.append("numbers", std::vector<double>{-1});
  }
  FileRecorder to = resume();
  to.declare("numbers", {{"n", "m", "a number"}});
  to.begin(sample_info(discs));
  to.finish("complete");
  const RunFile run(path());
  EXPECT_EQ(run.column("numbers", "n"), (std::vector<double>{1}));
  EXPECT_EQ(run.columns("numbers")[0].unit, "m");
  EXPECT_EQ(run.value("constants", "c"), 0.1);
  EXPECT_EQ(run.values("constants")[0].error, 0.2);
  EXPECT_EQ(run.warnings(), std::vector<std::string>{"a warning"});
}

/// Frames of one instant are kept once, also where a run is stopped between them.
TEST_F(Checkpoints, KnowTheLastFrame) {
  {
    FileRecorder to = start();
    begin(to);
    to.frame(sample_frame(discs, 1));
    to.frame(sample_frame(discs, 2));
    step(to, 1);
  }
  FileRecorder to = resume();
  begin(to);
  to.frame(sample_frame(discs, 2));
  to.frame(sample_frame(discs, 3));
  to.finish("complete");
  const RunFile run(path());
  ASSERT_EQ(run.frames(), 3);
  EXPECT_EQ(run.frame(2).contacts.size(), sample_frame(discs, 3).contacts.size());
  EXPECT_EQ(run.frame(2).numbers, sample_frame(discs, 3).numbers);
}

/// A search keeps several states of the same particles.
TEST_F(Checkpoints, AreAtMostTwiceAsLargeAsTheState) {
  class Measuring : public FileRecorder {
   public:
    using FileRecorder::FileRecorder;
    void safe_point(const Keep& keep, const char* where, std::int64_t number) override {
      FileRecorder::safe_point(keep, where, number);
      for (const auto& entry : fs::directory_iterator(path() + ".partial"))
        if (entry.path().filename().string().starts_with("checkpoint-"))
          largest = std::max(largest, fs::file_size(entry));
    }
    std::uintmax_t largest = 0;
  };
  // Arrays of 320 sites are too large for headers. Searches for a pressure keep up to three states, so that
  // there it holds for small ones alone.
  const std::map<std::string, int> vertices{
      {"jamming", 40}, {"compression", 16}, {"uniaxial_compression", 16}, {"slump", 40}};
  for (const auto& [experiment, number] : vertices) {
    Case c;
    c.general.experiment = experiment;
    c.bodies.count = 8;
    c.bodies.vertices = number;
    c.jamming.pressure = 1e-3;
    c.compression.highest_pressure = 2e-3;
    c.compression.per_decade = 3;
    c.uniaxial.strain = 0.01;
    c.slump.settle_time = c.slump.spread_time = 0.02;
    resolve_family(c);
    experiment_of(c).complete(c);
    Measuring to(path(), c, "", Existing::replace, FlushSpec{}, every_time);
    run(c, nullptr, to);
    to.finish("complete");
    h5::Group alone = h5::create_file("state");
    write_system(alone, RunFile(path()).final_state().first, reduced_units());
    EXPECT_LT(static_cast<double>(to.largest), 2.0 * static_cast<double>(h5::bytes_of(alone).size()))
        << experiment;
  }
}

TEST(KeptValues, AreRestoredBitForBit) {
  struct Part {
    double x = 0;
    std::vector<Vec2> v;
    std::optional<int> n;
    void keep(Keeper& k) {
      k("x", x);
      k("v", v);
      k("n", n);
    }
  };
  Part a{0.1, {{1, 2}, {3, -0.0}}, 7}, b{1, {{9, 9}}, std::nullopt};
  std::vector<Part> list{a, b};
  Kept kept;
  Keeper::saving(kept)("list", list);
  std::vector<Part> restored(5);
  Keeper::restoring(kept)("list", restored);
  ASSERT_EQ(restored.size(), 2u);
  EXPECT_EQ(restored[0].x, a.x);
  EXPECT_EQ(restored[0].v, a.v);
  EXPECT_TRUE(std::signbit(restored[0].v[1][1]));
  EXPECT_EQ(restored[0].n, a.n);
  EXPECT_EQ(restored[1].n, std::nullopt);
  double missing = 0;
  EXPECT_THROW(Keeper::restoring(kept)("other", missing), Error);
  std::string text;
  EXPECT_THROW(Keeper::restoring(kept)("list.count", text), Error);
}

}  // namespace
}  // namespace supple
