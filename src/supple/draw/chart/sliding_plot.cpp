#include "supple/draw/chart/sliding_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "supple/draw/canvas/canvas.hpp"
#include "supple/draw/canvas/ticks.hpp"
#include "supple/draw/chart/chart.hpp"
#include "supple/experiment/sliding_pair.hpp"

namespace supple {

namespace {

constexpr double gap = 4, label_height = 22, title_height = 12, rim = 0.35;  // [pt]
const Color of_lower = hex(0x99DDFF), of_upper = hex(0xEEDD88), held_below = hex(0x228833),
            held_above = hex(0xEE6677);

/// All pictures have the same scale, and their lower particles the same place.
struct Layout {
  double scale = 1, cell = 0, height = 0;
  Vec2 low{}, high{};
};

Vec2 middle_of(const PicturedRing& ring) {
  Vec2 sum{};
  for (const Vec2& x : ring.vertices) sum += x;
  return (1 / static_cast<double>(std::max<std::size_t>(ring.vertices.size(), 1))) * sum;
}

Layout lay_out(const SlidingRow& row, double page_width, double most_height) {
  Layout layout;
  layout.low = {1e300, 1e300};
  layout.high = {-1e300, -1e300};
  for (const SlidingPicture& p : row.pictures)
    for (const PicturedRing* ring : {&p.lower, &p.upper})
      for (const Vec2& x : ring->vertices)
        for (const int d : {0, 1}) {
          const double at = x[d] - middle_of(p.lower)[d];
          layout.low[d] = std::min(layout.low[d], at - ring->radius);
          layout.high[d] = std::max(layout.high[d], at + ring->radius);
        }
  layout.cell = (page_width - 2 * gap) / static_cast<double>(row.pictures.size());
  const Vec2 size = layout.high - layout.low;
  layout.scale = std::min((layout.cell - gap) / size[0], most_height / size[1]);
  layout.height = layout.scale * size[1];
  return layout;
}

/// The particles of one picture, on its place.
struct DrawnPair {
  Canvas& canvas;
  const Layout& layout;
  Outline outline;
  Vec2 origin;  ///< the middle of the lower particle
  Point corner;

