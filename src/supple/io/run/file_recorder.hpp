/// The recorder that writes a run file (see run_layout.hpp).
#pragma once
#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "supple/core/error.hpp"
#include "supple/core/new_file.hpp"
#include "supple/experiment/case.hpp"
#include "supple/experiment/recorder.hpp"
#include "supple/io/run/run_layout.hpp"

namespace supple {

/// When data go to disk: after `seconds` of wall time (in long runs later, so that there are few segments),
/// or when `bytes` are in memory.
struct FlushSpec {
  double seconds = 5;
  std::size_t bytes = std::size_t{64} << 20;
};

/// Writes a run in segments beside `path` and merges them into one file at finish(). A run that is killed
/// leaves every complete segment, which RunFile reads. A derived class may show progress.
class FileRecorder : public Recorder {
 public:
  /// Throws a file error, before anything is computed, where `path` or its segments exist (unless they may be
  /// replaced) or cannot be written. An old file stays until the new one is complete.
  FileRecorder(std::string path, Case resolved, std::string case_text, Existing existing = Existing::refuse,
               FlushSpec flush = {});
  /// Without finish(), writes what is in memory into a last segment.
  ~FileRecorder() override;
  FileRecorder(const FileRecorder&) = delete;
  FileRecorder& operator=(const FileRecorder&) = delete;

  void begin(const RunInfo& info) override;
  void declare(const std::string& table, const std::vector<Column>& columns) override;
  void append(const std::string& table, std::span<const double> row) override;
  void frame(const Frame& frame) override;
  void value(const std::string& group, const Column& name, double value, double error = -1) override;
  void final_state(const System<2>& system, const Evaluation<2>& evaluation) override;
  void progress(const std::string&, std::int64_t, std::int64_t) override {}
  void warning(const std::string& text) override;

  /// Merges everything into the run file. `status` is "complete", "interrupted" or "failed: why". A run that
  /// never began leaves nothing. Where the disk is full, segments keep as much as there is room for, and a
  /// file error says what is lost. A second call throws the same error.
  void finish(const std::string& status);
  /// Whether the run got so far that it leaves a file.
  bool began() const { return info_.has_value(); }
  const std::string& path() const { return path_; }

 private:
  struct Table {
    std::vector<Column> columns;
    std::vector<double> rows;  ///< row after row, since the last segment
    bool fresh = true;         ///< declared since the last segment
  };

  void count(std::size_t bytes);
  void write_segment();
  void write_new(h5::Group& root);
  std::string save_what_fits();

  std::string path_, folder_;
  Case case_;
  std::string case_text_;
  Existing existing_;
  FlushSpec flush_;
  std::chrono::steady_clock::time_point started_, flushed_;

  std::optional<RunInfo> info_;
  bool finished_ = false;
  std::optional<Error> failure_;  ///< thrown by finish()
  int segments_ = 0;
  std::int64_t contacts_ = 0;  ///< rows of contacts in the segments so far
  std::size_t bytes_ = 0;      ///< in memory, since the last segment
  std::map<std::string, Table> tables_;
  std::vector<Frame> frames_;
  std::optional<Frame> last_frame_;                                 ///< its instant
  std::optional<std::map<std::string, std::size_t>> body_numbers_;  ///< names and lengths in the first frame
  SystemNumbers first_numbers_;  ///< of the first frame; a number that a later one lacks is nan there
  std::vector<std::pair<std::string, RunValue>> values_;
  std::vector<std::string> warnings_;
  std::optional<std::pair<System<2>, Evaluation<2>>> final_;
};

}  // namespace supple
