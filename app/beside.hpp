/// Names of the files that lie beside a run, and what several commands share.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "supple/experiment/case.hpp"
#include "supple/experiment/derived.hpp"
#include "supple/experiment/initial_state.hpp"
#include "supple/io/run/picture_mark.hpp"
#include "supple/io/run/run_file.hpp"

namespace supple::command {

/// The name of a file beside a run: "out/a_cell.png" for "out/a.h5" and "_cell.png".
std::string beside(const std::string& run, const std::string& ending);
/// The name of the figure, with an ending for what it shows: _stress.png, _pressure.png, ...
std::string plot_path(const std::string& run, const Case& c);
std::string snapshot_path(const std::string& run);
/// The name of an export; `to` as in export_run().
std::string export_path(const std::string& run, const std::string& to);

/// A run that is opened once for all of its pictures.
struct DrawnRun {
  RunFile run;
  std::string mark;  ///< of its pictures
  explicit DrawnRun(const std::string& path) : run(path), mark(mark_of(run)) {}
};
void snapshot(const DrawnRun& run, std::optional<int> frame, const PictureChoice& choice,
              const std::string& path, Existing existing);
void plot(const DrawnRun& run, const std::string& path, Existing existing);

/// Throws a file error where `file`, made from a run, may not be written: it exists, or it is the run itself.
void check_output_of(const std::string& run_path, const std::string& file, Existing existing);

enum class Warnings { shown, hidden };
/// What `show` prints of a run, as text or as JSON; the JSON always has the warnings.
std::string summarize(const RunFile& run, Format format, Warnings warnings);

/// Reads the state or packing that [initial] names, if it names one.
std::optional<InitialState> load_initial(const Case& c);
/// The same from a copy of that file; empty: there is none.
std::optional<InitialState> load_initial(const Case& c, const std::string& copy);

/// A case that has adopted what its state holds, and that state, if it starts from one.
struct LoadedCase {
  Case c;
  std::optional<InitialState> initial;
};
/// Reads the case, applies --set and --threads, takes over what the state holds, and checks it.
LoadedCase load_case(const CaseChoice& choice);

/// The derived numbers of the case; errors name its file.
std::vector<Derived> derive_case(const Case& c, const std::optional<InitialState>& initial);

}  // namespace supple::command
