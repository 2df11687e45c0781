/// The commands behind `supple NAME`. They print to stdout, and progress and warnings to stderr; errors are
/// thrown as supple::Error. Where a command writes a file, the name - means stdout.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "supple/core/new_file.hpp"
#include "supple/experiment/case.hpp"
#include "supple/io/run/run_pictures.hpp"

namespace supple::command {

enum class Format { text, json };

/// A case as named on the command line.
struct CaseChoice {
  std::string path;
  std::vector<std::string> set;  ///< "section.key=value"
  int threads = 0;               ///< 0: as the case says
};

/// Seconds of wall time between checkpoints of a run (0: only where it stops; none: as the library chooses),
/// and after which it stops (0: never).
struct Timing {
  std::optional<double> checkpoint;
  double limit = 0;
};

/// Writes a commented case of the experiment. Where `physics` is empty it is the first of the experiment;
/// where `path` is empty the file is EXPERIMENT.toml.
void init(const std::string& experiment, const std::string& physics, const std::string& path,
          Existing existing);

/// Checks the case, and prints derived numbers and doubts.
void check(const CaseChoice& choice, Format format);

/// Runs the case, writes the run file and what [output] asks for beside it, and prints the summary. Where
/// `path` is empty the file is that of the case (output.file), or the case's name with .h5 in the current
/// folder.
void run(const CaseChoice& choice, const std::string& path, Existing existing, Format format,
         const Timing& timing);

/// Goes on with a run that was stopped, from its last checkpoint, as if it had not been. `threads` 0: as many
/// as it was started with.
void resume(const std::string& run_path, int threads, Format format, const Timing& timing);

/// The signal that asked the command to stop; 0: none.
int stop_signal();

/// Prints experiments, laws, and every parameter with unit, default and meaning. `what`: only the keys of
/// this section, or only those that this experiment uses.
void list(const std::string& what, Format format);

/// Writes the summary of a run.
void show(const std::string& run_path, Format format, const std::string& path = "-",
          Existing existing = Existing::refuse);

/// Writes a run as "csv" (the main table), "contacts", "energy" (needs output.energies), "trajectory" (the
/// published columns), "text" (the published format), "state" (JSON of discs), "xyz" or "vtp" (all frames;
/// `cells` of vtp: polygons, outlines, triangles), "packing" (JSON of deformable particles), or "hdf5" (one
/// file of all segments). Where `path` is empty the file lies beside the run.
void export_run(const std::string& run_path, const std::string& to, const std::string& path,
                Existing existing, const std::string& cells = "polygons");

/// Draws frame `frame` (negative: counted from the end; none: the most sheared one, or the last
/// where none is); `choice` as for draw_frame(); `path` empty:
/// beside the run.
void snapshot(const std::string& run_path, std::optional<int> frame, const PictureChoice& choice,
              const std::string& path, Existing existing);

/// Draws the figure of a run: what it shows depends on the experiment (Figure).
void plot(const std::string& run_path, const std::string& path, Existing existing);

}  // namespace supple::command
