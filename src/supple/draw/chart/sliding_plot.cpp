#include "supple/draw/chart/sliding_plot.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "supple/draw/canvas/canvas.hpp"
#include "supple/draw/canvas/ticks.hpp"
#include "supple/draw/chart/chart.hpp"

namespace supple {

namespace {

constexpr double gap = 4, label_height = 22, rim = 0.35;  // [pt]
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

Layout lay_out(const SlidingPlot& plot, double most_height) {
  Layout layout;
  layout.low = {1e300, 1e300};
  layout.high = {-1e300, -1e300};
  for (const SlidingPicture& p : plot.pictures)
    for (const PicturedRing* ring : {&p.lower, &p.upper})
      for (const Vec2& x : ring->vertices)
        for (const int d : {0, 1}) {
          const double at = x[d] - middle_of(p.lower)[d];
          layout.low[d] = std::min(layout.low[d], at - ring->radius);
          layout.high[d] = std::max(layout.high[d], at + ring->radius);
        }
  layout.cell = (plot.width - 2 * gap) / static_cast<double>(plot.pictures.size());
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

void draw_pictures(Canvas& canvas, const SlidingPlot& plot, const Layout& layout, double top) {
  for (std::size_t k = 0; k < plot.pictures.size(); ++k) {
    const SlidingPicture& p = plot.pictures[k];
    const double left = gap + layout.cell * static_cast<double>(k);
    const double width = layout.scale * (layout.high[0] - layout.low[0]);
    const DrawnPair pair{canvas,
                         layout,
                         plot.outline,
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

ChartPanel panel_of(const SlidingPlot& plot) {
  ChartPanel panel{{"Displacement of the upper particle, x/D", ""}, {"Effective friction \u03bc", ""}, {}};
  double low = 0, high = 0;
  for (const SlidingCurve& curve : plot.curves) {
    for (const double x : curve.x) low = std::min(low, x), high = std::max(high, x);
    ChartSeries series{curve.label, curve.x, curve.friction};
    series.color = line_palette[panel.series.size() % line_palette.size()];
    panel.series.push_back(std::move(series));
  }
  if (plot.bound)
    for (const double sign : {1.0, -1.0})
      panel.series.insert(panel.series.begin(),
                          {sign > 0 ? fmt::format("bound (9.13): {:.4f}", *plot.bound) : "",
                           {low, high},
                           {sign * *plot.bound, sign * *plot.bound},
                           {},
                           gray,
                           Marks::line,
                           0.8,
                           {4, 2}});
  ChartSeries marks{"", {}, {}, {}, ink, Marks::points, 1.8};
  for (const SlidingPicture& p : plot.pictures) marks.x.push_back(p.x), marks.y.push_back(p.friction);
  panel.series.push_back(std::move(marks));
  return panel;
}

}  // namespace

void draw_sliding_plot(const std::string& path, const SlidingPlot& plot) {
  Chart chart{{{{panel_of(plot)}, 1}}, plot.width, plot.height};
  Layout layout;
  if (!plot.pictures.empty()) {
    layout = lay_out(plot, 0.5 * plot.height);
    chart.room_below = layout.height + label_height + gap;
    chart.below = [&](Canvas& canvas, double top) { draw_pictures(canvas, plot, layout, top); };
  }
  draw_chart(path, chart);
}

}  // namespace supple
