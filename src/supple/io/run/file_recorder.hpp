/// The recorder that writes a run file (see run_layout.hpp).
#pragma once
#include <chrono>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "supple/core/error.hpp"
#include "supple/core/new_file.hpp"
#include "supple/experiment/case.hpp"
#include "supple/experiment/recorder.hpp"
#include "supple/io/run/checkpoint.hpp"
#include "supple/io/run/run_layout.hpp"

namespace supple {

class RunFile;

/// When checkpoints are written, in seconds of wall time: at the first safe point after `period`, and so
/// seldom that they take at most `share` of the time. A run stops before it has gone on for `limit`.
struct CheckpointSpec {
  double period = 60, share = 0.01, limit = std::numeric_limits<double>::infinity();
};

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
               FlushSpec flush = {}, CheckpointSpec checkpoints = {});
  /// Goes on with the run of which segments and checkpoints lie beside `path`: segments that are later than
  /// the checkpoint are removed. Throws a file error where there is no run, or no checkpoint can be used.
  FileRecorder(std::string path, RunStart start, CheckpointSpec checkpoints = {});
  /// Without finish(), writes what is in memory into a last segment.
  ~FileRecorder() override;
  FileRecorder(const FileRecorder&) = delete;
  FileRecorder& operator=(const FileRecorder&) = delete;

  void begin(const AnyRunInfo& info) override;
  void declare(const std::string& table, const std::vector<Column>& columns) override;
  void append(const std::string& table, std::span<const double> row) override;
  void frame(const AnyFrame& frame) override;
  void value(const std::string& group, const Column& name, double value, double error = -1) override;
  void final_state(const AnyFinalState& instant) override;
  std::vector<double> column(const std::string& table, const std::string& name) override;
  void progress(const std::string& phase, std::int64_t done, std::int64_t total) override;
  void warning(const std::string& text) override;
  void safe_point(const Keep& keep, const char* where, std::int64_t number) override;
  void hold(const Keep& keep, const char* where, std::int64_t number) override;
  const Kept* resumed() const override { return resumed_ ? &*resumed_ : nullptr; }
  /// Whether the time limit is over, or a derived class was asked to stop.
  bool stop_requested() override;

  /// Merges everything into the run file. `status` is "complete", "interrupted" or "failed: why". A run that
  /// is interrupted also keeps the folder from which it can be resumed. A run that never began leaves nothing
  /// else. Where the disk is full, segments keep as much as there is room for, and a
  /// file error says what is lost. A second call throws the same error.
  void finish(const std::string& status);
  /// Whether the run got so far that it leaves a file.
  bool began() const override {
    return std::visit([](const auto& sites) { return sites.info.has_value(); }, sites_);
  }
  /// Whether there is a place from which the run can be resumed.
  bool can_resume() const { return checkpoints_written_ > 0; }
  /// Checkpoints that were left aside, and why, where a run goes on from an older one.
  const std::vector<std::string>& refused_checkpoints() const { return refused_; }
  const std::string& path() const { return path_; }

 protected:
  /// Whether somebody asked to stop, or for a checkpoint now.
  virtual bool asked_to_stop() { return false; }
  virtual bool asked_for_checkpoint() { return false; }

 private:
  struct Table {
    std::vector<Column> columns;
    std::vector<double> rows;  ///< row after row, since the last segment
    bool fresh = true;         ///< declared since the last segment
    bool taken_up = false;     ///< of the run that goes on, which declares it once more
  };

  /// What is recorded of the sites of a run in so many dimensions.
  template <int Dim>
  struct Sites {
    std::optional<RunInfo<Dim>> info;            ///< once the run began
    std::vector<Frame<Dim>> frames;              ///< since the last segment
    std::optional<Frame<Dim>> last;              ///< instant of the last frame
    std::optional<FinalState<Dim>> final_state;  ///< if no segment holds it
  };
  template <int Dim>
  Sites<Dim>& sites_in();
  template <int Dim>
  void add_frame(const Frame<Dim>& frame);
  template <int Dim>
  void remember_instant(const Frame<Dim>& frame);
  template <int Dim>
  void take_up_frames(const RunFile& run);
  const Units& units() const;

  void count(std::size_t bytes);
  void write_segment();
  void save_segment(h5::Group& root);
  void write_news(h5::Group& root);
  void write_numbers(h5::Group& root);
  void save_whole(const std::string& status);
  void clean_up(const std::string& status) const;
  bool has_news() const;
  void lock_folder();
  void take_up(const Checkpoint& checkpoint);
  bool checkpoint_is_due();
  void write_checkpoint(const Kept& kept);
  std::string save_what_fits();
  template <int Dim>
  std::string save_what_fits(Sites<Dim>& sites);

  std::string path_, folder_;
  Case case_;
  std::string case_text_;
  Existing existing_;
  FlushSpec flush_;
  CheckpointSpec checkpoint_spec_;
  std::chrono::steady_clock::time_point started_, flushed_, checkpoint_due_;

  std::variant<Sites<2>, Sites<3>> sites_;
  bool finished_ = false;
  std::optional<Error> failure_;  ///< thrown by finish()
  int lock_ = -1;                 ///< descriptor of the folder, locked while this writes there
  int segments_ = 0;
  bool has_flushed_ = false;   ///< whether a segment holds more than what the run begins with
  std::int64_t contacts_ = 0;  ///< rows of contacts in the segments so far
  std::size_t bytes_ = 0;      ///< in memory, since the last segment
  std::map<std::string, Table> tables_;
  std::optional<std::map<std::string, std::size_t>> body_numbers_;  ///< names and lengths in the first frame
  SystemNumbers first_numbers_;  ///< of the first frame; a number that a later one lacks is nan there
  std::vector<std::pair<std::string, RunValue>> values_;
  std::vector<std::string> warnings_;

  std::optional<Kept> resumed_;  ///< of the run that goes on
  Kept held_;                    ///< at the last safe point that was long before the next, or written
  bool holds_ = false;           ///< for a stop before the next safe point
  std::vector<std::string> refused_;
  std::string place_, phase_;  ///< the last safe point, and what was done there
  double phase_share_ = 0;     ///< that is done
  std::int64_t checkpoints_written_ = 0;
  double checkpoint_cost_ = 0;  ///< of the last one [s]
  bool checkpoint_failed_ = false;
};

}  // namespace supple
