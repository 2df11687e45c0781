#include "supple/io/run/body_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "supple/core/error.hpp"
#include "supple/core/nearest_name.hpp"
#include "supple/draw/canvas/canvas.hpp"
#include "supple/draw/canvas/superscript.hpp"
#include "supple/draw/canvas/ticks.hpp"
#include "supple/draw/scene/drawn_cell.hpp"
#include "supple/draw/scene/run_scene.hpp"
#include "supple/io/run/images.hpp"

namespace supple {

namespace {

constexpr const char* by_contact = "id";

void check_frame(const RunFile& run, std::int64_t k) {
  if (k < 0 || k >= run.frames())
    throw input_error(fmt::format("{} has no frame {}", run.path(), k),
                      fmt::format("it has {} frames", run.frames()));
}

/// Unit of the number of bodies, from the table that has one of the same name for the cell.
std::string unit_of(const RunFile& run, const std::string& name) {
  for (const std::string& table : run.tables())
    for (const Column& column : run.columns(table))
      if (column.name == name) return column.unit;
  return "";
}

std::optional<BodyScalar> scalar(const RunFile& run, const PolygonScene& scene, const std::string& color) {
  if (color.empty() || color == by_contact) return {};
  for (const SceneArray& array : scene.of_bodies) {
    const auto* values = std::get_if<std::vector<double>>(&array.values);
    if (!values || array.name != color) continue;
    std::string label = color;
    std::replace(label.begin(), label.end(), '_', ' ');
    return BodyScalar{label, unit_of(run, color), *values};
  }
  return {};
}

void check_color(const RunFile& run, std::int64_t k, const std::string& color) {
  if (color.empty()) return;
  const std::vector<std::string> names = body_colors(run, k);
  if (std::find(names.begin(), names.end(), color) != names.end()) return;
  const auto near = nearest_name(color, names);
  throw input_error(fmt::format("{} has no colour '{}'", run.path(), color), "",
                    near ? fmt::format("did you mean '{}'?", *near) : "choose from " + join_names(names));
}

/// A heap stands on its floor without a lid; its right wall is taken away when the box widens.
std::optional<Walls> walls_of(const RunFile& run, const RunInfo& info, const PolygonScene& scene) {
  if (run.experiment() != "slump") return {};
  return Walls{true, scene.box.length[flow] <= info.box.length[flow], true, false};
}

/// Time where it passes; else what the packing is.
std::string title_of(const RunFile& run, const PolygonScene& scene) {
  if (run.experiment() == "uniaxial_compression")
    return fmt::format("strain {}\u00a0%", tick_label(100 * scene.time, 0.1));
  const bool moves = run.experiment() == "slump" || run.experiment() == "dynamics";
  if (moves && scene.time != 0) return fmt::format("t = {}", short_number(scene.time));
  const CellNumbers cell = cell_numbers(scene);
  if (!std::isfinite(cell.packing_fraction)) return "";
  std::string title = fmt::format("\u03c6 = {:.4f}", cell.packing_fraction);
  const std::string unit = unit_of(run, "pressure");
  if (std::isfinite(cell.pressure))
    title += fmt::format(",  P = {}{}", short_number(cell.pressure), unit.empty() ? "" : "\u00a0" + unit);
  return title;
}

PolygonSnapshotOptions options_for(const RunFile& run, const RunInfo& info, const PolygonScene& scene,
                                   const std::string& color) {
  PolygonSnapshotOptions options;
  options.color = scalar(run, scene, color);
  options.walls = walls_of(run, info, scene);
  if (run.resolved_case().contact.kind == "smooth") options.boundary = Boundary::smooth;
  options.title = title_of(run, scene);
  return options;
}

/// What all images of a run share.
struct Shared {
  double full_force = 0, strain_room = 0;
  Vec2 room{};
  std::pair<double, double> colors{std::numeric_limits<double>::infinity(),
                                   -std::numeric_limits<double>::infinity()};

  void take(const PolygonScene& scene, const std::optional<BodyScalar>& color) {
    full_force = std::max(full_force, strongest_force(scene));
    strain_room = std::max(strain_room, std::abs(drawn_strain(scene.box)));
    if (!scene.box.periodic[flow] && !scene.box.periodic[gradient])
      for (int d = 0; d < 2; ++d) room[d] = std::max(room[d], scene.box.length[d]);
    if (!color) return;
    for (const double value : color->value)
      if (std::isfinite(value)) colors = {std::min(colors.first, value), std::max(colors.second, value)};
  }
  void give(PolygonSnapshotOptions& options) const {
    options.full_force = full_force;
    options.strain_room = strain_room;
    options.room = room;
    if (options.color && colors.first < colors.second) options.color->range = colors;
  }
};

}  // namespace

std::vector<std::string> body_colors(const RunFile& run, std::int64_t k) {
  check_frame(run, k);
  std::vector<std::string> names{by_contact};
  for (const auto& [name, values] : run.frame(k).body) names.push_back(name);
  return names;
}

void draw_body_snapshot(const std::string& path, const RunFile& run, std::int64_t k,
                        const std::string& color) {
  check_frame(run, k);
  check_color(run, k, color);
  const RunInfo info = run.info();
  const PolygonScene scene = scene_of(info, run.frame(k));
  draw_polygon_snapshot(path, scene, options_for(run, info, scene, color));
}

std::int64_t draw_body_images(const std::string& folder, const std::string& ending, const RunFile& run,
                              std::int64_t images, const std::string& color,
                              const std::function<void(std::int64_t, std::int64_t)>& progress) {
  picture_format("image." + ending);
  if (run.frames() < 1) throw input_error("cannot draw images", "the run has no frames", "set output.frames");
  check_color(run, 0, color);
  images = std::clamp<std::int64_t>(images, 1, run.frames());
  const RunInfo info = run.info();
  const auto scene_of_image = [&](std::int64_t k) {
    return scene_of(info, run.frame(frame_of_image(k, images, run.frames())));
  };
  Shared shared;
  for (std::int64_t k = 0; k < images; ++k) {
    const PolygonScene scene = scene_of_image(k);
    shared.take(scene, scalar(run, scene, color));
  }
  for (std::int64_t k = 0; k < images; ++k) {
    const PolygonScene scene = scene_of_image(k);
    PolygonSnapshotOptions options = options_for(run, info, scene, color);
    shared.give(options);
    draw_polygon_snapshot(fmt::format("{}/image{:07}.{}", folder, k, ending), scene, options);
    if (progress) progress(k + 1, images);
  }
  return images;
}

}  // namespace supple
