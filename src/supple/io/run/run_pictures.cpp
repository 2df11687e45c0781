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
#include "supple/draw/solid/solid_snapshot.hpp"

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

/// What the packing is; empty where that is not known.
std::string packing_title(const RunFile& run, double packing_fraction, double pressure) {
  if (!std::isfinite(packing_fraction)) return "";
  std::string title = fmt::format("\u03c6 = {:.4f}", packing_fraction);
  const std::string unit = run.unit_of_bodies("pressure");
  if (std::isfinite(pressure))
    title += fmt::format(",  P = {}{}", short_number(pressure), unit.empty() ? "" : "\u00a0" + unit);
  return title;
}

constexpr const char* plate_experiment = "plate_compression";

/// Sites of a particle between plates that touch one of these.
template <int Dim>
std::vector<std::int32_t> touching_plates(const RunFile& run, const RunInfo<Dim>& info,
                                          const std::vector<Vec<Dim>>& position, double gap) {
  std::vector<std::int32_t> touching;
  if (run.experiment() != plate_experiment) return touching;
  for (std::size_t i = 0; i < position.size(); ++i) {
    const double height = position[i][Dim - 1];
    if (std::min(height, gap - height) < info.radius[i]) touching.push_back(static_cast<std::int32_t>(i));
  }
  return touching;
}

/// How far the plates have come together; empty where there are none.
std::string plates_title(const RunFile& run, const SystemNumbers& numbers) {
  const auto compression = numbers.find("uniaxial_strain");
  if (run.experiment() != plate_experiment || compression == numbers.end()) return "";
  return fmt::format("\u03b4/D = {}", short_number(compression->second));
}

/// Time where it passes; else what the packing is.
std::string title_of(const RunFile& run, const Scene& scene) {
  if (run.experiment() == plate_experiment) return plates_title(run, scene.numbers);
  if (const auto strain = scene.numbers.find("uniaxial_strain"); strain != scene.numbers.end())
    return fmt::format("strain {}\u00a0%", tick_label(100 * strain->second, 0.1));
  if (const auto x = scene.numbers.find("sliding_x"); x != scene.numbers.end())
    return fmt::format("x = {}\u00a0D,  \u03bc = {}", tick_label(x->second, 0.001),
                       tick_label(scene.numbers.at("friction"), 0.001));
  const CellNumbers cell = cell_numbers(scene);
  return scene.time != 0 ? "" : packing_title(run, cell.packing_fraction, cell.pressure);  // time and strain
}

/// Numbers of bodies as their colours.
BodyScalar as_colors(const RunFile& run, const std::string& name, const std::vector<double>& values) {
  std::string label = name;
  std::replace(label.begin(), label.end(), '_', ' ');
  return {label, run.unit_of_bodies(name), values};
}

/// Interval that holds all numbers that it was shown; infinite and backward before.
struct Span {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void add(const std::vector<double>& values) {
    for (const double value : values)
      if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
  }
  /// As the range of colours, if there is one.
  void give(std::optional<BodyScalar>& scalar) const {
    if (scalar && low < high) scalar->range = {low, high};
  }
};

/// Frames of a run, and what all of its pictures share.
class RunScenes {
 public:
  RunScenes(const RunFile& run, const PictureChoice& choice)
      : run_(run), info_(run.info()), color_(choice.color == by_contact ? "" : choice.color) {
    if (!choice.view.empty())
      throw input_error("a view of " + run.path(), "it is a run in two dimensions", "leave the view away");
    if (choice.edges == TriangleEdges::drawn)
      throw input_error("edges of triangles of " + run.path(), "it is a run in two dimensions",
                        "leave them away");
    if (run.resolved_case().contact.kind == "smooth") boundary_ = Boundary::smooth;
    if (color_.empty()) common_.color = colors_apart(std::vector{scene(0), scene(run.frames() - 1)});
  }

