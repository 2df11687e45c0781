/// The part of FileRecorder that ends a run: one file from what is in memory and in segments.
#include <fmt/format.h>

#include <cstddef>
#include <filesystem>
#include <span>
#include <utility>

#include "supple/core/error.hpp"
#include "supple/io/hdf5/elements.hpp"
#include "supple/io/run/file_recorder.hpp"
#include "supple/io/run/run_file.hpp"
#include "supple/io/run/run_merge.hpp"

namespace supple {
namespace {

/// Whether there was room for what `write` writes.
template <class Write>
bool try_to(Write&& write) {
  try {
    write();
    return true;
  } catch (const Error&) {
    return false;
  }
}

/// "12 frames from t = 0.1 s on".
template <int Dim>
std::string frame_text(std::span<const Frame<Dim>> frames, const Units& units) {
  const std::string unit = unit_text(units, unit::time);
  return fmt::format("{} frame{} from t = {:.6g}{} on", frames.size(), frames.size() == 1 ? "" : "s",
                     frames[0].time, unit.empty() ? "" : " " + unit);
}

/// "3 rows of stress from t = 0.1 s on".
std::string row_text(const std::string& table, const std::vector<Column>& columns,
                     std::span<const double> rows) {
  const std::size_t count = rows.size() / columns.size();
  return fmt::format("{} row{} of {} from {} = {:.6g}{} on", count, count == 1 ? "" : "s", table,
                     columns[0].name, rows[0], columns[0].unit.empty() ? "" : " " + columns[0].unit);
}

std::ptrdiff_t whole_part(double share, std::size_t count) {
  return static_cast<std::ptrdiff_t>(share * static_cast<double>(count));
}

}  // namespace

/// After a last segment for which there was no room: the final state, then rows and frames from the first on,
/// in pieces that become smaller as the room does. Returns what is lost; the recorder forgets it.
std::string FileRecorder::save_what_fits() {
  return std::visit([&](auto& sites) { return save_what_fits(sites); }, sites_);
}

template <int Dim>
std::string FileRecorder::save_what_fits(Sites<Dim>& sites) {
  const std::vector<Frame<Dim>> frames = std::exchange(sites.frames, {});
  std::map<std::string, std::vector<double>> rows;
  for (auto& [name, table] : tables_) rows[name] = std::exchange(table.rows, {});
  const auto rows_before = [&](double share, const std::string& name) {
    const auto width = std::max<std::size_t>(1, tables_.at(name).columns.size());
    return static_cast<std::ptrdiff_t>(width) * whole_part(share, rows.at(name).size() / width);
  };
  std::string lost;
  const auto lose = [&](const std::string& what) { lost += (lost.empty() ? "" : ", ") + what; };
  if (sites.final_state && !try_to([&] { write_segment(); })) lose("the final state");
  sites.final_state.reset();

  double saved = 0;  // share of what there was
  for (double piece = 0.5; saved < 1 && piece > 1e-3;) {
    const double end = saved + piece;
    sites.frames.assign(frames.begin() + whole_part(saved, frames.size()),
                        frames.begin() + whole_part(end, frames.size()));
    for (auto& [name, table] : tables_)
      table.rows.assign(rows.at(name).begin() + rows_before(saved, name),
                        rows.at(name).begin() + rows_before(end, name));
    if (try_to([&] { write_segment(); })) saved = end;
    else piece /= 2;
  }
  sites.frames.clear();
  for (auto& [name, table] : tables_) {
    table.rows.clear();
    const std::span<const double> left = std::span(rows.at(name)).subspan(rows_before(saved, name));
    if (!left.empty()) lose(row_text(name, table.columns, left));
  }
  const std::span<const Frame<Dim>> left = std::span(frames).subspan(whole_part(saved, frames.size()));
  if (!left.empty()) lose(frame_text(left, units()));
  return lost;
}

void FileRecorder::finish(const std::string& status) {
  if (failure_) throw *failure_;
  const std::string kept = "what is complete is in " + folder_ + ", which every command reads: supple show " +
                           folder_ + "; supple export " + folder_ +
                           " --to hdf5 -o NAME makes one file of it where there is room";
  if (status == "interrupted" && !phase_.empty())
    warnings_.push_back(
        fmt::format("{}{}{}", place_.empty() ? "interrupted" : place_,
                    phase_share_ > 0 ? fmt::format(", {:.0f} % of: ", 100 * phase_share_) : ", ", phase_));
  if (began() && !has_flushed_ && try_to([&] { save_whole(status); })) {
    finished_ = true;
    return clean_up(status);
  }
  try {
    if (began()) write_segment();
  } catch (const Error& e) {
    const std::string lost = save_what_fits();
    if (segments_ == 0) throw;
    // What the run ended of, where that was not the same.
    const bool another = status.starts_with("failed") && status.find("cannot write") == status.npos;
    if (!lost.empty())
      failure_.emplace(e.kind(), (another ? "the run " + status + "; " : "") + e.what(), "",
                       "lost: " + lost + "; " + kept);
  }
  finished_ = true;  // whatever the merge meets, the segments are complete
  try {
    if (began() && !failure_) save_merged(RunFile(folder_), status, path_, existing_);
  } catch (const Error& e) {
    failure_.emplace(e.kind(), e.what(), "", "nothing is lost: " + kept);
  }
  if (failure_) throw *failure_;
  clean_up(status);
}

/// The run file, where the first segment is the only one: without a way over the disk and back.
void FileRecorder::save_whole(const std::string& status) {
  h5::Group root = h5::create_file(path_);
  std::visit([&](const auto& sites) { write_header(root, case_, case_text_, *sites.info); }, sites_);
  root.set("status", status);
  write_news(root);
  h5::save(root, path_, existing_);
}

void FileRecorder::clean_up(const std::string& status) const {
  std::error_code error;
  if (status != "interrupted" || !can_resume()) std::filesystem::remove_all(folder_, error);
}

}  // namespace supple
