#include "supple/draw/page/legend.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "supple/draw/canvas/ticks.hpp"
#include "supple/draw/page/cell_page.hpp"

namespace supple {

namespace {

constexpr double swatch = 4.5;  // [pt]

/// A circle as a closed line.
std::vector<Point> ring_about(const Point& centre, double radius) {
  std::vector<Point> ring;
  for (int k = 0; k < 24; ++k) {
    const double angle = k * std::numbers::pi / 12;
    ring.push_back(centre + radius * Point{std::cos(angle), std::sin(angle)});
  }
  return ring;
}

}  // namespace

void Legend::name_row(const std::string& name) {
  canvas_.text({x_ + sample + 5, y_}, name, {.size = 8, .down = Down::middle});
  y_ += row;
}

void Legend::line_row(const std::string& name, const Pen& pen) {
  canvas_.line({x_, y_}, {x_ + sample, y_}, pen);
  name_row(name);
}

void Legend::swatch_row(const std::string& name, const std::vector<Color>& colors) {
  for (std::size_t k = 0; k < colors.size(); ++k)
    canvas_.circle({x_ + 5 + 7.0 * static_cast<double>(k), y_}, swatch, {colors[k], Pen{ink, 0.5}});
  name_row(name);
}

void Legend::color_bar(const BodyScalar& scalar, const ColorScale& scale, double height) {
  y_ = draw_color_bar(canvas_, {x_, top_}, height, scale, scalar.label, scalar.unit) + 24;
}

void Legend::particles(const Scene& scene) {
  if (scene.particle.empty()) return;
  const std::vector<bool> single = single_discs(scene);
  if (std::ranges::count(single, false) > 0)
    swatch_row("particles", {area_palette[0], area_palette[1], area_palette[2]});
  if (std::ranges::count(single, true) > 0) swatch_row("single discs", {pale_gray});
}

void Legend::held(const Scene& scene, const std::function<void(const std::vector<Point>&)>& hatch) {
  const auto any = [&](auto&& holds) { return std::ranges::any_of(scene.mobility, holds); };
  if (!any([](Mobility m) { return m != Mobility::free; })) return;
  canvas_.circle({x_ + 5, y_}, swatch, {white, Pen{ink, 0.5}});
  hatch(ring_about({x_ + 5, y_}, swatch));
  name_row(any(is_plate) ? "held by plate" : "held");
}

void Legend::contacts(const Scene& scene, const ContactLines& lines) {
  const double most = lines.full_force > 0 ? round_below(lines.full_force) : 0;
  const bool differ = std::ranges::any_of(
      scene.contacts, [](const SceneContact& c) { return c.state != ContactState::slip; });
  if (!is_empty()) y_ += 0.5 * row;
  Color color = contact_styles.back().color;
  if (differ) {  // without friction all contacts slip: nothing to tell apart
    for (const ContactStyle& style : contact_styles)
      for (const bool tension : {false, true})
        if (std::ranges::any_of(scene.contacts, [&](const SceneContact& c) {
              return c.state == style.state && c.tension == tension;
            }))
          line_row(std::string(style.name) + (tension ? ", tension" : ""),
                   lines.pen(style.color, 0.5 * most, tension));
    y_ += 0.3 * row;
    color = gray;
  }
  if (most <= 0) return;
  canvas_.text({x_, y_}, differ ? "line width: force" : "contacts, width: force",
               {.size = 8, .down = Down::middle});
  y_ += row;
  for (const double force : {most, 0.5 * most})
    line_row(shown(scene.units, force, "N/m"), lines.pen(color, force));
}

}  // namespace supple
