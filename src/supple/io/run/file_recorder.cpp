#include "supple/io/run/file_recorder.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <span>
#include <utility>

#include "supple/core/error.hpp"
#include "supple/io/hdf5/elements.hpp"
#include "supple/io/hdf5/system_archive.hpp"
#include "supple/io/run/run_file.hpp"

namespace supple {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_between(Clock::time_point a, Clock::time_point b) {
  return std::chrono::duration<double>(b - a).count();
}

/// Units and meanings are those of the first segment that has the table.
void write_table(h5::Group& tables, const std::string& name, const std::vector<Column>& columns,
                 const std::vector<double>& rows, bool first) {
  h5::Group table = tables.create_group(name);
  std::vector<double> values(columns.empty() ? 0 : rows.size() / columns.size());
  for (std::size_t c = 0; c < columns.size(); ++c) {
    for (std::size_t r = 0; r < values.size(); ++r) values[r] = rows[r * columns.size() + c];
    h5::Object column = table.write(columns[c].name, values);
    if (!first) continue;
    column.set("unit", columns[c].unit);
    column.set("meaning", columns[c].meaning);
  }
}

Clock::time_point after(Clock::time_point begin, double seconds) {
  return begin + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

/// An older run leaves segments, and temporary files where it was killed; whatever else lies there is not
/// ours to remove.
void remove_partial_run(const std::string& folder) {
  if (!fs::exists(fs::symlink_status(folder))) return;
  std::error_code error;
  const auto refuse = [&](const std::string& why) {
    return file_error("cannot replace " + folder, why, "remove it or choose another name");
  };
  if (!fs::is_directory(fs::symlink_status(folder))) throw refuse("it is no folder");
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (!is_of_a_run(name) || !entry.is_regular_file())
      throw refuse("it holds " + name + ", which no run wrote");
  }
  fs::remove_all(folder, error);
  if (error) throw refuse(error.message());
}

}  // namespace

FileRecorder::FileRecorder(std::string path, Case resolved, std::string case_text, Existing existing,
                           FlushSpec flush, CheckpointSpec checkpoints)
    : path_(std::move(path)),
      folder_(partial_folder(path_)),
      case_(std::move(resolved)),
      case_text_(std::move(case_text)),
      existing_(existing),
      flush_(flush),
      checkpoint_spec_(checkpoints),
      started_(Clock::now()),
      flushed_(started_),
      checkpoint_due_(after(started_, checkpoints.period)) {
  check_can_create(path_, existing_);
  if (existing_ == Existing::replace) {
    lock_folder();  // a run that is going on there is not replaced
    remove_partial_run(folder_);
  }
  std::error_code error;
  if (!fs::create_directory(folder_, error)) {
    if (error) throw file_error("cannot create " + folder_, error.message());
    throw file_error(folder_ + " exists", "another run writes there, or was stopped",
                     "go on with it (supple resume " + path_ +
                         "), choose another name, remove it, or overwrite it with --force");
  }
  lock_folder();
  try {
    write_start(folder_, {case_, case_text_, ""});
  } catch (const Error&) {
    fs::remove_all(folder_, error);
    throw;
  }
}

FileRecorder::~FileRecorder() {
  std::error_code error;
  if (!finished_ && !began() && !can_resume()) fs::remove_all(folder_, error);  // the run never began
  if (!finished_) try {
      if (began()) write_segment();
    } catch (const std::exception&) {  // what is on disk is complete; a destructor has nobody to tell
    }
  if (lock_ >= 0) close(lock_);
}

/// Whatever comes first decides how many dimensions a run has.
template <int Dim>
FileRecorder::Sites<Dim>& FileRecorder::sites_in() {
  if (const auto* other = std::get_if<Sites<5 - Dim>>(&sites_)) {
    if (other->info || other->last || other->final_state)
      throw input_error("a run is in two dimensions or in three", "it began in the other");
    sites_.emplace<Sites<Dim>>();
  }
  return std::get<Sites<Dim>>(sites_);
}

const Units& FileRecorder::units() const {
  return std::visit([](const auto& sites) -> const Units& { return sites.info->units; }, sites_);
}

void FileRecorder::begin(const AnyRunInfo& any) {
  if (began() && resumed_) return;
  // What was told before stays in memory: a short run is written at once.
  h5::Group root = h5::create_file(folder_, h5::Storage::plain);
  std::visit(
      [&]<int Dim>(const RunInfo<Dim>& info) {
        sites_in<Dim>().info = info;
        write_header(root, case_, case_text_, info);
      },
      any);
  root.create_group("tables");
  root.write("warnings", std::vector<std::string>());
  save_segment(root);
}

void FileRecorder::declare(const std::string& table, const std::vector<Column>& columns) {
  const auto [at, made] = tables_.try_emplace(table, Table{columns, {}, true, false});
  if (!made && !std::exchange(at->second.taken_up, false))
    throw input_error("table '" + table + "' is declared twice");
}

void FileRecorder::append(const std::string& table, std::span<const double> row) {
  const auto at = tables_.find(table);
  if (at == tables_.end()) throw input_error("no table '" + table + "' was declared");
  if (row.size() != at->second.columns.size())
    throw input_error("a row of table '" + table + "' has " + std::to_string(row.size()) + " values, not " +
                      std::to_string(at->second.columns.size()));
  holds_ = false;
  at->second.rows.insert(at->second.rows.end(), row.begin(), row.end());
  count(row.size_bytes());
}

