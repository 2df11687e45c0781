/// export, snapshot, plot: what is made of a run file.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "beside.hpp"
#include "commands.hpp"
#include "supple/compat/particleshear/text.hpp"
#include "supple/core/error.hpp"
#include "supple/io/export/csv.hpp"
#include "supple/io/export/trajectory.hpp"
#include "supple/io/run/figures.hpp"
#include "supple/io/run/picture_mark.hpp"
#include "supple/io/run/run_file.hpp"
#include "supple/io/run/run_layout.hpp"
#include "supple/io/run/run_merge.hpp"
#include "supple/io/run/run_pictures.hpp"
#include "supple/io/state/packing_file.hpp"
#include "supple/io/state/state_file.hpp"

namespace supple::command {

namespace {

/// Shear strains of the frames, or where these are none how far plates or a wall have come.
std::vector<double> strains_of(const RunFile& run) {
  std::vector<double> strains = run.strains();
  for (std::size_t k = 0; k < strains.size(); ++k) {
    const auto at = static_cast<std::int64_t>(k);
    const SystemNumbers numbers = run.dimensions() == 2 ? run.frame(at).numbers : run.frame<3>(at).numbers;
    const auto pressed = numbers.find("uniaxial_strain");
    if (pressed == numbers.end()) break;
    strains[k] = pressed->second;
  }
  return strains;
}

/// The frame that pictures show by default: the first one with the largest strain; without strain, the last.
std::int64_t telling_frame(const RunFile& run) {
  const std::vector<double> strains = strains_of(run);
  std::size_t best = 0;
  double largest = 0;
  for (std::size_t k = 0; k < strains.size(); ++k)
    if (const double strain = std::abs(strains[k]); strain > largest * (1 + 1e-9)) {
      largest = strain;
      best = k;
    }
  return largest > 0 ? static_cast<std::int64_t>(best) : run.frames() - 1;
}

/// Throws an input error where the format cannot hold the particles of the run.
void check_matter(const std::string& run_path, const std::string& format, const Matter& wanted,
                  const std::string& to_do) {
  const Matter& there = *experiment_of(RunFile(run_path).resolved_case()).matter;
  if (&there == &wanted) return;
  throw input_error(fmt::format("{} holds {}", run_path, there.name),
                    fmt::format("{} holds {}", format, wanted.name), to_do);
}

}  // namespace

std::string beside(const std::string& run, const std::string& ending) {
  return std::filesystem::path(run).replace_extension().string() + ending;
}
std::string plot_path(const std::string& run, const Case& c) {
  return beside(run, fmt::format("_{}.png", figure_subject(experiment_of(c).figure(c))));
}
std::string snapshot_path(const std::string& run) { return beside(run, "_cell.png"); }
std::string export_path(const std::string& run, const std::string& to) {
  static const std::map<std::string, std::string> endings{{"csv", ".csv"},
                                                          {"text", ".txt"},
                                                          {"state", "_state.json"},
                                                          {"xyz", ".xyz"},
                                                          {"vtp", ".pvd"},
                                                          {"packing", "_packing.json"},
                                                          {"contacts", "_contacts.csv"},
                                                          {"energy", "_energy.csv"},
                                                          {"trajectory", "_trajectory.csv"},
                                                          {"hdf5", "_so_far.h5"}};
  return beside(run, endings.at(to));
}

void check_output_of(const std::string& run_path, const std::string& file, Existing existing) {
  check_not_input(file, run_path);
  // nor may it be a segment of a run that goes on
  check_not_input(std::filesystem::absolute(file).parent_path().string(), partial_folder(run_path));
  check_can_create(file, existing);
}

namespace {

/// Draws a picture of the run, which replaces one of the same run unasked.
template <class Draw>
void draw(const DrawnRun& drawn, const std::string& file, Existing existing, Draw&& picture) {
  check_output_of(drawn.run.path(), file, is_marked(file, drawn.mark) ? Existing::replace : existing);
  picture();
  if (file != standard_output) mark_picture(file, drawn.mark);
}

}  // namespace

void export_run(const std::string& run_path, const std::string& to, const std::string& path,
                Existing existing, const std::string& cells) {
  const std::string file = path.empty() ? export_path(run_path, to) : path;
  check_output_of(run_path, file, existing);
  if (to == "vtp" && file == standard_output)
    throw input_error("--to vtp -o -", "frames for ParaView are a file and a folder", "give a name");
  static const std::map<std::string, std::string> of_discs{
      {"text", "the published text"}, {"trajectory", "a trajectory"}, {"state", "the JSON of states"}};
  if (const auto at = of_discs.find(to); at != of_discs.end())
    check_matter(run_path, at->second, disc_matter(),
                 "export --to packing, or start from the run itself: [initial] state = \"" + run_path + "\"");
  if (to == "packing") check_matter(run_path, "a packing", body_matter(), "export --to state");
  if (to == "csv") export_csv(RunFile(run_path), file, existing);
  else if (to == "xyz") export_xyz(RunFile(run_path), file, existing);
  else if (to == "contacts") export_contacts(RunFile(run_path), file, existing);
  else if (to == "energy") export_energy(RunFile(run_path), file, existing);
  else if (to == "trajectory") export_trajectory(RunFile(run_path), file, existing);
  else if (to == "hdf5") save_merged(RunFile(run_path), RunFile(run_path).status(), file, existing);
  else if (to == "vtp")
    export_vtp(RunFile(run_path), file, existing,
               cells == "triangles"  ? Cells::triangles
               : cells == "outlines" ? Cells::outlines
                                     : Cells::polygons);
  else if (to == "packing") write_packing_json(as_packing(read_state(run_path)), file, existing);
  else if (to == "text") export_published_text(RunFile(run_path), file, existing);
  else write_state_json(read_state(run_path), file, existing);
}

void snapshot(const DrawnRun& drawn, std::optional<int> frame, const PictureChoice& choice,
              const std::string& path, Existing existing) {
  const RunFile& run = drawn.run;
  const std::string file = path.empty() ? snapshot_path(run.path()) : path;
  draw(drawn, file, existing, [&] {
    const std::int64_t count = run.frames();
    if (count == 0) throw input_error(run.path() + " holds no frames", "it stopped before its first step");
    const std::int64_t k = !frame ? telling_frame(run) : *frame < 0 ? count + *frame : *frame;
    if (k < 0 || k >= count)
      throw input_error(fmt::format("{} has no frame {}", run.path(), *frame), "",
                        fmt::format("give 0 to {}, or -1 for the last", count - 1));
    draw_frame(file, run, k, choice);
  });
}

void plot(const DrawnRun& drawn, const std::string& path, Existing existing) {
  const std::string file = path.empty() ? plot_path(drawn.run.path(), drawn.run.resolved_case()) : path;
  draw(drawn, file, existing, [&] { draw_figure(file, drawn.run); });
}

void snapshot(const std::string& run_path, std::optional<int> frame, const PictureChoice& choice,
              const std::string& path, Existing existing) {
  snapshot(DrawnRun(run_path), frame, choice, path, existing);
}

void plot(const std::string& run_path, const std::string& path, Existing existing) {
  plot(DrawnRun(run_path), path, existing);
}

}  // namespace supple::command
