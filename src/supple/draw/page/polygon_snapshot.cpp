#include "supple/draw/page/polygon_snapshot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "supple/core/error.hpp"
#include "supple/draw/canvas/color_scale.hpp"
#include "supple/draw/canvas/superscript.hpp"
#include "supple/draw/canvas/ticks.hpp"
#include "supple/draw/page/cell_page.hpp"
#include "supple/draw/scene/contact_style.hpp"
#include "supple/draw/scene/particle_colors.hpp"
#include "supple/draw/scene/polygon_layout.hpp"
#include "supple/draw/scene/polygon_outline.hpp"

namespace supple {

namespace {

constexpr Color wall_color = hex(0x999999);
constexpr double arc_step = 0.8;  // [pt]

/// The length or force in its unit, or as it is.
std::string shown(double value, const std::string& unit) {
  return unit.empty() ? short_number(value) : with_unit(value, unit, Digits::fewest);
}

/// Bodies that touch differ.
std::vector<Color> colors_by_contact(const PolygonScene& scene) {
  const std::vector<std::int32_t> body = body_of_sites(scene);
  std::vector<std::set<std::int32_t>> touching(scene.bodies());
  for (const SceneContact& c : scene.contacts) {
    touching[body[c.first]].insert(body[c.second]);
    touching[body[c.second]].insert(body[c.first]);
  }
  return neighbour_colors(touching, std::vector<bool>(scene.bodies(), true));
}

class PolygonPage {
 public:
  PolygonPage(const std::string& path, const PolygonScene& scene, const PolygonSnapshotOptions& options)
      : scene_(scene),
        options_(options),
        page_(path, scene.box, options.cell_size, options.strain_room, options.dots_per_inch, options.room),
        canvas_(page_.canvas()),
        bodies_(lay_out_bodies(scene, page_.rim() / page_.scale())),
        contacts_(lay_out_contacts(scene, page_.rim() / page_.scale())) {
    const std::size_t n = scene.radius.size();
    const double mean = n == 0 ? 0 : std::accumulate(scene.radius.begin(), scene.radius.end(), 0.0) / n;
    outline_ = std::clamp(std::min(0.03 * std::sqrt(body_area()), 0.15 * mean) * page_.scale(), 0.15, 0.9);
    widest_ = std::clamp(0.55 * mean * page_.scale(), 0.8, 4.5);
    full_force_ = options.full_force > 0 ? options.full_force : strongest_force(scene);
    choose_colors();
    for (std::int32_t b = 0; b < scene.bodies(); ++b) {
      const auto [first, last] = scene.body(b);
      const auto length = static_cast<std::size_t>(last - first);
      pieces_.push_back(body_outline(std::span(scene.position).subspan(first, length),
                                     std::span(scene.radius).subspan(first, length),
                                     arc_step / page_.scale()));
    }
  }

  void draw() {
    draw_walls();
    page_.draw_matter([&](double whiteness, Lies skipped) { draw_matter(whiteness, skipped); },
                      Beyond::shown);
    draw_cell_edge();
    page_.draw_title(title());
    const double bar = round_below(0.25 * scene_.box.length[flow]);
    page_.draw_scale_bar(bar, shown(bar, options_.length_unit));
    draw_legend();
    canvas_.finish();
  }

 private:
  /// Mean share of the cell, as an order of magnitude.
  double body_area() const { return scene_.box.volume() / std::max(scene_.bodies(), 1); }

  void choose_colors() {
    if (!options_.color) {
      color_ = colors_by_contact(scene_);
      return;
    }
    const BodyScalar& scalar = *options_.color;
    scale_ = scale_over(scalar.value);
    if (scalar.range) scale_ = {scalar.range->first, scalar.range->second};
    for (const double value : scalar.value) color_.push_back(scale_.color(value));
  }

  std::vector<Point> on_page(const std::vector<Vec2>& points, const Vec2& shift) const {
    std::vector<Point> out;
    for (const Vec2& x : points) out.push_back(page_.on_page(x + shift));
    return out;
  }
  std::vector<Point> ring_on_page(const DrawnBody& image) const {
    const auto [first, last] = scene_.body(image.body);
    return on_page({scene_.position.begin() + first, scene_.position.begin() + last}, image.shift);
  }