void FileRecorder::frame(const AnyFrame& any) {
  std::visit([&](const auto& frame) { add_frame(frame); }, any);
}

template <int Dim>
void FileRecorder::add_frame(const Frame<Dim>& frame) {
  Sites<Dim>& sites = sites_in<Dim>();
  if (sites.last && same_instant(*sites.last, frame)) return;
  holds_ = false;
  if (!sites.last) first_numbers_ = frame.numbers;
  std::map<std::string, std::size_t> numbers;
  for (const auto& [name, values] : frame.body) numbers[name] = values.size();
  if (!body_numbers_) body_numbers_ = numbers;
  if (numbers != *body_numbers_)
    throw input_error("a frame has other numbers of bodies than the first one",
                      "all frames of a run are alike");
  sites.frames.push_back(frame);
  SystemNumbers& of_all = sites.frames.back().numbers;
  of_all = {};
  for (const auto& [name, value] : first_numbers_) {
    const auto at = frame.numbers.find(name);
    of_all[name] = at == frame.numbers.end() ? std::nan("") : at->second;
  }
  remember_instant(frame);
  std::size_t bytes =
      frame.position.size() * 5 * Dim * sizeof(double) + frame.contacts.size() * sizeof(ContactRow<Dim>);
  for (const auto& [name, values] : frame.body) bytes += values.size() * sizeof(double);
  count(bytes);
}

template <int Dim>
void FileRecorder::remember_instant(const Frame<Dim>& frame) {
  Frame<Dim>& last = sites_in<Dim>().last.emplace();
  last.step = frame.step;
  last.time = frame.time;
  last.position = frame.position;
}

template <int Dim>
void FileRecorder::take_up_frames(const RunFile& run) {
  sites_in<Dim>().info = run.info<Dim>();
  const std::int64_t frames = run.frames();
  if (frames == 0) return;
  const Frame<Dim> first = run.frame<Dim>(0);
  first_numbers_ = first.numbers;
  body_numbers_.emplace();
  for (const auto& [name, values] : first.body) (*body_numbers_)[name] = values.size();
  remember_instant(run.frame<Dim>(frames - 1));
}
template void FileRecorder::take_up_frames<2>(const RunFile&);
template void FileRecorder::take_up_frames<3>(const RunFile&);

void FileRecorder::value(const std::string& group, const Column& name, double value, double error) {
  holds_ = false;
  values_.push_back({group, {name, value, error}});
}

void FileRecorder::final_state(const AnyFinalState& any) {
  std::visit(
      [&]<int Dim>(const FinalState<Dim>& instant) {
        FinalState<Dim>& last = sites_in<Dim>().final_state.emplace(instant);
        drop_open(last.system.pairs, last.system.state.size());
      },
      any);
}

void FileRecorder::progress(const std::string& phase, std::int64_t done, std::int64_t total) {
  phase_ = phase;
  phase_share_ = total > 0 ? static_cast<double>(done) / static_cast<double>(total) : 0;
}

void FileRecorder::warning(const std::string& text) { warnings_.push_back(text); }

/// The interval grows with the age of the run: a day makes some hundred segments, and a kill loses at most 2
/// %.
void FileRecorder::count(std::size_t bytes) {
  bytes_ += bytes;
  const auto now = Clock::now();
  const double interval = std::max(flush_.seconds, 0.02 * seconds_between(started_, now));
  if (began() && (bytes_ >= flush_.bytes || seconds_between(flushed_, now) >= interval)) write_segment();
}

void FileRecorder::save_segment(h5::Group& root) {
  h5::save(root, folder_ + "/" + segment_name(segments_));
  ++segments_;
}

void FileRecorder::write_segment() {
  h5::Group root = h5::create_file(folder_, h5::Storage::plain);  // it is soon merged
  write_news(root);
  save_segment(root);
  std::visit(
      [&](auto& sites) {
        for (const auto& frame : sites.frames) contacts_ += static_cast<std::int64_t>(frame.contacts.size());
        sites.frames.clear();
        sites.final_state.reset();
      },
      sites_);
  for (auto& [name, table] : tables_) {
    table.rows.clear();
    table.fresh = false;
  }
  values_.clear();
  warnings_.clear();
  bytes_ = 0;
  flushed_ = Clock::now();
  has_flushed_ = true;
}

void FileRecorder::write_news(h5::Group& root) {
  write_numbers(root);
  std::visit(
      [&](const auto& sites) {
        write_frames(root, sites.frames, units(), contacts_);
        if (!sites.final_state) return;
        h5::Group state = root.create_group("final_state");
        write_system(state, sites.final_state->system, units());
        h5::Group evaluation = state.create_group("evaluation");
        write_evaluation(evaluation, sites.final_state->evaluation, units());
      },
      sites_);
}

/// Rows, values and warnings that no segment holds.
void FileRecorder::write_numbers(h5::Group& root) {
  h5::Group tables = root.create_group("tables");
  for (const auto& [name, table] : tables_)
    if (table.fresh || !table.rows.empty()) write_table(tables, name, table.columns, table.rows, table.fresh);
  for (const auto& [group, value] : values_) {
    h5::Group target = root.has(group) ? root.open_group(group) : root.create_group(group);
    if (target.has(value.name.name)) target.remove(value.name.name);
    write_value(target, value);
  }
  root.write("warnings", warnings_);
}

}  // namespace supple
