#include "supple/io/export/trajectory.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <utility>
#include <vector>

#include "supple/core/error.hpp"
#include "supple/core/path_kind.hpp"
#include "supple/draw/scene/frame_scene.hpp"
#include "supple/io/export/xyz.hpp"

namespace supple {

namespace {

namespace fs = std::filesystem;

void check_frames(const RunFile& run) {
  if (run.frames() == 0)
    throw input_error(run.path() + " holds no frames", "it stopped before its first step");
}

/// Times of the frames or, where they do not go on, as of packings at rest, the numbers of the frames. Frames
/// of one instant, as older runs hold, count once: the last of them.
template <int Dim>
std::vector<std::pair<double, std::int64_t>> instants(const RunFile& run) {
  std::vector<std::pair<double, std::int64_t>> out;
  bool descends = false;
  for (std::int64_t k = 0; k < run.frames(); ++k) {
    const double time = run.frame<Dim>(k).time;
    if (!out.empty() && time == out.back().first) out.pop_back();
    descends = descends || !std::isfinite(time) || (!out.empty() && time < out.back().first);
    out.emplace_back(time, k);
  }
  if (!descends && (out.size() > 1 || run.frames() == 1)) return out;
  out.clear();
  for (std::int64_t k = 0; k < run.frames(); ++k) out.emplace_back(static_cast<double>(k), k);
  return out;
}

template <int Dim>
void append_frames(const RunFile& run, XyzFile& file) {
  const RunInfo<Dim> info = run.info<Dim>();
  for (std::int64_t k = 0; k < run.frames(); ++k) file.append(body_scene_of(info, run.frame<Dim>(k)));
}

/// Writes the frames into their folder; gives their names and times.
template <int Dim>
std::vector<PvdEntry> write_frames(const RunFile& run, const std::string& folder, Existing existing,
                                   Cells cells) {
  const RunInfo<Dim> info = run.info<Dim>();
  std::vector<PvdEntry> frames;
  for (const auto& [time, k] : instants<Dim>(run)) {
    const std::string name = fmt::format("frame{:07}.vtp", frames.size());
    write_vtp(folder + "/" + name, body_scene_of(info, run.frame<Dim>(k)), existing, export_placement<Dim>,
              cells);
    frames.emplace_back(time, fs::path(folder).filename().string() + "/" + name);
  }
  return frames;
}

}  // namespace

void export_xyz(const RunFile& run, const std::string& path, Existing existing) {
  check_frames(run);
  const bool flat = run.dimensions() == 2;
  XyzFile file(path, existing, flat ? export_placement<2> : export_placement<3>);
  if (flat) append_frames<2>(run, file);
  else append_frames<3>(run, file);
  file.commit();
}

std::string frame_folder(const std::string& path) {
  return fs::path(path).replace_extension().string() + "_frames";
}

void check_can_export_vtp(const std::string& path, Existing existing) {
  check_can_create(path, existing);
  if (existing == Existing::refuse && fs::exists(frame_folder(path)))
    throw file_error(frame_folder(path) + " exists", "nothing is overwritten unless asked",
                     "remove it, choose another name with -o, or give --force");
}

void export_vtp(const RunFile& run, const std::string& path, Existing existing, Cells cells) {
  check_frames(run);
  check_cells(cells, run.dimensions());
  check_can_export_vtp(path, existing);
  const std::string folder = frame_folder(path);
  if (existing == Existing::replace) remove_numbered_files(folder, "frame");
  make_folder(folder);
  const std::vector<PvdEntry> frames = run.dimensions() == 2 ? write_frames<2>(run, folder, existing, cells)
                                                             : write_frames<3>(run, folder, existing, cells);
  write_pvd(path, frames, existing);
}

}  // namespace supple
