#include "supple/draw/page/snapshot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "supple/core/error.hpp"
#include "supple/draw/canvas/canvas.hpp"
#include "supple/draw/canvas/ticks.hpp"
#include "supple/draw/page/cell_page.hpp"
#include "supple/draw/scene/cell_scene.hpp"
#include "supple/draw/scene/contact_style.hpp"
#include "supple/draw/scene/particle_colors.hpp"

namespace supple {

namespace {

constexpr double legend_row = CellPage::legend_row, legend_sample = CellPage::legend_sample;

bool is_held(Mobility m) { return m != Mobility::free; }
double pair_force(const ContactRow& c) { return std::hypot(c.normal_force, c.tangential_force); }
bool in_tension(const ContactRow& c) { return c.state == ContactState::permanent && c.normal_force < 0; }

class SnapshotPage {
 public:
  SnapshotPage(const std::string& path, const RunInfo& info, const Frame& frame,
               const SnapshotOptions& options)
      : info_(info),
        frame_(frame),
        options_(options),
        page_(path, sheared(info.box, frame.strain), options.cell_size, options.strain_room,
              options.dots_per_inch),
        canvas_(page_.canvas()),
        box_(page_.box()),
        scene_(lay_out_cell(box_, info.radius, frame, page_.periodic() ? page_.rim() / page_.scale() : 0)),
        color_(options.color.empty() ? disc_colors(info.particle, scene_) : options.color) {
    const double mean_radius =
        info.radius.empty()
            ? 0
            : std::accumulate(info.radius.begin(), info.radius.end(), 0.0) / info.radius.size();
    disc_size_ = mean_radius * page_.scale();
    outline_ = std::clamp(0.05 * disc_size_, 0.15, 0.9);
    widest_ = std::clamp(0.21 * disc_size_, 0.5, 6.0);
    full_force_ = options.full_force > 0 ? options.full_force : strongest_force(info, frame);
  }

  void draw() {
    page_.draw_matter([&](double whiteness, Lies skipped) { draw_matter(whiteness, skipped); });
    draw_cell_edge();
    draw_title();
    draw_scale_bar();
    draw_legend();
    canvas_.finish();
  }

 private:
  template <class Shape>
  auto on_page(const Shape& shape) const {
    return page_.on_page(shape);
  }

  /// Discs and contacts, faded to this share of white, but for those that lie where nothing shows.
  void draw_matter(double whiteness, Lies skipped) {
    const auto shade = [&](Color c) { return mix(c, white, whiteness); };
    const auto each_disc = [&](auto&& draw) {
      for (const SceneDisc& disc : scene_.discs)
        if (disc.lies != skipped) draw(disc);
    };
    each_disc([&](const SceneDisc& disc) {
      const Color color = color_[disc.site];
      canvas_.polygon(on_page(disc.outline),
                      {shade(color), Pen{shade(mix(color, black, 0.16)), 0.5 * outline_}});
    });
    each_disc([&](const SceneDisc& disc) { draw_outline(disc, shade(ink)); });
    each_disc([&](const SceneDisc& disc) {
      if (is_held(frame_.mobility[disc.site]))
        hatch(on_page(disc.outline), std::max(0.25 * disc_size_, 1.0), {shade(ink), 0.6 * outline_});
      if (options_.spin == SpinMarks::shown) draw_spin(disc, shade(ink));
    });
    for (const ContactStyle& style : contact_styles)
      for (const SceneLine& line : scene_.lines)
        if (line.lies != skipped) draw_contact(line, style, shade);
  }

  /// The parts of a disc's outline that bound its particle.
  void draw_outline(const SceneDisc& disc, Color color) {
    const std::size_t n = disc.outline.size();
    std::vector<Point> run;
    for (std::size_t k = 0; k < n; ++k) {
      const std::int32_t other = disc.across[k];
      const bool boundary = other < 0 || info_.particle[other] != info_.particle[disc.site];
      if (boundary) {
        if (run.empty()) run.push_back(on_page(disc.outline[k]));
        run.push_back(on_page(disc.outline[(k + 1) % n]));
      }
      if (!run.empty() && (!boundary || k + 1 == n)) {
        canvas_.polyline(run, {color, outline_});
        run.clear();
      }
    }
  }

