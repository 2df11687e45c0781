#include "supple/io/trajectory.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <vector>

#include "supple/core/error.hpp"
#include "supple/io/run_scene.hpp"
#include "supple/io/vtp.hpp"
#include "supple/io/xyz.hpp"

namespace supple {

namespace {

namespace fs = std::filesystem;

void check_frames(const RunFile& run) {
  if (run.frames() == 0) throw input_error(run.path() + " holds no frames", "it stopped before its first step");
}

bool ascend(const std::vector<PvdEntry>& frames) {
  for (std::size_t k = 1; k < frames.size(); ++k)
    if (!(frames[k].first > frames[k - 1].first)) return false;
  return true;
}

}  // namespace

void export_xyz(const RunFile& run, const std::string& path, Existing existing) {
  check_frames(run);
  const RunInfo info = run.info();
  XyzFile file(path, existing);
  for (std::int64_t k = 0; k < run.frames(); ++k) file.append(scene_of(info, run.frame(k)));
  file.commit();
}

std::string frame_folder(const std::string& path) { return fs::path(path).replace_extension().string() + "_frames"; }

void check_can_export_vtp(const std::string& path, Existing existing) {
  check_can_create(path, existing);
  if (existing == Existing::refuse && fs::exists(frame_folder(path)))
    throw file_error(frame_folder(path) + " exists", "nothing is overwritten unless asked",
                     "remove it, choose another name with -o, or give --force");
}

void export_vtp(const RunFile& run, const std::string& path, Existing existing) {
  check_frames(run);
  check_can_export_vtp(path, existing);
  const std::string folder = frame_folder(path);
  fs::create_directories(folder);
  const RunInfo info = run.info();
  std::vector<PvdEntry> frames;
  for (std::int64_t k = 0; k < run.frames(); ++k) {
    const PolygonScene scene = scene_of(info, run.frame(k));
    const std::string name = fmt::format("frame{:07}.vtp", k);
    write_vtp(folder + "/" + name, scene, existing);
    frames.emplace_back(scene.time, fs::path(folder).filename().string() + "/" + name);
  }
  if (!ascend(frames))
    for (std::size_t k = 0; k < frames.size(); ++k) frames[k].first = static_cast<double>(k);
  write_pvd(path, frames, existing);
}

}  // namespace supple
