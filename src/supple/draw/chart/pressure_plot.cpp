#include "supple/draw/chart/pressure_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "supple/core/error.hpp"
#include "supple/draw/chart/chart.hpp"
#include "supple/draw/chart/chart_scale.hpp"

namespace supple {

namespace {

constexpr int fit_points = 200;

void check(const std::string& path, const std::vector<PressureSeries>& series, PressureAxes axes) {
  const std::string what = "cannot plot '" + path + "'";
  if (series.empty()) throw input_error(what, "there is no series of pressure");
  for (const PressureSeries& s : series) {
    if (s.packing_fraction.size() != s.pressure.size())
      throw input_error(what, fmt::format("'{}' has {} pressures for {} packing fractions", s.label,
                                          s.pressure.size(), s.packing_fraction.size()));
    if (axes == PressureAxes::log_excess && !s.fit)
      throw input_error(what, "'" + s.label + "' has no fit", "its onset is the zero of the axis");
  }
}

/// Where phi stands on the x axis of a series.
double on_axis(const PressureSeries& s, PressureAxes axes, double phi) {
  return axes == PressureAxes::log_excess ? phi - s.fit->onset : phi;
}

ChartSeries points_of(const PressureSeries& s, PressureAxes axes, Color color) {
  ChartSeries points{s.label, {}, s.pressure, {}, color, Marks::points, 1.9};
  for (const double phi : s.packing_fraction) points.x.push_back(on_axis(s, axes, phi));
  if (s.fit && !s.label.empty()) points.label += fmt::format(", onset {:.4f}", s.fit->onset);
  return points;
}

/// The line of a fit, from the onset (on a logarithmic axis, from the least point above it) to the last point
/// of the series.
ChartSeries line_of(const PressureSeries& s, PressureAxes axes, Color color) {
  ChartSeries line{"", {}, {}, {}, mix(color, black, 0.25), Marks::line, 0.9, {4, 2}};
  double from = s.fit->onset, to = s.fit->onset;
  for (const double phi : s.packing_fraction)
    if (std::isfinite(phi)) to = std::max(to, phi);
  if (axes != PressureAxes::linear) {
    from = to;
    for (std::size_t i = 0; i < s.pressure.size(); ++i)
      if (s.packing_fraction[i] > s.fit->onset && s.pressure[i] > 0)
        from = std::min(from, s.packing_fraction[i]);
  }
  if (!(to > from)) return line;
  const double ratio = (to - s.fit->onset) / (from - s.fit->onset);  // infinite where the axes are linear
  for (int k = 0; k <= fit_points; ++k) {
    const double share = static_cast<double>(k) / fit_points;
    const double excess = axes == PressureAxes::linear ? share * (to - s.fit->onset)
                                                       : (from - s.fit->onset) * std::pow(ratio, share);
    line.x.push_back(on_axis(s, axes, s.fit->onset + excess));
    line.y.push_back(s.fit->slope * excess);
  }
  return line;
}

/// The range of x of the points that show, and a little more, so that no point lies on the frame.
std::optional<std::pair<double, double>> range_of_x(const ChartPanel& panel) {
  std::pair range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const ChartSeries& s : panel.series)
    for (std::size_t i = 0; i < s.x.size(); ++i)
      if (can_show(panel.x.spacing, s.x[i]) && can_show(panel.y.spacing, s.y[i]))
        range = {std::min(range.first, s.x[i]), std::max(range.second, s.x[i])};
  if (range.first > range.second) return {};
  AxisScale scale = scale_of_axis(panel.x, range);
  scale.widen(0.04, 0.04);
  return std::pair(scale.low, scale.high);
}

}  // namespace

void draw_pressure_plot(const std::string& path, const std::vector<PressureSeries>& series,
                        const PressurePlotOptions& options) {
  check(path, series, options.axes);
  ChartPanel panel{{"Packing fraction \u03c6", ""}, {"Pressure P", options.pressure_unit}, {}};
  if (options.axes == PressureAxes::log_excess) {
    panel.x.label = "Packing fraction above onset, \u0394\u03c6";
    panel.x.spacing = Spacing::logarithmic;
  }
  if (options.axes != PressureAxes::linear) panel.y.spacing = Spacing::logarithmic;
  if (!options.heading.empty()) panel.heading.push_back(options.heading);

  std::vector<ChartSeries> lines, points;
  for (std::size_t k = 0; k < series.size(); ++k) {
    const Color color = line_palette[k % line_palette.size()];
    points.push_back(points_of(series[k], options.axes, color));
    ChartSeries joined = points.back();
    joined.label.clear();
    joined.marks = Marks::line;
    joined.width = 0.6;
    joined.color = mix(color, white, 0.5);
    panel.series.push_back(std::move(joined));
    if (series[k].fit) lines.push_back(line_of(series[k], options.axes, color));
  }
  for (auto* group : {&lines, &points})
    for (ChartSeries& s : *group) panel.series.push_back(std::move(s));
  panel.x.range = range_of_x(panel);
  if (options.target && panel.x.range) {
    const auto [low, high] = *panel.x.range;
    ChartSeries line{"wanted", {low, high}, {*options.target, *options.target}, {}, gray, Marks::line,
                     0.8,      {4, 2}};
    panel.series.insert(panel.series.begin(), std::move(line));
  }
  draw_chart(path, {{{{panel}, 1}}, options.width, options.height});
}

}  // namespace supple