  Point place(const Vec2& x) const {
    const Vec2 at = x - origin - layout.low;
    return corner + Point{layout.scale * at[0], layout.height - layout.scale * at[1]};
  }
  void draw(const PicturedRing& ring, Color color, Color color_held) const {
    std::vector<Point> at;
    for (const Vec2& x : ring.vertices) at.push_back(place(x));
    const double radius = layout.scale * ring.radius;
    if (outline == Outline::smooth) {
      canvas.polygon(at, {{}, Pen{ink, 2 * radius + 2 * rim}});
      canvas.polygon(at, {color, Pen{color, 2 * radius}});
      canvas.polygon(at, {{}, Pen{mix(color, ink, 0.4), rim}});
    } else {
      canvas.polygon(at, {color, {}});
    }
    for (std::size_t k = 0; k < at.size(); ++k) {
      const bool held = std::find(ring.held.begin(), ring.held.end(), static_cast<int>(k)) != ring.held.end();
      if (outline == Outline::rough) canvas.circle(at[k], radius, {held ? color_held : color, Pen{ink, rim}});
      else if (held) canvas.circle(at[k], std::min(radius, 2.0), {color_held, {}});
    }
  }
};

void draw_row(Canvas& canvas, const SlidingRow& row, const Layout& layout, double top) {
  if (!row.label.empty()) canvas.text({gap, top + 8}, row.label, {.weight = Weight::bold});
  top += row.label.empty() ? 0 : title_height;
  for (std::size_t k = 0; k < row.pictures.size(); ++k) {
    const SlidingPicture& p = row.pictures[k];
    const double left = gap + layout.cell * static_cast<double>(k);
    const double width = layout.scale * (layout.high[0] - layout.low[0]);
    const DrawnPair pair{canvas,
                         layout,
                         row.outline,
                         middle_of(p.lower),
                         {left + 0.5 * (layout.cell - width), top + label_height}};
    pair.draw(p.lower, of_lower, held_below);
    pair.draw(p.upper, of_upper, held_above);
    canvas.text({left + 0.5 * layout.cell, top + 9}, fmt::format("{}", k + 1),
                {.across = Across::centre, .weight = Weight::bold});
    canvas.text({left + 0.5 * layout.cell, top + 18}, fmt::format("x = {}\u00a0D", tick_label(p.x, 0.01)),
                {.size = 6.5, .across = Across::centre});
  }
}

double height_of(const SlidingRow& row, const Layout& layout) {
  return layout.height + label_height + (row.label.empty() ? 0 : title_height) + gap;
}

ChartPanel panel_of(const SlidingPlot& plot) {
  ChartPanel panel{{"Displacement of the upper particle, x/D", ""}, {"Effective friction \u03bc", ""}, {}};
  double low = 0, high = 0;
  for (const SlidingCurve& curve : plot.curves) {
    for (const double x : curve.x) low = std::min(low, x), high = std::max(high, x);
    ChartSeries series{curve.label, curve.x, curve.friction};
    series.color = line_palette[panel.series.size() % line_palette.size()];
    panel.series.push_back(std::move(series));
  }
  for (const double bound : plot.bounds)
    for (const double sign : {1.0, -1.0})
      panel.series.insert(panel.series.begin(), {sign > 0 ? fmt::format("bound (9.13): {:.4f}", bound) : "",
                                                 {low, high},
                                                 {sign * bound, sign * bound},
                                                 {},
                                                 gray,
                                                 Marks::line,
                                                 0.8,
                                                 {4, 2}});
  ChartSeries marks{"", {}, {}, {}, ink, Marks::points, 1.8};
  for (const SlidingRow& row : plot.rows)
    for (const SlidingPicture& p : row.pictures) marks.x.push_back(p.x), marks.y.push_back(p.friction);
  panel.series.push_back(std::move(marks));
  if (plot.star)
    panel.series.push_back(
        {"star", {(*plot.star)[0]}, {(*plot.star)[1]}, {}, line_palette[5], Marks::points, 3});
  return panel;
}

}  // namespace

void draw_sliding_plot(const std::string& path, const SlidingPlot& plot) {
  Chart chart{{{{panel_of(plot)}, 1}}, plot.width, plot.height};
  const double most_height =
      0.5 * plot.height / static_cast<double>(std::max<std::size_t>(1, plot.rows.size()));
  std::vector<Layout> layouts;
  for (const SlidingRow& row : plot.rows) {
    layouts.push_back(row.pictures.empty() ? Layout{} : lay_out(row, plot.width, most_height));
    chart.room_below += height_of(row, layouts.back());
  }
  chart.below = [&](Canvas& canvas, double top) {
    for (std::size_t k = 0; k < layouts.size(); ++k) {
      draw_row(canvas, plot.rows[k], layouts[k], top);
      top += height_of(plot.rows[k], layouts[k]);
    }
  };
  draw_chart(path, chart);
}

SlidingPicture sliding_picture(const RunInfo<2>& info, const Frame<2>& frame) {
  const auto ring = [&](std::size_t b) {
    const std::int32_t begin = info.body_begin[b], end = info.body_begin[b + 1];
    return PicturedRing{{frame.position.begin() + begin, frame.position.begin() + end},
                        info.radius[static_cast<std::size_t>(begin)],
                        held_vertices(end - begin, b == 1)};
  };
  const bool touches = !frame.contacts.empty();
  return {frame.numbers.at("sliding_x"),
          touches ? frame.numbers.at("friction") : std::numeric_limits<double>::quiet_NaN(), ring(0),
          ring(1)};
}

std::vector<SlidingPicture> seven_of(const std::vector<SlidingPicture>& all) {
  constexpr int wanted = 7;
  double begin = std::numeric_limits<double>::infinity(), end = -begin;
  for (const SlidingPicture& p : all)
    if (std::isfinite(p.friction)) begin = std::min(begin, p.x), end = std::max(end, p.x);
  if (begin > end) return {};
  const double beyond = 0.1 * (end - begin);
  std::vector<SlidingPicture> chosen;
  for (int k = 0; k < wanted; ++k) {
    const double at = begin - beyond + (end - begin + 2 * beyond) * k / (wanted - 1);
    const auto nearest = std::min_element(all.begin(), all.end(), [&](const auto& a, const auto& b) {
      return std::abs(a.x - at) < std::abs(b.x - at);
    });
    if (chosen.empty() || chosen.back().x != nearest->x) chosen.push_back(*nearest);
  }
  return chosen;
}

}  // namespace supple
