#include "supple/io/run/checkpoint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <limits>

#include "supple/core/checksum.hpp"
#include "supple/core/path_kind.hpp"
#include "supple/core/version.hpp"
#include "supple/io/hdf5/elements.hpp"
#include "supple/io/hdf5/system_archive.hpp"
#include "supple/io/run/run_file.hpp"
#include "supple/io/run/run_merge.hpp"

namespace supple {
namespace {

namespace fs = std::filesystem;

constexpr auto checkpoint_format = "supple checkpoint 1", start_format = "supple start 1";
constexpr std::int64_t scalar = -1;  // in place of the length of a list

/// All values of one type: names, lengths, and the values one after the other.
template <class T>
void write_numbers(h5::Group& group, const std::string& kind, const Kept& kept) {
  std::vector<std::string> names;
  std::vector<std::int64_t> lengths;
  std::vector<T> values;
  for (const auto& [name, value] : kept) {
    if (const T* one = std::get_if<T>(&value)) {
      lengths.push_back(scalar);
      values.push_back(*one);
    } else if (const auto* list = std::get_if<std::vector<T>>(&value)) {
      lengths.push_back(static_cast<std::int64_t>(list->size()));
      values.insert(values.end(), list->begin(), list->end());
    } else {
      continue;
    }
    names.push_back(name);
  }
  group.write(kind + "_names", names);
  group.write(kind + "_lengths", lengths).set("meaning", std::string("-1: one number, not a list"));
  group.write(kind, values);
}

template <class T>
void read_numbers(const h5::Group& group, const std::string& kind, Kept& kept) {
  const auto names = group.read<std::string>(kind + "_names");
  const auto lengths = group.read<std::int64_t>(kind + "_lengths");
  const auto values = group.read<T>(kind);
  expect_sound(names.size() == lengths.size(), group, kind + ": names and lengths differ in number");
  std::size_t at = 0;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const std::size_t count = lengths[k] == scalar ? 1 : static_cast<std::size_t>(lengths[k]);
    expect_sound(lengths[k] >= scalar && count <= values.size() - at, group, kind + ": values are missing");
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(at);
    if (lengths[k] == scalar) kept[names[k]] = *begin;
    else kept[names[k]] = std::vector<T>(begin, begin + static_cast<std::ptrdiff_t>(count));
    at += count;
  }
}

/// A search keeps several states of the same particles, most arrays of which are the same.
template <int Dim>
void write_one(h5::Group& systems, const std::string& name, const System<Dim>& system) {
  std::vector<h5::Group> before;
  for (const std::string& earlier : systems.names()) before.push_back(systems.open_group(earlier));
  h5::Group group = systems.create_group(name);
  if (before.empty()) return write_system(group, system, reduced_units());
  h5::Group whole = h5::create_file("a system");
  write_system(whole, system, reduced_units());
  group.copy_or_share(whole, before);
}

/// The group that holds systems of this dimension.
constexpr const char* group_of_systems(int dimension) { return dimension == 2 ? "systems" : "systems_3d"; }

template <int Dim>
void write_systems(h5::Group& group, const Kept& kept) {
  h5::Group systems = group.create_group(group_of_systems(Dim));
  for (const auto& [name, value] : kept)
    if (const auto* system = std::get_if<System<Dim>>(&value)) write_one(systems, name, *system);
}

template <int Dim>
void read_systems(const h5::Group& group, Kept& kept) {
  const h5::Group systems = group.open_group(group_of_systems(Dim));
  for (const std::string& name : systems.names()) kept[name] = read_system<Dim>(systems.open_group(name));
}

bool has_3d(const Kept& kept) {
  return std::any_of(kept.begin(), kept.end(),
                     [](const auto& one) { return std::holds_alternative<System<3>>(one.second); });
}

void write_kept(h5::Group group, const Kept& kept) {
  write_numbers<double>(group, "numbers", kept);
  write_numbers<std::int64_t>(group, "integers", kept);
  h5::Group texts = group.create_group("texts");
  for (const auto& [name, value] : kept)
    if (const auto* text = std::get_if<std::string>(&value)) texts.write_scalar(name, *text);
  write_systems<2>(group, kept);
  if (has_3d(kept)) write_systems<3>(group, kept);
}

Kept read_kept(const h5::Group& group) {
  Kept kept;
  read_numbers<double>(group, "numbers", kept);
  read_numbers<std::int64_t>(group, "integers", kept);
  const h5::Group texts = group.open_group("texts");
  for (const std::string& name : texts.names()) kept[name] = texts.read_scalar<std::string>(name);
  read_systems<2>(group, kept);
  if (group.has(group_of_systems(3))) read_systems<3>(group, kept);
  return kept;
}

std::string crc_of(std::string_view bytes) { return fmt::format("{:08x}", checksum(bytes)); }

constexpr std::string_view prefix = "checkpoint-";

/// A checkpoint by its name.
struct Named {
  std::int64_t number = 0;
  std::string crc, path;
};

/// Checkpoints in a folder, the last one first.
std::vector<Named> checkpoints_in(const std::string& folder) {
  std::vector<Named> all;
  if (path_kind(folder) != PathKind::folder) return all;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    constexpr std::size_t digits = 6, crc = 8;
    if (!name.starts_with(prefix) || name.size() != prefix.size() + digits + 1 + crc + 3) continue;
    if (!name.ends_with(".h5") || name[prefix.size() + digits] != '-') continue;
    Named one{0, name.substr(prefix.size() + digits + 1, crc), entry.path().string()};
    const char* begin = name.data() + prefix.size();
    if (std::from_chars(begin, begin + digits, one.number).ptr == begin + digits) all.push_back(one);
  }
  std::sort(all.begin(), all.end(), [](const Named& a, const Named& b) { return a.number > b.number; });
  return all;
}

