/// The part of FileRecorder that writes checkpoints and goes on from them.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <utility>

#include "supple/core/error.hpp"
#include "supple/io/run/file_recorder.hpp"
#include "supple/io/run/run_file.hpp"

namespace supple {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

Clock::time_point in(double seconds) {
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

/// Saves into `kept`, in the memory that it has from the time before where the names are the same.
void save(const Keep& keep, Kept& kept) {
  Keeper keeper = Keeper::saving(kept);
  keep(keeper);
  if (keeper.count() == kept.size()) return;
  kept.clear();
  Keeper anew = Keeper::saving(kept);
  keep(anew);
}

/// Segments that are later than the checkpoint, and what was left half written.
void remove_later(const std::string& folder, int segments) {
  std::vector<fs::path> later;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    const bool is_later = name.starts_with("segment-") && name >= segment_name(segments);
    if (is_later || name.ends_with(".tmp")) later.push_back(entry.path());
  }
  for (const fs::path& path : later) {
    std::error_code error;
    fs::remove(path, error);
    if (error) throw file_error("cannot remove " + path.string(), error.message());
  }
}

}  // namespace

FileRecorder::FileRecorder(std::string path, RunStart start, CheckpointSpec checkpoints)
    : path_(std::move(path)),
      folder_(partial_folder(path_)),
      case_(std::move(start.resolved)),
      case_text_(std::move(start.case_text)),
      existing_(Existing::replace),
      checkpoint_spec_(checkpoints),
      started_(Clock::now()),
      flushed_(started_),
      checkpoint_due_(in(checkpoints.period)) {
  check_can_create(path_, existing_);
  lock_folder();
  const auto checkpoint = read_checkpoint(folder_, case_text_, refused_);
  remove_later(folder_, checkpoint ? checkpoint->segments : 0);
  if (checkpoint) take_up(*checkpoint);
}

/// Two processes that write into one folder would spoil both runs. Where the file system knows no locks, the
/// run goes on without.
void FileRecorder::lock_folder() {
  if (lock_ >= 0) close(lock_);
  lock_ = open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (lock_ < 0 || flock(lock_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  close(lock_);
  throw file_error("cannot write into " + folder_, "a run is going on there", "wait for it, or stop it");
}

void FileRecorder::take_up(const Checkpoint& checkpoint) {
  segments_ = checkpoint.segments;
  has_flushed_ = segments_ > 1;
  contacts_ = checkpoint.contacts;
  checkpoints_written_ = checkpoint.number;
  cpu_time_before_ = checkpoint.cpu_time;
  resumed_ = checkpoint.kept;
  if (segments_ > 0) {
    const RunFile run(folder_);
    for (const std::string& name : run.tables()) tables_[name] = {run.columns(name), {}, false, true};
    if (run.dimensions() == 2) take_up_frames<2>(run);
    else take_up_frames<3>(run);
  }
  const h5::Group& pending = checkpoint.pending;
  if (pending.has("tables")) {
    const h5::Group tables = pending.open_group("tables");
    for (const std::string& name : tables.names()) {
      const h5::Group group = tables.open_group(name);
      Table table{{}, {}, true, true};
      std::vector<std::vector<double>> columns;
      for (const std::string& column : group.names()) {
        const h5::Object values = group.open_dataset(column);
        table.columns.push_back({column, values.text("unit"), values.text("meaning")});
        columns.push_back(group.read<double>(column));
      }
      for (std::size_t row = 0; !columns.empty() && row < columns[0].size(); ++row)
        for (const auto& column : columns) table.rows.push_back(column.at(row));
      tables_[name] = std::move(table);
    }
  }
  for (const std::string& group : pending.names()) {
    if (group == "tables" || group == "warnings") continue;
    for (const RunValue& value : read_values(pending.open_group(group))) values_.push_back({group, value});
  }
  if (pending.has("warnings")) warnings_ = pending.read<std::string>("warnings");
}

std::vector<double> FileRecorder::column(const std::string& table, const std::string& name) {
  const auto at = tables_.find(table);
  if (at == tables_.end()) throw input_error("no table '" + table + "' was declared");
  const std::vector<Column>& columns = at->second.columns;
  const auto found =
      std::find_if(columns.begin(), columns.end(), [&](const Column& c) { return c.name == name; });
  if (found == columns.end()) throw input_error("table '" + table + "' has no column '" + name + "'");
  std::vector<double> values;
  if (segments_ > 0) {
    const RunFile run(folder_);
    if (run.has_table(table)) values = run.column(table, name);
  }
  const std::vector<double>& rows = at->second.rows;
  for (auto k = static_cast<std::size_t>(found - columns.begin()); k < rows.size(); k += columns.size())
    values.push_back(rows[k]);
  return values;
}

bool FileRecorder::has_news() const {
  const bool frames = std::visit([](const auto& sites) { return !sites.frames.empty(); }, sites_);
  return frames || !values_.empty() || !warnings_.empty() ||
         std::any_of(tables_.begin(), tables_.end(),
                     [](const auto& table) { return table.second.fresh || !table.second.rows.empty(); });
}

/// Ends a limited run while there is time to write what it has.
bool FileRecorder::stop_requested() {
  const double needed = std::min(2 + 4 * checkpoint_cost_, 0.1 * checkpoint_spec_.limit);
  const bool stop = asked_to_stop() || seconds_since(started_) > checkpoint_spec_.limit - needed;
  if (stop && std::exchange(holds_, false)) write_checkpoint(held_);
  return stop;
}

bool FileRecorder::checkpoint_is_due() { return asked_for_checkpoint() || Clock::now() >= checkpoint_due_; }

void FileRecorder::safe_point(const Keep& keep, const char* where, std::int64_t number) {
  holds_ = false;
  const bool stop = stop_requested();
  if (stop || checkpoint_is_due()) {
    save(keep, held_);
    write_checkpoint(held_);
  }
  if (!stop) return;
  const Error error = interrupted_at(where, number);
  place_ = error.what();
  throw error;
}

void FileRecorder::hold(const Keep& keep, const char* where, std::int64_t number) {
  safe_point(keep, where, number);
  save(keep, held_);
  holds_ = true;
}

/// Where it cannot be written, the one before it is still there and the run goes on: the user is told once.
void FileRecorder::write_checkpoint(const Kept& kept) {
  const auto begin = Clock::now();
  try {
    if (began() && has_news()) write_segment();
    supple::write_checkpoint(folder_, case_text_,
                             {checkpoints_written_ + 1, segments_, contacts_, cpu_time(), kept, h5::Group()},
                             [&](h5::Group& pending) {
                               if (!began()) write_numbers(pending);
                             });
    ++checkpoints_written_;
    checkpoint_failed_ = false;
  } catch (const Error& e) {
    if (e.kind() != ErrorKind::file) throw;
    if (!std::exchange(checkpoint_failed_, true))
      warning(fmt::format("no checkpoint was written: {}; the last one is kept", e.what()));
  }
  checkpoint_cost_ = seconds_since(begin);
  checkpoint_due_ = in(std::max(checkpoint_spec_.period, checkpoint_cost_ / checkpoint_spec_.share));
}

}  // namespace supple
