#include "supple/io/run/run_merge.hpp"

#include <map>

namespace supple {
namespace {

/// Rows of each array below the group `name`, of all segments together.
void count_rows(const h5::Group& from, const std::string& name, std::map<std::string, std::uint64_t>& rows) {
  if (!from.has(name)) return;
  const h5::Group group = from.open_group(name);
  for (const std::string& member : group.names())
    if (group.is_group(member)) count_rows(from, name + "/" + member, rows);
    else rows[name + "/" + member] += group.shape(member).at(0);
}

/// An array of the merged file, open until all of its rows are written.
struct MergedArray {
  h5::Object dataset;
  std::uint64_t written = 0;
};

/// Writes the rows of each array below the group `name` of `from` behind those that `to` has already.
struct RowMerger {
  h5::Group& to;
  std::map<std::string, std::uint64_t> rows;
  std::map<std::string, MergedArray> arrays;

  void merge(const h5::Group& from, const std::string& name) {
    if (!from.has(name)) return;
    const h5::Group source = from.open_group(name);
    h5::Group group = to.has(name) ? to.open_group(name) : to.create_group(name);
    for (const std::string& member : source.names()) {
      const std::string path = name + "/" + member;
      if (source.is_group(member)) {
        merge(from, path);
        continue;
      }
      const auto [at, made] = arrays.try_emplace(path);
      MergedArray& array = at->second;
      if (made) array.dataset = group.create_like(source, member, rows.at(path));
      source.copy_rows(member, array.dataset, array.written);
      array.written += source.shape(member).at(0);
    }
  }
};

}  // namespace

void save_merged(const RunFile& run, const std::string& status, const std::string& path, Existing existing) {
  h5::Group root = h5::create_file(path);
  RowMerger merger{root, {}, {}};
  std::size_t last_state = run.segments();
  for (std::size_t s = 0; s < run.segments(); ++s)
    for (const char* name : {"tables", "frames"}) count_rows(run.segment(s), name, merger.rows);
  for (std::size_t s = 0; s < run.segments(); ++s) {
    const h5::Group& segment = run.segment(s);
    if (s == 0) {
      root.copy_attributes(segment);
      root.set("status", status);
      for (const char* name : {"case", "box", "discs"}) root.copy(segment, name);
    }
    for (const char* name : {"tables", "frames"}) merger.merge(segment, name);
    if (segment.has("final_state")) last_state = s;
  }
  merger.arrays.clear();
  for (const std::string& group : run.value_groups()) {
    h5::Group target = root.create_group(group);
    for (const RunValue& value : run.values(group)) write_value(target, value);
  }
  root.write("warnings", run.warnings());
  if (last_state < run.segments()) root.copy(run.segment(last_state), "final_state");
  h5::save(root, path, existing);
}

}  // namespace supple
