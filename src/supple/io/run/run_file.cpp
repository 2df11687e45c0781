#include "supple/io/run/run_file.hpp"

#include <algorithm>
#include <cmath>

#include "supple/core/error.hpp"
#include "supple/core/path_kind.hpp"
#include "supple/io/hdf5/elements.hpp"
#include "supple/io/hdf5/system_archive.hpp"

namespace supple {
namespace {

/// The complete segments in a folder, in order.
std::vector<std::string> segments_in(const std::string& folder) {
  std::vector<std::string> paths;
  while (PathKind::file == path_kind(folder + "/" + segment_name(static_cast<int>(paths.size()))))
    paths.push_back(folder + "/" + segment_name(static_cast<int>(paths.size())));
  if (paths.empty()) throw file_error(folder + " holds no run", "no segment is complete");
  return paths;
}

std::string joined(const std::vector<std::string>& names) {
  std::string out;
  for (const std::string& name : names) out += (out.empty() ? "" : ", ") + name;
  return out;
}

/// Groups of the layout that do not hold values.
bool holds_values(const std::string& name) {
  static const std::vector<std::string> others{"case",   "box",      "discs",      "tables",
                                               "frames", "warnings", "final_state"};
  return std::find(others.begin(), others.end(), name) == others.end();
}

}  // namespace

RunFile::RunFile(const std::string& path) : path_(path) {
  std::vector<std::string> paths{path};
  const PathKind kind = path_kind(path);
  if (kind == PathKind::folder) partial_ = true;
  else if (kind == PathKind::nothing && path_kind(partial_folder(path)) == PathKind::folder)
    partial_ = true, path_ = partial_folder(path);
  if (partial_) paths = segments_in(path_);

  for (const std::string& file : paths) {
    segments_.push_back({file, 0, 0});
    const h5::Group& root = first_look(segments_.size() - 1);
    if (segments_.size() == 1 && !(root.has_attribute("format") && root.text("format") == run_format))
      throw file_error(path + " is not a run of Supple", "it is HDF5 of another kind, or of another version");
    if (!root.has("frames")) continue;
    segments_.back().frames = static_cast<std::int64_t>(rows_in(root, "frames/step"));
    segments_.back().contacts = static_cast<std::int64_t>(rows_in(root, "frames/contact_first"));
  }
}

const h5::Group& RunFile::first_look(std::size_t index) const {
  try {
    return segment(index);
  } catch (const Error& e) {
    if (!partial_ || index == 0) throw;
    throw Error(e.kind(), e.what(), "",
                "what is before it can be read once it and the later segments are moved out of " + path_);
  }
}

const h5::Group& RunFile::segment(std::size_t index) const {
  if (index != open_index_) {
    arrays_.clear();
    frames_ = h5::Group();
    open_ = h5::open_file(segments_[index].path);
    open_index_ = index;
  }
  return open_;
}

std::string RunFile::status() const { return partial_ ? "unfinished" : segment(0).text("status"); }
std::string RunFile::version() const { return segment(0).text("supple_version"); }
std::string RunFile::experiment() const { return segment(0).text("experiment"); }
std::string RunFile::physics() const { return segment(0).text("physics"); }
std::int64_t RunFile::seed() const { return segment(0).integer("seed"); }
std::string RunFile::case_text() const { return segment(0).read_scalar<std::string>("case"); }
Case RunFile::resolved_case() const { return read_stored_case(segment(0)); }
int RunFile::dimensions() const { return dimensions_of(segment(0)); }

void RunFile::require_dimensions(int wanted) const {
  if (dimensions() != wanted)
    throw file_error(path_ + " is a run in " + (wanted == 2 ? "three" : "two") + " dimensions",
                     std::string("this is about runs in ") + (wanted == 2 ? "two" : "three"));
}

template <int Dim>
RunInfo<Dim> RunFile::info() const {
  require_dimensions(Dim);
  return read_info<Dim>(segment(0));
}

std::vector<std::string> RunFile::tables() const {
  std::vector<std::string> out;
  for (std::size_t s = 0; s < segments(); ++s)
    for (const std::string& name : segment(s).open_group("tables").names())
      if (std::find(out.begin(), out.end(), name) == out.end()) out.push_back(name);
  return out;
}

bool RunFile::has_table(const std::string& table) const {
  const auto all = tables();
  return std::find(all.begin(), all.end(), table) != all.end();
}

const std::vector<Column>& RunFile::columns(const std::string& table) const& {
  const auto known = columns_.find(table);
  return known != columns_.end() ? known->second : columns_[table] = read_columns_of(table);
}

std::vector<Column> RunFile::read_columns_of(const std::string& table) const {
  for (std::size_t s = 0; s < segments(); ++s) {
    const h5::Group tables = segment(s).open_group("tables");
    if (!tables.has(table)) continue;
    const h5::Group group = tables.open_group(table);
    std::vector<Column> out;
    for (const std::string& name : group.names()) {
      const h5::Object column = group.open_dataset(name);
      out.push_back({name, column.text("unit"), column.text("meaning")});
    }
    return out;
  }
  throw file_error(path_ + " has no table '" + table + "'", "its tables are: " + joined(tables()));
}

std::int64_t RunFile::rows(const std::string& table) const {
  const std::vector<Column>& all = columns(table);
  if (all.empty()) return 0;
  const std::string& name = all[0].name;
  std::int64_t rows = 0;
  for (std::size_t s = 0; s < segments(); ++s)
    if (const h5::Group tables = segment(s).open_group("tables"); tables.has(table))
      rows += static_cast<std::int64_t>(rows_in(tables, table + "/" + name));
  return rows;
}

std::vector<double> RunFile::column(const std::string& table, const std::string& name) const {
  std::vector<std::string> names;
  for (const Column& column : columns(table)) names.push_back(column.name);
  if (std::find(names.begin(), names.end(), name) == names.end())
    throw file_error(path_ + " has no column '" + name + "' in table '" + table + "'",
                     "its columns are: " + joined(names));
  std::vector<double> out;
  for (std::size_t s = 0; s < segments(); ++s)
    if (const h5::Group tables = segment(s).open_group("tables"); tables.has(table)) {
      expect_sound(rows_in(tables, table + "/" + name) == rows_in(tables, table + "/" + names[0]), tables,
                   "columns of table '" + table + "' differ in length");
      const auto part = tables.read<double>(table + "/" + name);
      out.insert(out.end(), part.begin(), part.end());
    }
  return out;
}

std::int64_t RunFile::frames() const {
  std::int64_t n = 0;
  for (const Segment& s : segments_) n += s.frames;
  return n;
}

const h5::Group& RunFile::open_frames(std::size_t index) const {
  const h5::Group& root = segment(index);
  if (frames_.id() >= 0) return frames_;
  frames_ = root.open_group("frames");
  const auto hold = [&](const h5::Group& group) {
    for (const std::string& name : group.names())
      if (!group.is_group(name)) arrays_.push_back(group.open_dataset(name));
  };
  hold(frames_);
  for (const char* name : {"body", "system"})
    if (frames_.has(name)) hold(frames_.open_group(name));
  return frames_;
}

template <int Dim>
Frame<Dim> RunFile::frame(std::int64_t k) const {
  std::int64_t first = 0, contacts = 0;
  for (std::size_t s = 0; s < segments(); ++s) {
    if (k >= first && k < first + segments_[s].frames) {
      if (!info_ || !std::holds_alternative<RunInfo<Dim>>(*info_)) info_ = info<Dim>();
      return read_frame(open_frames(s), static_cast<std::uint64_t>(k - first), contacts,
                        std::get<RunInfo<Dim>>(*info_));
    }
    first += segments_[s].frames;
    contacts += segments_[s].contacts;
  }
  throw file_error(path_ + " has no frame " + std::to_string(k), "it has " + std::to_string(frames()));
}

std::vector<double> RunFile::strains() const {
  std::vector<double> out;
  for (std::size_t s = 0; s < segments(); ++s) {
    if (segments_[s].frames == 0) continue;
    const h5::Group frames = segment(s).open_group("frames");
    const std::vector<double> part = frames.read<double>("strain");
    expect_sound(static_cast<std::int64_t>(part.size()) == segments_[s].frames, frames,
                 "strains are missing");
    for (const double strain : part) expect_sound(std::abs(strain) < far_away, frames, "a cell that is none");
    out.insert(out.end(), part.begin(), part.end());
  }
  return out;
}

std::string RunFile::unit_of_bodies(const std::string& number) const {
  if (segment(0).text("units") == reduced_units().name) {
    for (const std::string& table : tables())
      for (const Column& column : columns(table))
        if (column.name == number) return column.unit;
    return "";
  }
  for (std::size_t s = 0; s < segments(); ++s) {
    if (segments_[s].frames == 0) continue;
    const h5::Object array = segment(s).open_group("frames").open_group("body").open_dataset(number);
    return array.has_attribute("unit") ? array.text("unit") : "";
  }
  return "";
}

std::vector<std::string> RunFile::value_groups() const {
  std::vector<std::string> out;
  for (std::size_t s = 0; s < segments(); ++s)
    for (const std::string& name : segment(s).names())
      if (holds_values(name) && std::find(out.begin(), out.end(), name) == out.end()) out.push_back(name);
  return out;
}

const std::vector<RunValue>& RunFile::values(const std::string& group) const& {
  const auto known = values_.find(group);
  return known != values_.end() ? known->second : values_[group] = read_values_of(group);
}

std::vector<RunValue> RunFile::read_values_of(const std::string& group) const {
  std::vector<RunValue> out;
  for (std::size_t s = 0; s < segments(); ++s) {
    if (!segment(s).has(group)) continue;
    for (RunValue& value : read_values(segment(s).open_group(group))) {
      const auto old = std::find_if(out.begin(), out.end(),
                                    [&](const RunValue& v) { return v.name.name == value.name.name; });
      if (old == out.end()) out.push_back(std::move(value));
      else *old = std::move(value);
    }
  }
  return out;
}

std::optional<double> RunFile::find_value(const std::string& group, const std::string& name) const {
  for (const RunValue& value : values(group))
    if (value.name.name == name) return value.value;
  return std::nullopt;
}

double RunFile::value(const std::string& group, const std::string& name) const {
  if (const auto found = find_value(group, name)) return *found;
  throw file_error(path_ + " has no number '" + name + "' in '" + group + "'");
}

std::vector<std::string> RunFile::warnings() const {
  std::vector<std::string> out;
  for (std::size_t s = 0; s < segments(); ++s)
    for (std::string& text : segment(s).read<std::string>("warnings")) out.push_back(std::move(text));
  return out;
}

bool RunFile::has_final_state() const {
  for (std::size_t s = 0; s < segments(); ++s)
    if (segment(s).has("final_state")) return true;
  return false;
}

template <int Dim>
std::pair<System<Dim>, Evaluation<Dim>> RunFile::final_state() const {
  require_dimensions(Dim);
  for (std::size_t s = segments(); s-- > 0;)
    if (segment(s).has("final_state")) {
      const h5::Group state = segment(s).open_group("final_state");
      std::pair<System<Dim>, Evaluation<Dim>> both{read_system<Dim>(state),
                                                   read_evaluation<Dim>(state.open_group("evaluation"))};
      expect_sound(both.second.force.size() == both.first.state.position.size(), state,
                   "forces and sites differ in number");
      return both;
    }
  throw file_error(path_ + " has no final state", "its status is: " + status());
}

template RunInfo<2> RunFile::info() const;
template RunInfo<3> RunFile::info() const;
template Frame<2> RunFile::frame(std::int64_t) const;
template Frame<3> RunFile::frame(std::int64_t) const;
template std::pair<System<2>, Evaluation<2>> RunFile::final_state() const;
template std::pair<System<3>, Evaluation<3>> RunFile::final_state() const;

}  // namespace supple
