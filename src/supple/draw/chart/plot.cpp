#include "supple/draw/chart/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "supple/core/error.hpp"
#include "supple/core/whole_number.hpp"
#include "supple/draw/canvas/superscript.hpp"
#include "supple/draw/canvas/ticks.hpp"
#include "supple/draw/chart/chart.hpp"
#include "supple/draw/chart/uncertainty.hpp"

namespace supple {

namespace {

constexpr Color rest_color = hex(0xF1F1F1);
constexpr Color first_cycle = hex(0xA8CBE8), last_cycle = hex(0x1B4F82);
constexpr int ellipse_points = 181;

const ChartAxis time_axis{"Time", "s"};
const ChartAxis strain_axis{"Strain \u03b3", "%"};
const ChartAxis stress_axis{"Shear stress \u03c4", "Pa"};

void check_length(const std::vector<double>& series, std::size_t length, const std::string& name) {
  if (series.size() != length)
    throw input_error(fmt::format("cannot plot {}", name),
                      fmt::format("{} values for {} times", series.size(), length));
}

/// "565 ± 20 Pa": both numbers with the prefix of the larger.
std::string with_error(double value, double error, const std::string& unit) {
  // Units of their own have no prefixes.
  if (unit != "Pa") {
    const std::string number = error < 0 ? short_number(value) : value_with_error(value, error);
    return with_minus_sign(number) + (unit.empty() ? "" : "\u00a0" + unit);
  }
  if (error < 0) return with_unit(value, unit);
  const Prefix prefix = si_prefix(std::max(std::abs(value), error));
  return with_minus_sign(value_with_error(value / prefix.factor, error / prefix.factor)) + "\u00a0" +
         prefix.symbol + unit;
}

std::string moduli_line(const StressEstimate& e, const std::string& unit) {
  return fmt::format("{}:  G\u2032 = {},  G\u2033 = {}", e.name, with_error(e.storage, e.storage_error, unit),
                     with_error(e.loss, e.loss_error, unit));
}

Color color_of(std::size_t stress) { return line_palette[stress % std::size(line_palette)]; }

ChartAxis stress_axis_of(const OscillatoryPlot& plot) {
  ChartAxis axis{stress_axis.label, plot.stress_unit};
  if (plot.stress_scale) axis.range = {-*plot.stress_scale, *plot.stress_scale};
  return axis;
}

std::vector<ChartBand> phases(const OscillatoryPlot& plot) {
  const Protocol& p = plot.protocol;
  const double begin = p.pre / p.frequency, end = begin + p.periods / p.frequency, last = plot.time.back();
  std::vector<ChartBand> bands;
  if (begin > 0) bands.push_back({plot.time.front(), begin, "rest", rest_color});
  bands.push_back({begin, std::min(end, last), "shear", white});
  if (last > end) bands.push_back({end, last, "rest", rest_color});
  return bands;
}

ChartColumn against_time(const OscillatoryPlot& plot) {
  const Protocol& p = plot.protocol;
  const ChartAxis time{time_axis.label, plot.time_unit};
  ChartPanel strain{time, strain_axis, {{"", plot.time, plot.strain}}, phases(plot)};
  const std::string frequency =
      plot.time_unit == "s" ? with_unit(p.frequency, "Hz") : short_number(p.frequency);
  strain.heading = {fmt::format("A = {:.4g}\u00a0%,  f = {}", 100 * p.amplitude, frequency)};
  strain.weight = 0.6;
  ChartPanel stress{time, stress_axis_of(plot), {}, phases(plot)};
  for (std::size_t k = 0; k < plot.stresses.size(); ++k)
    stress.series.push_back({plot.stresses[k].name, plot.time, plot.stresses[k].stress, {}, color_of(k)});
  for (ChartBand& band : stress.bands) band.label.clear();
  return {{strain, stress}, 1.3};
}

/// Stress against strain in cycle c (from 0), without the offset and drift of the fit, as its ellipse is.
ChartSeries cycle_loop(const OscillatoryPlot& plot, const StressEstimate& estimate, int c, int cycles) {
  const Protocol& p = plot.protocol;
  ChartSeries loop;
  loop.color = mix(first_cycle, last_cycle, cycles > 1 ? c / (cycles - 1.0) : 1);
  loop.width = 0.9;
  const double start = p.pre / p.frequency, slack = 1e-9 / p.frequency;
  const double from = start + c / p.frequency - slack;
  const double to = start + std::min(c + 1.0, p.periods) / p.frequency + slack;
  for (std::size_t i = 0; i < plot.time.size(); ++i) {
    if (plot.time[i] < from || plot.time[i] > to) continue;
    loop.x.push_back(plot.strain[i]);
    loop.y.push_back(estimate.stress[i] - estimate.offset - estimate.drift * (plot.time[i] - start));
  }
  if (cycles <= 4 || c == 0 || c + 1 == cycles) loop.label = fmt::format("cycle {}", c + 1);
  return loop;
}

/// tau = G' A sin(phase) + G'' A cos(phase) against gamma = A sin(phase).
ChartSeries fitted_ellipse(const StressEstimate& estimate, double amplitude) {
  ChartSeries ellipse;
  for (int k = 0; k < ellipse_points; ++k) {
    const double phase = 2 * std::numbers::pi * k / (ellipse_points - 1);
    ellipse.x.push_back(amplitude * std::sin(phase));
    ellipse.y.push_back(amplitude * (estimate.storage * std::sin(phase) + estimate.loss * std::cos(phase)));
  }
  return ellipse;
}

ChartColumn lissajous(const OscillatoryPlot& plot) {
  ChartPanel panel{strain_axis, stress_axis_of(plot), {}};
  const double periods =
      std::min(std::ceil(plot.protocol.periods - 1e-9), static_cast<double>(plot.time.size()));
  const int cycles = std::max(1, whole_number<int>(periods, "cycles of the shear", "look at the run"));
  for (int c = 0; c < cycles; ++c) panel.series.push_back(cycle_loop(plot, plot.stresses.front(), c, cycles));
  for (std::size_t k = 0; k < plot.stresses.size(); ++k) {
    ChartSeries ellipse = fitted_ellipse(plot.stresses[k], plot.protocol.amplitude);
    ellipse.label = moduli_line(plot.stresses[k], plot.stress_unit);
    ellipse.color = k == 0 ? black : color_of(k);
    if (k == 0) ellipse.width = 1.2;
    else ellipse.dash = {4, 2};
    panel.series.push_back(std::move(ellipse));
  }
  const double reach = 1.1 * plot.protocol.amplitude;
  panel.x.range = {-reach, reach};
  return {{panel}, 1};
}

}  // namespace

void plot_oscillatory(const std::string& path, const OscillatoryPlot& plot) {
  const std::size_t n = plot.time.size();
  if (n < 2 || plot.stresses.empty())
    throw input_error("cannot plot '" + path + "'", "the run has no stress series");
  check_length(plot.strain, n, "strain");
  for (const StressEstimate& e : plot.stresses) check_length(e.stress, n, e.name + " stress");
  draw_chart(path, {{against_time(plot), lissajous(plot)}});
}

void plot_dynamics(const std::string& path, const DynamicsPlot& plot) {
  const std::size_t n = plot.time.size();
  if (n < 2) throw input_error("cannot plot '" + path + "'", "the run has no stress series");
  check_length(plot.strain, n, "strain");
  const auto [least, most] = std::minmax_element(plot.strain.begin(), plot.strain.end());
  const bool sheared = *most > *least;

  ChartPanel stress{time_axis, stress_axis, {}};
  ChartPanel loop{strain_axis, stress_axis, {}};
  for (std::size_t k = 0; k < plot.stresses.size(); ++k) {
    const auto& [name, series] = plot.stresses[k];
    check_length(series, n, name + " stress");
    stress.series.push_back({name, plot.time, series, {}, color_of(k)});
    loop.series.push_back({name, plot.strain, series, {}, color_of(k)});
  }

  ChartColumn column{{}, 1.3};
  if (sheared) column.panels.push_back({time_axis, strain_axis, {{"", plot.time, plot.strain}}, {}, {}, 0.6});
  if (!stress.series.empty()) column.panels.push_back(stress);
  if (!plot.pressure.empty()) {
    check_length(plot.pressure, n, "pressure");
    column.panels.push_back({time_axis, {"Pressure", "Pa"}, {{"", plot.time, plot.pressure}}, {}, {}, 0.7});
  }
  if (column.panels.empty())
    throw input_error("cannot plot '" + path + "'", "the run has neither stress nor strain");
  Chart chart{{column}};
  const double room = 0.05 * (*most - *least);
  loop.x.range = {*least - room, *most + room};
  if (sheared && !loop.series.empty()) chart.columns.push_back({{loop}, 1});
  draw_chart(path, chart);
}

}  // namespace supple
