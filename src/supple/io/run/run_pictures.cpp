#include "supple/io/run/run_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "supple/core/error.hpp"
#include "supple/core/nearest_name.hpp"
#include "supple/draw/canvas/canvas.hpp"
#include "supple/draw/canvas/superscript.hpp"
#include "supple/draw/canvas/ticks.hpp"
#include "supple/draw/page/snapshot.hpp"
#include "supple/draw/scene/colors_apart.hpp"
#include "supple/draw/scene/drawn_cell.hpp"
#include "supple/draw/scene/frame_scene.hpp"

namespace supple {

namespace {

constexpr const char* by_contact = "id";

void check_frame(const RunFile& run, std::int64_t k) {
  if (k < 0 || k >= run.frames())
    throw input_error(fmt::format("{} has no frame {}", run.path(), k),
                      fmt::format("it has {} frames", run.frames()));
}

void check_color(const RunFile& run, std::int64_t k, const std::string& color) {
  if (color.empty()) return;
  const std::vector<std::string> names = body_colors(run, k);
  if (std::find(names.begin(), names.end(), color) != names.end()) return;
  const auto near = nearest_name(color, names);
  throw input_error(fmt::format("{} has no colour '{}'", run.path(), color), "",
                    near ? fmt::format("did you mean '{}'?", *near) : "choose from " + join_names(names));
}

/// Time where it passes; else what the packing is.
std::string title_of(const RunFile& run, const Scene& scene) {
  if (const auto strain = scene.numbers.find("uniaxial_strain"); strain != scene.numbers.end())
    return fmt::format("strain {}\u00a0%", tick_label(100 * strain->second, 0.1));
  const CellNumbers cell = cell_numbers(scene);
  if (scene.time != 0 || !std::isfinite(cell.packing_fraction)) return "";  // time and strain
  std::string title = fmt::format("\u03c6 = {:.4f}", cell.packing_fraction);
  const std::string unit = run.unit_of_bodies("pressure");
  if (std::isfinite(cell.pressure))
    title += fmt::format(",  P = {}{}", short_number(cell.pressure), unit.empty() ? "" : "\u00a0" + unit);
  return title;
}

/// Frames of a run, and what all of its pictures share.
class RunScenes {
 public:
  RunScenes(const RunFile& run, const std::string& color)
      : run_(run), info_(run.info()), color_(color == by_contact ? "" : color) {
    if (run.resolved_case().contact.kind == "smooth") boundary_ = Boundary::smooth;
    if (color_.empty()) common_.color = colors_apart(std::vector{scene(0), scene(run.frames() - 1)});
  }

  Scene scene(std::int64_t k) const {
    Scene scene = scene_of(info_, run_.frame(k));
    scene.boundary = boundary_;
    // A heap stands on its floor without a lid; its right wall is taken away when the box widens.
    if (run_.experiment() == "slump")
      scene.walls = Walls{true, scene.box.length[flow] <= info_.box.length[flow], true, false};
    return scene;
  }

  /// Widens what all pictures share, so that pages, forces and colours fit this one.
  void fit(const Scene& scene) {
    common_.full_force = std::max(common_.full_force, strongest_force(scene));
    common_.strain_room = std::max(common_.strain_room, std::abs(drawn_strain(scene.box)));
    for (int d = 0; d < 2 && !scene.box.periodic[flow] && !scene.box.periodic[gradient]; ++d)
      common_.room[d] = std::max(common_.room[d], scene.box.length[d]);
    if (const auto scalar = scalar_of(scene))
      for (const double value : scalar->value)
        if (std::isfinite(value)) range_ = {std::min(range_.first, value), std::max(range_.second, value)};
  }

  void draw(const std::string& path, const Scene& scene) const {
    SnapshotOptions options = common_;
    options.title = title_of(run_, scene);
    options.scalar = scalar_of(scene);
    if (options.scalar && range_.first < range_.second) options.scalar->range = range_;
    draw_snapshot(path, scene, options);
  }

 private:
  std::optional<BodyScalar> scalar_of(const Scene& scene) const {
    const std::vector<double>* values = numbers_of_bodies(scene, color_);
    if (!values) return {};
    std::string label = color_;
    std::replace(label.begin(), label.end(), '_', ' ');
    return BodyScalar{label, run_.unit_of_bodies(color_), *values};
  }

  const RunFile& run_;
  RunInfo<2> info_;
  std::string color_;
  Boundary boundary_ = Boundary::rough;
  SnapshotOptions common_;
  std::pair<double, double> range_{std::numeric_limits<double>::infinity(),
                                   -std::numeric_limits<double>::infinity()};
};

}  // namespace

std::vector<std::string> body_colors(const RunFile& run, std::int64_t k) {
  check_frame(run, k);
  std::vector<std::string> names{by_contact};
  for (const auto& [name, values] : run.frame(k).body) names.push_back(name);
  return names;
}

void draw_frame(const std::string& path, const RunFile& run, std::int64_t k, const std::string& color) {
  check_frame(run, k);
  check_color(run, k, color);
  const RunScenes scenes(run, color);
  scenes.draw(path, scenes.scene(k));
}

std::int64_t frame_of_image(std::int64_t k, std::int64_t images, std::int64_t frames) {
  if (images == 1) return frames - 1;
  return std::llround(static_cast<double>(k) * static_cast<double>(frames - 1) /
                      static_cast<double>(images - 1));
}

std::int64_t draw_frames(const std::string& folder, const std::string& ending, const RunFile& run,
                         std::int64_t images, const std::string& color,
                         const std::function<void(std::int64_t, std::int64_t)>& progress) {
  picture_format("image." + ending);
  if (run.frames() < 1) throw input_error("cannot draw images", "the run has no frames", "set output.frames");
  check_color(run, 0, color);
  images = std::clamp<std::int64_t>(images, 1, run.frames());
  RunScenes scenes(run, color);
  for (std::int64_t k = 0; k < images; ++k) {
    scenes.fit(scenes.scene(frame_of_image(k, images, run.frames())));
    if (progress) progress(0, images);  // that hears of a stop, too
  }
  for (std::int64_t k = 0; k < images; ++k) {
    scenes.draw(fmt::format("{}/image{:07}.{}", folder, k, ending),
                scenes.scene(frame_of_image(k, images, run.frames())));
    if (progress) progress(k + 1, images);
  }
  return images;
}

}  // namespace supple
