/// Reading a run: its finished file, or the segments of a run that is going on or was killed.
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "supple/experiment/case.hpp"
#include "supple/experiment/recorder.hpp"
#include "supple/io/hdf5/hdf5.hpp"
#include "supple/io/run/run_layout.hpp"

namespace supple {

/// Everything that a run file holds. All functions throw a file error where the file is damaged.
class RunFile {
 public:
  /// `path` is the run file; or, where there is none, the run whose segments lie in `<path>.partial`; or that
  /// folder. Throws a file error that tells apart files that are missing, not HDF5, truncated, and HDF5 but
  /// not a run.
  explicit RunFile(const std::string& path);

  const std::string& path() const { return path_; }
  /// "complete", "interrupted", "failed: why", or "unfinished" for segments (killed, or still going on).
  std::string status() const;
  std::string version() const;
  std::string experiment() const;
  std::string physics() const;
  std::int64_t seed() const;
  /// The resolved case, as TOML text and as values.
  std::string case_text() const;
  Case resolved_case() const;
  /// 2 or 3.
  int dimensions() const;
  /// What stays the same in a run of so many dimensions. This, frame() and final_state() throw a file error
  /// where the run has others.
  template <int Dim = 2>
  RunInfo<Dim> info() const;

  std::vector<std::string> tables() const;
  bool has_table(const std::string& table) const;
  const std::vector<Column>& columns(const std::string& table) const&;
  std::vector<Column> columns(const std::string& table) && { return read_columns_of(table); }
  std::int64_t rows(const std::string& table) const;
  /// The values of a column. Throws a file error that lists the columns where there is none of that name.
  std::vector<double> column(const std::string& table, const std::string& name) const;

  std::int64_t frames() const;
  /// Frame k, 0 <= k < frames().
  template <int Dim = 2>
  Frame<Dim> frame(std::int64_t k) const;
  /// The strain of every frame, without the rest of them.
  std::vector<double> strains() const;
  /// Unit of a number that frames hold of each body: as a table names it that has one of the same name for
  /// all, or in runs whose units have names as the frames do. Empty: none.
  std::string unit_of_bodies(const std::string& number) const;

  /// Names of the groups of numbers: constants, results, ...
  std::vector<std::string> value_groups() const;
  /// The numbers of a group ("constants", "results", "material"), in the order they were written.
  const std::vector<RunValue>& values(const std::string& group) const&;
  std::vector<RunValue> values(const std::string& group) && { return read_values_of(group); }
  std::optional<double> find_value(const std::string& group, const std::string& name) const;
  /// The number of this name. Throws a file error where there is none.
  double value(const std::string& group, const std::string& name) const;
  std::vector<std::string> warnings() const;

  bool has_final_state() const;
  template <int Dim = 2>
  std::pair<System<Dim>, Evaluation<Dim>> final_state() const;

 private:
  friend void save_merged(const RunFile&, const std::string&, const std::string&, Existing);

  struct Segment {
    std::string path;
    std::int64_t frames, contacts;  ///< rows in it
  };
  void require_dimensions(int wanted) const;
  const h5::Group& segment(std::size_t index) const;
  /// The same; where the segment cannot be opened, the error says how to read those before it.
  const h5::Group& first_look(std::size_t index) const;
  std::size_t segments() const { return segments_.size(); }
  std::vector<Column> read_columns_of(const std::string& table) const;
  std::vector<RunValue> read_values_of(const std::string& group) const;
  /// Keeps the arrays of a segment's frames open from one frame to the next, and so the pieces that HDF5 has
  /// unpacked.
  const h5::Group& open_frames(std::size_t index) const;

  std::string path_;
  bool partial_ = false;
  std::vector<Segment> segments_;
  mutable std::optional<AnyRunInfo> info_;  ///< once a frame was read
  mutable std::size_t open_index_ = static_cast<std::size_t>(-1);
  mutable h5::Group open_;                  ///< the segment last used: most calls ask for the same one again
  mutable h5::Group frames_;                ///< of the segment last used, once a frame was read
  mutable std::vector<h5::Object> arrays_;  ///< of its frames
  mutable std::map<std::string, std::vector<Column>> columns_;   ///< by table, once asked for
  mutable std::map<std::string, std::vector<RunValue>> values_;  ///< by group, likewise
};

}  // namespace supple
