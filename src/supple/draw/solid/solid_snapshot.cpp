#include "supple/draw/solid/solid_snapshot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "supple/core/error.hpp"
#include "supple/draw/page/cell_page.hpp"
#include "supple/draw/page/legend.hpp"
#include "supple/draw/scene/drawn_cell.hpp"
#include "supple/draw/solid/cell_planes.hpp"
#include "supple/draw/solid/hidden_lines.hpp"

namespace supple {

namespace {

constexpr double least_height = 190;                  // that the legend needs [pt]
constexpr double rim = 2;                             // around what is drawn, for the width of its lines [pt]
constexpr double outline = 0.5, triangle_edge = 0.3;  // widths [pt]
constexpr double arm = 20;                            // of the directions [pt]

double longest_side(const Box<3>& box) { return std::ranges::max(box.length.e); }

class SolidPage : PageMargins {
 public:
  SolidPage(const std::string& path, const SolidScene& scene, const SolidSnapshotOptions& options)
      : scene_(scene),
        options_(options),
        axes_(axes_of(options.view)),
        middle_(axes_.of(scene.box.centre())),
        scale_(options.cell_size /
               (options.scale_length > 0 ? options.scale_length : longest_side(scene.box))),
        dots_(is_pixels(path) ? options.dots_per_inch : options.image_dots_per_inch),
        shown_(room_for(scene, options).grown(rim / scale_)),
        size_(scale_ * (shown_.high - shown_.low)),
        canvas_(path, 2 * edge + size_[0] + legend_width,
                title_height + std::max(size_[1], least_height) + foot_height, options.dots_per_inch) {}

  void draw() {
    choose_colors();
    draw_particles();
    if (options_.cell == CellFrame::drawn) draw_cell();
    canvas_.text({edge, title_height - 3}, title(), {.size = 11});
    const double foot = title_height + std::max(size_[1], least_height) + 5;
    draw_scale_bar(canvas_, {edge, foot}, scale_, 0.25 * longest_side(scene_.box), scene_.units);
    draw_directions({legend_left() + 30, foot - 30});
    if (options_.scalar)
      Legend(canvas_, legend_left(), title_height)
          .color_bar(*options_.scalar, scale_of(*options_.scalar), std::clamp(0.45 * size_[1], 80.0, 160.0));
    canvas_.finish();
  }

 private:
  static bool is_pixels(const std::string& path) {
    const PictureFormat format = picture_format(path);
    return format == PictureFormat::png || format == PictureFormat::jpg;
  }
  static Bounds room_for(const SolidScene& scene, const SolidSnapshotOptions& options) {
    Bounds shown = extent_of(scene, options.view);
    if (options.room) shown.include(*options.room);
    return shown;
  }

  double legend_left() const { return canvas_.width() - legend_width + 2; }
  /// The upper left corner of the image, where pixels of the page begin.
  Point corner() const {
    const auto whole = [&](double points) { return std::round(points * dots_ / 72) * 72 / dots_; };
    return {whole(edge), whole(title_height)};
  }
  Point on_page(const Vec3& x) const {
    const Vec3 at = axes_.of(x) - middle_;
    return corner() + scale_ * Vec2{at[0] - shown_.low[0], shown_.high[1] - at[1]};
  }

  /// In pixels of the image.
  Vec2 pixel_of(const Vec3& x) const { return (dots_ / 72) * (on_page(x) - corner()); }

  void choose_colors() {
    color_ = options_.color;
    if (options_.scalar) {
      const ColorScale scale = scale_of(*options_.scalar);
      color_.clear();
      for (const double v : options_.scalar->value) color_.push_back(scale.color(v));
    } else if (color_.empty()) {
      color_ = colors_apart(std::span(&scene_, 1));
    }
  }

  void draw_particles() {
    const double per_point = dots_ / 72;
    const auto pixels = [&](double points) { return static_cast<int>(std::ceil(points * per_point)); };
    const SolidWindow window{axes_,
                             middle_[0] + shown_.low[0],
                             middle_[1] + shown_.high[1],
                             scale_ * per_point,
                             pixels(size_[0]),
                             pixels(size_[1])};
    const double edges = options_.edges == TriangleEdges::drawn ? triangle_edge : 0;
    image_ = draw_solid(scene_, color_, window, {options_.shading, edges * per_point, outline * per_point});
    canvas_.image(corner(), image_.rows(), dots_);
  }

  /// The edge of the cell from corner k along direction d: where particles are cut it has them all behind it
  /// or all in front.
  std::vector<std::pair<double, double>> shown_parts(const Vec3& a, const Vec3& b, bool is_behind) const {
    if (scene_.images == Images::whole) return visible_parts(scene_, axes_, a, b);
    return is_behind ? uncovered_parts(image_, pixel_of(a), pixel_of(b))
                     : std::vector<std::pair<double, double>>{{0, 1}};
  }