  /// Bodies and contacts, faded to this share of white, but for those that lie where nothing shows.
  void draw_matter(double whiteness, Lies skipped) {
    const auto shade = [&](Color c) { return mix(c, white, whiteness); };
    for (const DrawnBody& image : bodies_)
      if (image.lies != skipped) fill(image, shade(color_[image.body]), shade(ink));
    for (const DrawnBody& image : bodies_) {
      if (image.lies == skipped || is_smooth(image.body)) continue;
      for (const std::vector<Vec2>& piece : pieces_[image.body])
        canvas_.polyline(on_page(piece, image.shift), {shade(ink), outline_});
    }
    for (const ContactStyle& style : contact_styles)
      for (const ContactImage& line : contacts_)
        if (line.lies != skipped && scene_.contacts[line.contact].state == style.state)
          draw_contact(line, shade(white), shade(style.color));
  }

  bool is_smooth(std::int32_t body) const {
    const auto [first, last] = scene_.body(body);
    return options_.boundary == Boundary::smooth && last - first > 1;
  }

  /// The polygon, the discs on its vertices and, thinly, the ring through them.
  void fill(const DrawnBody& image, Color color, Color rim) {
    const std::vector<Point> ring = ring_on_page(image);
    const std::int32_t first = scene_.body(image.body).first;
    if (is_smooth(image.body)) {  // lines with round corners cover all within the radius of the polygon
      const double width = 2 * scene_.radius[first] * page_.scale();
      canvas_.polygon(ring, {{}, Pen{rim, width + outline_}});
      canvas_.polygon(ring, {color, Pen{color, std::max(width - outline_, 0.0)}});
      return;
    }
    if (ring.size() > 2) canvas_.polygon(ring, {color, {}});
    for (std::size_t k = 0; k < ring.size(); ++k)
      canvas_.circle(ring[k], scene_.radius[first + static_cast<std::int32_t>(k)] * page_.scale(),
                     {color, {}});
    if (ring.size() > 2) canvas_.polygon(ring, {{}, Pen{mix(color, black, 0.22), 0.6 * outline_}});
  }

  double force_width(double force) const {
    const double share = full_force_ > 0 ? std::min(force / full_force_, 1.2) : 0;
    return std::max(share, 0.15) * widest_;
  }
  Pen contact_pen(Color color, double force, bool tension) const {
    Pen pen{color, force_width(force)};
    if (tension) pen.dash = {std::max(1.5, 1.2 * pen.width), std::max(1.5, 1.2 * pen.width)};
    return pen;
  }
  void draw_contact(const ContactImage& line, Color halo, Color color) {
    const SceneContact& contact = scene_.contacts[line.contact];
    const Point from = page_.on_page(line.from), to = page_.on_page(line.to);
    canvas_.line(from, to, {halo, force_width(contact.force) + 1.2 * outline_});
    canvas_.line(from, to, contact_pen(color, contact.force, contact.tension));
  }

  Walls walls() const {
    const bool sides = !scene_.box.periodic[flow], ends = !scene_.box.periodic[gradient];
    return options_.walls.value_or(Walls{sides, sides, ends, ends});
  }
  void draw_walls() {
    const Walls solid = walls();
    const double band = 0.5 * page_.rim();
    const double left = solid.left ? band : 0, right = solid.right ? band : 0;
    const double top = solid.top ? band : 0, bottom = solid.bottom ? band : 0;
    const Point low{page_.corner()[3][0], page_.corner()[2][1]}, high = page_.corner()[1];  // y downward
    const auto wall = [&](bool wanted, Point a, Point b) {
      if (wanted) canvas_.rectangle(a, b, {wall_color, {}});
    };
    wall(solid.left, {low[0] - band, low[1] - top}, {low[0], high[1] + bottom});
    wall(solid.right, {high[0], low[1] - top}, {high[0] + band, high[1] + bottom});
    wall(solid.bottom, {low[0] - left, high[1]}, {high[0] + right, high[1] + band});
    wall(solid.top, {low[0] - left, low[1] - band}, {high[0] + right, low[1]});
  }