  /// Lines x + y = const in a convex outline, the same in all discs: held by a plate or fixed.
  void hatch(const std::vector<Point>& outline, double spacing, const Pen& pen) {
    if (outline.empty()) return;
    const auto level = [&](const Point& p) { return (p[0] + p[1]) / spacing; };
    const auto [low, high] = std::minmax_element(
        outline.begin(), outline.end(), [&](const Point& p, const Point& q) { return level(p) < level(q); });
    for (double line = std::ceil(level(*low)); line < level(*high); ++line) {
      std::vector<Point> ends;
      for (std::size_t k = 0; k < outline.size(); ++k) {
        const Point a = outline[k], b = outline[(k + 1) % outline.size()];
        if ((level(a) < line) != (level(b) < line))
          ends.push_back(a + ((line - level(a)) / (level(b) - level(a))) * (b - a));
      }
      if (ends.size() == 2) canvas_.line(ends[0], ends[1], pen);
    }
  }

  void draw_spin(const SceneDisc& disc, Color color) {
    const double angle = frame_.angle[disc.site], length = 0.6 * info_.radius[disc.site];
    canvas_.line(on_page(disc.centre), on_page(disc.centre + length * Vec2{std::cos(angle), std::sin(angle)}),
                 {color, 1.5 * outline_});
  }

  double force_width(double force) const {
    const double share = full_force_ > 0 ? std::min(force / full_force_, 1.2) : 0;
    return std::max(share * widest_, 0.12 * widest_);
  }
  Pen contact_pen(const ContactStyle& style, double force, bool tension) const {
    Pen pen{style.color, force_width(force)};
    if (tension) pen.dash = {1.2 * widest_, 0.7 * widest_};
    return pen;
  }
  template <class Shade>
  void draw_contact(const SceneLine& line, const ContactStyle& style, Shade shade) {
    const ContactRow& contact = frame_.contacts[line.contact];
    if (contact.state != style.state) return;
    Pen pen = contact_pen(style, pair_force(contact) * info_.units.force(), in_tension(contact));
    const Point from = on_page(line.from), to = on_page(line.to);
    if (style.state != ContactState::permanent)
      canvas_.line(from, to, {shade(white), pen.width + 1.2 * outline_});
    pen.color = shade(pen.color);
    canvas_.line(from, to, pen);
  }

  void draw_cell_edge() {
    const std::array<Point, 4>& corner = page_.corner();
    canvas_.polygon(corner, {{}, Pen{ink, 0.8}});
    const auto holds = [&](Mobility plate) {
      return std::find(frame_.mobility.begin(), frame_.mobility.end(), plate) != frame_.mobility.end();
    };
    if (holds(Mobility::lower_plate)) canvas_.line(corner[0], corner[1], {ink, 3});
    if (holds(Mobility::upper_plate)) canvas_.line(corner[3], corner[2], {ink, 3});
  }

  void draw_title() {
    std::string title = options_.title;
    if (title.empty()) {
      title = fmt::format("t = {}     \u03b3 = {}\u00a0%", with_unit(frame_.time * info_.units.time, "s"),
                          tick_label(100 * frame_.strain, 0.1));
      if (std::abs(drawn_strain(box_) - box_.strain) > 1e-9)
        title += fmt::format("     (drawn at the equivalent {}\u00a0%)",
                             tick_label(100 * drawn_strain(box_), 0.1));
    }
    page_.draw_title(title);
  }

  void draw_scale_bar() {
    const double length = round_below(0.25 * box_.length[flow] * info_.units.length);
    page_.draw_scale_bar(length / info_.units.length, with_unit(length, "m", Digits::fewest));
  }

  void draw_legend();
  void legend_discs(double x, double& y);
  void legend_contacts(double x, double& y);