  /// Edges between sides that are not periodic are dotted.
  void draw_cell() {
    const std::array<Vec3, 8> at = cell_corners(scene_.box);
    const std::vector<CellPlane> planes = cell_planes(scene_.box);
    const Pen line{ink, 0.8}, open{gray, 0.6, {2, 3}};
    for (int d = 0; d < 3; ++d)
      for (int k = 0; k < 8; ++k) {
        if (k >> d & 1) continue;
        const Vec3 &a = at[k], &b = at[k | 1 << d];
        const int e = (d + 1) % 3, f = (d + 2) % 3;
        const auto is_away = [&](int side) {
          return dot(planes[2 * side + (k >> side & 1)].normal, axes_.towards) < -1e-9;
        };
        const bool is_open = !scene_.box.periodic[e] && !scene_.box.periodic[f];
        for (const auto& [from, to] : shown_parts(a, b, is_away(e) && is_away(f)))
          canvas_.line(on_page(a + from * (b - a)), on_page(a + to * (b - a)), is_open ? open : line);
      }
  }

  /// Where x, y and z point, the farthest first.
  void draw_directions(Point origin) {
    std::array<int, 3> order{0, 1, 2};
    std::ranges::stable_sort(order, {}, [&](int d) { return axes_.towards[d]; });
    for (const int d : order) {
      const Vec2 way{axes_.right[d], -axes_.up[d]};
      const TextStyle style{.size = 8, .across = Across::centre, .down = Down::middle};
      const double length = norm(way);
      if (length < 0.05) {  // at the viewer, or away
        canvas_.circle(origin, 1.6, {axes_.towards[d] > 0 ? ink : white, Pen{ink, 0.8}});
        continue;
      }
      canvas_.line(origin, origin + arm * way, {ink, 0.8});
      canvas_.text(origin + (arm + 6 / length) * way, std::string(1, "xyz"[d]), style);
    }
  }

  std::string title() const {
    if (!options_.title.empty()) return options_.title;
    return instant_title(scene_.units, scene_.time, scene_.box.strain, drawn_strain(scene_.box),
                         scene_.box.periodic[flow]);
  }

  const SolidScene& scene_;
  const SolidSnapshotOptions& options_;
  ViewAxes axes_;
  Vec3 middle_;          // of the cell, along axes_ [length]
  double scale_, dots_;  // [pt/length], [1/inch]
  Bounds shown_;         // from middle_ [length]
  Vec2 size_;            // [pt]
  Canvas canvas_;
  std::vector<Color> color_;
  SolidImage image_;
};

void check_options(const std::string& path, const SolidScene& scene, const SolidSnapshotOptions& options) {
  const std::string what = "cannot draw '" + path + "'";
  const auto check = [&](double x, const char* name) {
    if (!(std::isfinite(x) && x > 0))
      throw input_error(what, fmt::format("{} is {}", name, x), "give more than 0");
  };
  check(options.cell_size, "the size of the cell on the page");
  check(options.dots_per_inch, "the number of pixels in an inch");
  check(options.image_dots_per_inch, "the number of pixels in an inch");
  if (options.scale_length != 0) check(options.scale_length, "the length that has this size");
  check_colors(path, static_cast<std::size_t>(scene.particles), options.scalar, options.color);
}

}  // namespace

Bounds extent_of(const SolidScene& scene, const View& view) {
  const ViewAxes axes = axes_of(view);
  const Vec3 middle = axes.of(scene.box.centre());
  const auto place = [&](const Vec3& x) {
    const Vec3 at = axes.of(x) - middle;
    return Vec2{at[0], at[1]};
  };
  Bounds extent{};
  for (const Vec3& x : cell_corners(scene.box)) extent.include(place(x));
  if (scene.images == Images::cut && std::ranges::count(scene.box.periodic, false) == 0) return extent;
  for (const SolidTriangle& t : scene.triangle)
    for (const std::int32_t v : t.vertex) extent.include(place(scene.vertex[v]));
  for (const SolidSphere& s : scene.sphere)
    extent.include(Bounds{place(s.centre), place(s.centre)}.grown(s.radius));
  return extent;
}

void draw_solid_snapshot(const std::string& path, const SolidScene& scene,
                         const SolidSnapshotOptions& options) {
  picture_format(path);
  check_scene(scene, path);
  check_options(path, scene, options);
  SolidPage(path, scene, options).draw();
}

}  // namespace supple