  Scene scene(std::int64_t k) const {
    Scene scene = scene_of(info_, run_.frame(k));
    scene.boundary = boundary_;
    // A heap stands on its floor without a lid; its right wall is taken away when the box widens.
    if (run_.experiment() == "friction") scene.walls = Walls{};  // springs hold the pair, in the open
    if (run_.experiment() == "slump")
      scene.walls = Walls{true, scene.box.length[flow] <= info_.box.length[flow], true, false};
    if (run_.experiment() == plate_experiment) scene.walls = Walls{false, false, true, true};
    return scene;
  }

  /// Widens what all pictures share, so that pages, forces and colours fit this one.
  void fit(const Scene& scene) {
    common_.full_force = std::max(common_.full_force, strongest_force(scene));
    common_.strain_room = std::max(common_.strain_room, std::abs(drawn_strain(scene.box)));
    for (int d = 0; d < 2 && !scene.box.periodic[flow] && !scene.box.periodic[gradient]; ++d)
      common_.room[d] = std::max(common_.room[d], scene.box.length[d]);
    if (const auto scalar = scalar_of(scene)) span_.add(scalar->value);
  }

  void draw(const std::string& path, const Scene& scene) const {
    SnapshotOptions options = common_;
    options.title = title_of(run_, scene);
    options.scalar = scalar_of(scene);
    span_.give(options.scalar);
    options.marked = touching_plates<2>(run_, info_, scene.position, scene.box.length[gradient]);
    draw_snapshot(path, scene, options);
  }

 private:
  std::optional<BodyScalar> scalar_of(const Scene& scene) const {
    const std::vector<double>* values = numbers_of_bodies(scene, color_);
    if (!values) return {};
    return as_colors(run_, color_, *values);
  }

  const RunFile& run_;
  RunInfo<2> info_;
  std::string color_;
  Boundary boundary_ = Boundary::rough;
  SnapshotOptions common_;
  Span span_;
};

/// A frame in 3D, and the particles in it as pictures take them.
struct Solid {
  Frame<3> frame;
  SolidScene scene;
};

/// The same of a run in 3D.
class RunSolids {
 public:
  RunSolids(const RunFile& run, const PictureChoice& choice)
      : run_(run),
        info_(run.info<3>()),
        topology_(topology_of(info_)),
        color_(choice.color == by_contact ? "" : choice.color) {
    if (!choice.view.empty()) common_.view = view_of(choice.view);
    common_.edges = choice.edges;
    if (color_.empty())
      common_.color = colors_apart(std::vector{scene(0).scene, scene(run.frames() - 1).scene});
  }

  Solid scene(std::int64_t k) const {
    Solid solid{run_.frame<3>(k), {}};
    Box<3> box = info_.box;
    box.length = solid.frame.length;
    box.strain = solid.frame.strain;
    solid.scene = solid_scene_of(box, topology_, solid.frame.position, info_.radius);
    solid.scene.units = info_.units;
    solid.scene.time = solid.frame.time;
    return solid;
  }

  void fit(const Solid& solid) {
    const Bounds extent = extent_of(solid.scene, common_.view);
    if (!common_.room) common_.room = extent;
    for (int d = 0; d < 2; ++d) {
      common_.room->low[d] = std::min(common_.room->low[d], extent.low[d]);
      common_.room->high[d] = std::max(common_.room->high[d], extent.high[d]);
    }
    for (const double length : solid.scene.box.length.e)
      common_.scale_length = std::max(common_.scale_length, length);
    if (const auto scalar = scalar_of(solid)) span_.add(scalar->value);
  }

