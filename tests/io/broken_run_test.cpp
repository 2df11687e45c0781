/// What a full disk, or a copy in part, leaves of a run.
#include <gmock/gmock.h>

#include <sys/resource.h>
#include <csignal>

#include "supple/io/run/file_recorder.hpp"
#include "supple/io/run/run_file.hpp"
#include "tests/io/sample_run.hpp"
#include "tests/io/temporary_folder.hpp"

namespace supple {
namespace {

using namespace supple::testing;
using ::testing::HasSubstr;

constexpr int discs = 5;

class BrokenRun : public TemporaryFolder {
 protected:
  std::string path() const { return in_folder("run.h5"); }
  /// Writes a segment for every append.
  FileRecorder recorder() const { return {path(), {}, "", Existing::refuse, FlushSpec{0, 1}}; }
};

/// A limit of file size stands for a full disk.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    signal_ = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, signal_);
  }

 private:
  rlimit before_{};
  void (*signal_)(int) = nullptr;
};

TEST_F(BrokenRun, AFullDiskNamesWhatIsLostAndKeepsWhatWasThere) {
  constexpr int written = 9;
  {
    FileRecorder to = recorder();
    record_sample(to, discs, written);
    const FullDisk full(100);
    const std::string why = file_error_of([&] { to.append("stress", std::vector<double>{0.9, 3, 9 / 7.}); });
    EXPECT_THAT(why, HasSubstr("File too large"));
    const std::string said = file_error_of([&] { to.finish("failed: " + why); });
    EXPECT_THAT(said, HasSubstr("File too large); lost: the final state, 1 row of stress from t = 0.9 s on; "
                                "what is complete is in " +
                                path() + ".partial, which every command reads: supple show " + path() +
                                ".partial; "));
    EXPECT_EQ(file_error_of([&] { to.finish("complete"); }), said) << "the same when asked again";
  }
  const RunFile run(path());
  EXPECT_EQ(run.rows("stress"), written);
  EXPECT_EQ(run.frames(), written);
}

/// A folder of segments that was copied in part.
TEST_F(BrokenRun, ASegmentThatIsCutOffSaysHowToReadThoseBeforeIt) {
  {
    FileRecorder to = recorder();
    record_sample(to, discs, 23);
  }
  const std::string folder = path() + ".partial", cut = folder + "/segment-000002.h5";
  const std::string whole = content_of(cut);
  write_content(cut, whole.substr(0, whole.size() / 2));
  const std::string said = file_error_of([&] { RunFile{path()}; });
  EXPECT_THAT(said, HasSubstr("segment-000002.h5 (the file ends before its own data"));
  EXPECT_THAT(said, HasSubstr("once it and the later segments are moved out of " + folder));
  std::filesystem::remove(cut);
  EXPECT_EQ(RunFile(path()).rows("stress"), 1);
}

}  // namespace
}  // namespace supple
