/// The commands behind `supple NAME`. They print to stdout, and progress and warnings to stderr; what goes
/// wrong is thrown as supple::Error. Where they write a file, the name - is stdout.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "supple/core/new_file.hpp"
#include "supple/experiment/case.hpp"

namespace supple::command {

enum class Format { text, json };

/// A case as named on the command line.
struct CaseChoice {
  std::string path;
  std::vector<std::string> set;  ///< "section.key=value"
  int threads = 0;               ///< 0: as the case says
};

/// Writes a commented case of that experiment; `physics` empty: its first one; `path` empty: EXPERIMENT.toml;
/// "-": stdout.
void init(const std::string& experiment, const std::string& physics, const std::string& path,
          Existing existing);

/// Validates and prints derived numbers and doubts.
void check(const CaseChoice& choice, Format format);

/// Runs, writes the run file and what [output] asks for beside it, and prints the summary.
/// `path` empty: what the case says, or the case's name with .h5 in the current folder.
void run(const CaseChoice& choice, const std::string& path, Existing existing, Format format);

/// Experiments, laws and choices, every parameter with unit, default and meaning; `what`: the keys of this
/// section alone, or those that this experiment uses.
void list(const std::string& what, Format format);

/// Writes the summary of a run.
void show(const std::string& run_path, Format format, const std::string& path = "-",
          Existing existing = Existing::refuse);

/// Writes a run as "csv" (the main table), "contacts", "energy" (output.energies), "trajectory" (the
/// published columns), "text" (the published format), "state" (its JSON layout), "xyz" or
/// "vtp" (all frames; `cells` of vtp: polygons, outlines, triangles), "packing" (polygons as JSON), or "hdf5"
/// (one file of its segments); `path` empty: beside the run.
void export_run(const std::string& run_path, const std::string& to, const std::string& path,
                Existing existing, const std::string& cells = "polygons");

/// Draws frame `frame` (negative: counted from the end; none: the most sheared one, of deformable particles
/// the last); `color`: the number of each deformable particle that colours it, or empty; `path` empty: beside
/// the run.
void snapshot(const std::string& run_path, std::optional<int> frame, const std::string& color,
              const std::string& path, Existing existing);

/// Draws the figure of a run: strain and stress against time and the Lissajous loop, or what deformable
/// particles do.
void plot(const std::string& run_path, const std::string& path, Existing existing);

}  // namespace supple::command