  const RunInfo& info_;
  const Frame& frame_;
  const SnapshotOptions& options_;
  CellPage page_;
  Canvas& canvas_;
  const Box<2>& box_;
  CellScene scene_;
  std::vector<Color> color_;
  double disc_size_, outline_, widest_, full_force_;
};

void SnapshotPage::legend_discs(double x, double& y) {
  const auto row = [&](const std::string& name, std::initializer_list<Color> colors, bool hatched) {
    double at = x + 5;
    for (const Color& color : colors) {
      canvas_.circle({at, y}, 4.5, {color, Pen{ink, 0.5}});
      at += 7;
    }
    if (hatched) {
      std::vector<Point> ring;
      for (int k = 0; k < 24; ++k)
        ring.push_back(Point{x + 5 + 4.5 * std::cos(k * 0.2618), y + 4.5 * std::sin(k * 0.2618)});
      hatch(ring, 3, {ink, 0.5});
    }
    canvas_.text({x + legend_sample + 5, y}, name, {.size = 8, .down = Down::middle});
    y += legend_row;
  };
  std::vector<int> size(info_.particle.size(), 0);
  for (const std::int32_t p : info_.particle) ++size[static_cast<std::size_t>(p)];
  const auto has = [&](auto&& of_size) { return std::any_of(size.begin(), size.end(), of_size); };
  if (has([](int n) { return n > 1; }))
    row("particles", {area_palette[0], area_palette[1], area_palette[2]}, false);
  if (has([](int n) { return n == 1; })) row("single discs", {pale_gray}, false);
  if (std::any_of(frame_.mobility.begin(), frame_.mobility.end(), is_held))
    row("held by plate", {white}, true);
}

void SnapshotPage::legend_contacts(double x, double& y) {
  const auto row = [&](const std::string& name, const Pen& pen) {
    canvas_.line({x, y}, {x + legend_sample, y}, pen);
    canvas_.text({x + legend_sample + 5, y}, name, {.size = 8, .down = Down::middle});
    y += legend_row;
  };
  const double shown = full_force_ > 0 ? round_below(full_force_) : 0;
  for (const ContactStyle& style : contact_styles) {
    const auto is_drawn = [&](bool tension) {
      return std::any_of(frame_.contacts.begin(), frame_.contacts.end(), [&](const ContactRow& c) {
        return c.state == style.state && in_tension(c) == tension;
      });
    };
    if (is_drawn(false)) row(style.name, contact_pen(style, 0.5 * shown, false));
    if (is_drawn(true)) row(std::string(style.name) + ", tension", contact_pen(style, 0.5 * shown, true));
  }
  if (shown <= 0) return;
  y += 0.3 * legend_row;
  canvas_.text({x, y}, "line width: force", {.size = 8, .down = Down::middle});
  y += legend_row;
  row(with_unit(shown, "N/m", Digits::fewest), {gray, force_width(shown)});
  row(with_unit(0.5 * shown, "N/m", Digits::fewest), {gray, force_width(0.5 * shown)});
}

void SnapshotPage::draw_legend() {
  const double x = page_.legend_left();
  double y = page_.top() + 6;
  legend_discs(x, y);
  y += 0.5 * legend_row;
  legend_contacts(x, y);
}

}  // namespace

double strongest_force(const RunInfo& info, const Frame& frame) {
  std::vector<double> force;
  for (const ContactRow& c : frame.contacts) force.push_back(pair_force(c));
  if (force.empty()) return 0;
  const auto at = force.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(force.size() - 1));
  std::nth_element(force.begin(), at, force.end());
  return *at * info.units.force();
}

void draw_snapshot(const std::string& path, const RunInfo& info, const Frame& frame,
                   const SnapshotOptions& options) {
  const std::size_t n = info.radius.size();
  if (info.particle.size() != n || frame.position.size() != n || frame.angle.size() != n ||
      frame.mobility.size() != n || (!options.color.empty() && options.color.size() != n))
    throw input_error("cannot draw '" + path + "'", "its run and frame differ in their number of discs");
  SnapshotPage(path, info, frame, options).draw();
}

}  // namespace supple