  void draw(const std::string& path, const Solid& solid) const {
    SolidSnapshotOptions options = common_;
    const auto number = [&](const char* name) {
      const auto at = solid.frame.numbers.find(name);
      return at == solid.frame.numbers.end() ? std::nan("") : at->second;
    };
    if (solid.frame.time == 0)
      options.title = packing_title(run_, number("packing_fraction"), number("pressure"));
    options.scalar = scalar_of(solid);
    if (options.title.empty()) options.title = plates_title(run_, solid.frame.numbers);
    span_.give(options.scalar);
    const std::vector<std::int32_t> marked =
        touching_plates<3>(run_, info_, solid.frame.position, solid.frame.length[2]);
    if (marked.empty() || options.color.empty()) return draw_solid_snapshot(path, solid.scene, options);
    draw_solid_snapshot(path, with_marks(solid, marked), with_color_of_marks(options));
  }

 private:
  /// The same with a sphere on each marked site, wider than the site, which its surface hides.
  SolidScene with_marks(const Solid& solid, const std::vector<std::int32_t>& marked) const {
    SolidScene scene = solid.scene;
    const auto body = static_cast<std::int32_t>(scene.particle.size());
    scene.particle.push_back(scene.particles++);
    for (const std::int32_t i : marked)
      scene.sphere.push_back({solid.frame.position[i], 1.2 * info_.radius[i], body});
    return scene;
  }
  static SolidSnapshotOptions with_color_of_marks(SolidSnapshotOptions options) {
    options.color.push_back(mark_color);
    return options;
  }

  std::optional<BodyScalar> scalar_of(const Solid& solid) const {
    const auto values = solid.frame.body.find(color_);
    if (values == solid.frame.body.end()) return {};
    return as_colors(run_, color_, values->second);
  }

  const RunFile& run_;
  RunInfo<3> info_;
  Topology<3> topology_;
  std::string color_;
  SolidSnapshotOptions common_;
  Span span_;
};

/// Calls `work` with the scenes of the run, whatever its dimensions.
template <class Work>
void with_scenes(const RunFile& run, const PictureChoice& choice, Work&& work) {
  if (run.dimensions() == 2) {
    RunScenes scenes(run, choice);
    work(scenes);
  } else {
    RunSolids scenes(run, choice);
    work(scenes);
  }
}

}  // namespace

std::vector<std::string> body_colors(const RunFile& run, std::int64_t k) {
  check_frame(run, k);
  std::vector<std::string> names{by_contact};
  const BodyNumbers numbers = run.dimensions() == 2 ? run.frame(k).body : run.frame<3>(k).body;
  for (const auto& [name, values] : numbers) names.push_back(name);
  return names;
}

void draw_frame(const std::string& path, const RunFile& run, std::int64_t k, const PictureChoice& choice) {
  check_frame(run, k);
  check_color(run, k, choice.color);
  with_scenes(run, choice, [&](const auto& scenes) { scenes.draw(path, scenes.scene(k)); });
}

std::int64_t frame_of_image(std::int64_t k, std::int64_t images, std::int64_t frames) {
  if (images == 1) return frames - 1;
  return std::llround(static_cast<double>(k) * static_cast<double>(frames - 1) /
                      static_cast<double>(images - 1));
}

std::int64_t draw_frames(const std::string& folder, const std::string& ending, const RunFile& run,
                         std::int64_t images, const PictureChoice& choice,
                         const std::function<void(std::int64_t, std::int64_t)>& progress) {
  picture_format("image." + ending);
  if (run.frames() < 1) throw input_error("cannot draw images", "the run has no frames", "set output.frames");
  check_color(run, 0, choice.color);
  images = std::clamp<std::int64_t>(images, 1, run.frames());
  with_scenes(run, choice, [&](auto& scenes) {
    for (std::int64_t k = 0; k < images; ++k) {
      scenes.fit(scenes.scene(frame_of_image(k, images, run.frames())));
      if (progress) progress(0, images);  // that hears of a stop, too
    }
    for (std::int64_t k = 0; k < images; ++k) {
      scenes.draw(fmt::format("{}/image{:07}.{}", folder, k, ending),
                  scenes.scene(frame_of_image(k, images, run.frames())));
      if (progress) progress(k + 1, images);
    }
  });
  return images;
}

}  // namespace supple