/// Input errors become file errors: what is wrong is the file.
Checkpoint read_one(const Named& named, const std::string& folder, const std::string& case_text) {
  const std::string bytes =
      read_whole_file(named.path, "a checkpoint", std::numeric_limits<std::size_t>::max());
  if (crc_of(bytes) != named.crc)
    throw file_error(named.path + " is damaged", "its bytes are not those that were written");
  const h5::Group root = h5::open_file(named.path);
  if (!root.has_attribute("format") || root.text("format") != checkpoint_format)
    throw file_error(named.path + " is of another version of Supple", "its layout is not known");
  if (const std::string by = root.text("supple_version"); by != version())
    throw file_error(named.path + " is of another version of Supple",
                     fmt::format("it was written by {}, this is {}", by, version()),
                     "go on with that version, or from the run's last state with initial.state");
  if (root.text("case") != crc_of(case_text))
    throw file_error(named.path + " is of another case", "it lies in the folder of this run");
  Checkpoint c{named.number,
               static_cast<int>(root.integer("segments")),
               root.integer("contacts"),
               root.number("cpu_time"),
               read_kept(root.open_group("kept")),
               root.open_group("pending")};
  for (int k = 0; k < c.segments; ++k)
    if (path_kind(folder + "/" + segment_name(k)) != PathKind::file)
      throw file_error(named.path + " cannot be used", segment_name(k) + " of the run is missing");
  return c;
}

}  // namespace

bool is_of_a_run(const std::string& name) {
  for (const char* begin : {"segment-", "merged", "checkpoint-", "start.h5", "initial."})
    if (name.starts_with(begin)) return true;
  return false;
}

void write_start(const std::string& folder, const RunStart& start) {
  const std::string path = folder + "/start.h5";
  h5::Group root = h5::create_file(path);
  root.set("format", std::string(start_format));
  root.set("supple_version", std::string(version()));
  root.set("origin", start.resolved.origin);
  store_case(root, start.resolved, start.case_text);
  root.write("given", std::vector<std::string>(start.resolved.given.begin(), start.resolved.given.end()));
  const bool packing = !start.resolved.initial.packing.empty();
  const std::string from = packing ? start.resolved.initial.packing : start.resolved.initial.state;
  std::string name;
  if (!from.empty()) {
    name = "initial" + fs::path(from).extension().string();
    const std::string to = folder + "/" + name;
    std::error_code error;
    if (path_kind(from) == PathKind::file) {
      fs::create_hard_link(fs::absolute(from), to, error);  // what replaces the file leaves this one alone
      if (error) fs::copy_file(from, to, error);
      if (error) throw file_error("cannot keep a copy of " + from + " in " + folder, error.message());
    } else if (path_kind(from) == PathKind::nothing && path_kind(partial_folder(from)) == PathKind::nothing) {
      name.clear();  // a program may hold the state in memory
    } else {
      name = "initial.h5";
      save_merged(RunFile(from), "interrupted", folder + "/" + name, Existing::replace);
    }
  }
  root.set("initial", name);
  h5::save(root, path);
}

RunStart read_start(const std::string& folder) {
  const std::string path = folder + "/start.h5";
  const h5::Group root = h5::open_file(path);
  if (!root.has_attribute("format") || root.text("format") != start_format)
    throw file_error(path + " is of another version of Supple", "its layout is not known");
  if (const std::string by = root.text("supple_version"); by != version())
    throw file_error(path + " is of another version of Supple",
                     fmt::format("the run was started by {}, this is {}", by, version()),
                     "go on with that version, or from the run's last state with initial.state");
  RunStart start{read_stored_case(root), root.read_scalar<std::string>("case"), root.text("initial")};
  const auto given = root.read<std::string>("given");
  start.resolved.given = {given.begin(), given.end()};
  start.resolved.origin = root.text("origin");
  if (!start.initial.empty()) start.initial = folder + "/" + start.initial;
  return start;
}

h5::Group begin_checkpoint(const std::string& folder, const std::string& case_text,
                           const Checkpoint& checkpoint) {
  h5::Group root = h5::create_file(folder + "/checkpoint");
  root.set("format", std::string(checkpoint_format));
  root.set("supple_version", std::string(version()));
  root.set("case", crc_of(case_text));
  root.set("segments", static_cast<std::int64_t>(checkpoint.segments));
  root.set("contacts", checkpoint.contacts);
  root.set("cpu_time", checkpoint.cpu_time);
  write_kept(root.create_group("kept"), checkpoint.kept);
  return root;
}

void publish_checkpoint(h5::Group& root, const std::string& folder, std::int64_t number) {
  const std::string_view bytes = h5::bytes_of(root);
  write_whole_file(fmt::format("{}/{}{:06}-{}.h5", folder, prefix, number, crc_of(bytes)), bytes);
  const std::vector<Named> all = checkpoints_in(folder);
  for (std::size_t k = 2; k < all.size(); ++k) {
    std::error_code error;  // one too many does no harm
    fs::remove(all[k].path, error);
  }
}

std::optional<Checkpoint> read_checkpoint(const std::string& folder, const std::string& case_text,
                                          std::vector<std::string>& refused) {
  const std::vector<Named> all = checkpoints_in(folder);
  for (const Named& named : all) try {
      return read_one(named, folder, case_text);
    } catch (const Error& e) {
      refused.push_back(e.what());
    }
  if (all.empty()) return std::nullopt;
  std::string why;
  for (const std::string& reason : refused) why += (why.empty() ? "" : "; ") + reason;
  throw file_error("no checkpoint in " + folder + " can be used", why,
                   "start again with supple run, or from the run's last state with initial.state");
}

}  // namespace supple