  /// Open sides, neither periodic nor solid, are dotted.
  void draw_cell_edge() {
    const Walls solid = walls();
    const std::array<Point, 4>& corner = page_.corner();
    const auto side = [&](int k, int direction, bool is_wall) {
      const Pen line{ink, 0.8}, open{gray, 0.6, {2, 3}};
      canvas_.line(corner[k], corner[(k + 1) % 4], scene_.box.periodic[direction] || is_wall ? line : open);
    };
    side(0, gradient, solid.bottom);
    side(1, flow, solid.right);
    side(2, gradient, solid.top);
    side(3, flow, solid.left);
  }

  std::string title() const {
    if (!options_.title.empty()) return options_.title;
    std::string text;
    if (scene_.time != 0) text += fmt::format("t = {:.4g}     ", scene_.time);
    const double strain = scene_.box.strain, drawn = drawn_strain(scene_.box);
    if (strain != 0) text += fmt::format("\u03b3 = {}\u00a0%", tick_label(100 * strain, 0.1));
    if (std::abs(drawn - strain) > 1e-9)
      text += fmt::format("     (drawn at the equivalent {}\u00a0%)", tick_label(100 * drawn, 0.1));
    return text;
  }

  void draw_legend() {
    const double x = page_.legend_left();
    double y = page_.top();
    if (options_.color) {
      const double height = std::clamp(0.45 * scene_.box.length[gradient] * page_.scale(), 80.0, 160.0);
      y = draw_color_bar(canvas_, {x, y}, height, scale_, options_.color->label, options_.color->unit) + 24;
    } else {
      y += 6;
    }
    const double most = full_force_ > 0 ? round_below(full_force_) : 0;
    if (most <= 0) return;
    const auto row = [&](const std::string& name, const Pen& pen) {
      y += CellPage::legend_row;
      canvas_.line({x, y}, {x + CellPage::legend_sample, y}, pen);
      canvas_.text({x + CellPage::legend_sample + 5, y}, name, {.size = 8, .down = Down::middle});
    };
    const auto is_drawn = [&](ContactState state, bool tension) {
      return std::any_of(scene_.contacts.begin(), scene_.contacts.end(),
                         [&](const SceneContact& c) { return c.state == state && c.tension == tension; });
    };
    const bool differ = std::any_of(scene_.contacts.begin(), scene_.contacts.end(),
                                    [](const SceneContact& c) { return c.state != ContactState::slip; });
    Color color = contact_styles.back().color;
    if (differ) {  // without friction all contacts slip: nothing to tell apart
      y -= CellPage::legend_row;
      for (const ContactStyle& style : contact_styles)
        for (const bool tension : {false, true})
          if (is_drawn(style.state, tension))
            row(std::string(style.name) + (tension ? ", tension" : ""),
                contact_pen(style.color, 0.5 * most, tension));
      y += 1.3 * CellPage::legend_row;
      color = gray;
    }
    canvas_.text({x, y}, differ ? "line width: force" : "contacts, width: force",
                 {.size = 8, .down = Down::middle});
    for (const double force : {most, 0.5 * most})
      row(shown(force, options_.force_unit), {color, force_width(force)});
  }

  const PolygonScene& scene_;
  const PolygonSnapshotOptions& options_;
  CellPage page_;
  Canvas& canvas_;
  std::vector<DrawnBody> bodies_;
  std::vector<ContactImage> contacts_;
  std::vector<std::vector<std::vector<Vec2>>> pieces_;  // of the outline of each body, at its positions
  std::vector<Color> color_;
  ColorScale scale_;
  double outline_, widest_, full_force_;
};

}  // namespace

double strongest_force(const PolygonScene& scene) {
  std::vector<double> force;
  for (const SceneContact& c : scene.contacts) force.push_back(c.force);
  if (force.empty()) return 0;
  const auto at = force.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(force.size() - 1));
  std::nth_element(force.begin(), at, force.end());
  return *at;
}

void draw_polygon_snapshot(const std::string& path, const PolygonScene& scene,
                           const PolygonSnapshotOptions& options) {
  check_scene(scene, path);
  if (options.color && options.color->value.size() != static_cast<std::size_t>(scene.bodies()))
    throw input_error("cannot draw '" + path + "'",
                      fmt::format("{} numbers for {} bodies", options.color->value.size(), scene.bodies()));
  if (options.color && options.color->range && !(options.color->range->first < options.color->range->second))
    throw input_error("cannot draw '" + path + "'", "the range of its colours is empty");
  PolygonPage(path, scene, options).draw();
}

}  // namespace supple
