#include "supple/io/run/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "supple/core/error.hpp"
#include "supple/draw/chart/chart.hpp"
#include "supple/draw/chart/pressure_plot.hpp"
#include "supple/draw/chart/sliding_plot.hpp"
#include "supple/io/run/run_pictures.hpp"

namespace supple {

namespace {

std::string unit_of(const RunFile& run, const std::string& table, const std::string& name) {
  for (const Column& column : run.columns(table))
    if (column.name == name) return column.unit;
  return "";
}

bool has_column(const RunFile& run, const std::string& table, const std::string& name) {
  const std::vector<Column> columns = run.columns(table);
  return std::any_of(columns.begin(), columns.end(), [&](const Column& c) { return c.name == name; });
}

void check_rows(const RunFile& run, const std::string& table) {
  if (!run.has_table(table) || run.rows(table) < 2)
    throw input_error("cannot plot " + run.path(),
                      "it holds less than two rows of its table '" + table + "'");
}

/// Draws the search without the points far below the wanted pressure, which are zero or what the minimiser
/// left.
void plot_jamming(const std::string& path, const RunFile& run) {
  const Case c = run.resolved_case();
  const std::string kind = c.jamming.pressure_kind == "contact" ? "contact_pressure" : "pressure";
  const std::vector<double> phi = run.column("packing", "packing_fraction"), p = run.column("packing", kind);
  PressureSeries search{"search", {}, {}};
  for (std::size_t k = 0; k < p.size(); ++k) {
    if (p[k] < 1e-3 * c.jamming.pressure) continue;
    search.packing_fraction.push_back(phi[k]);
    search.pressure.push_back(p[k]);
  }
  PressurePlotOptions options;
  options.axes = PressureAxes::log_pressure;
  options.pressure_unit = unit_of(run, "packing", kind);
  options.target = c.jamming.pressure;
  draw_pressure_plot(path, {search}, options);
}

/// The fit of a branch, where the run found one.
std::optional<PressureFit> fit_of(const RunFile& run, const std::string& branch) {
  const auto onset = run.find_value("results", "onset_" + branch),
             slope = run.find_value("results", "slope_" + branch);
  if (!onset || !slope) return {};
  return PressureFit{*onset, *slope};
}

void plot_compression(const std::string& path, const RunFile& run) {
  const std::vector<double> phi = run.column("packing", "packing_fraction"),
                            p = run.column("packing", "pressure"), branch = run.column("packing", "branch");
  std::vector<PressureSeries> series;
  for (const auto& [name, sign] : {std::pair("compression", 1), std::pair("decompression", -1)}) {
    PressureSeries one{name, {}, {}, fit_of(run, name)};
    for (std::size_t k = 0; k < p.size(); ++k) {
      const bool turns =
          sign < 0 && k + 1 < p.size() && branch[k] > 0 && branch[k + 1] < 0;  // shared by both
      if (branch[k] * sign < 0 && !turns) continue;
      one.packing_fraction.push_back(phi[k]);
      one.pressure.push_back(p[k]);
    }
    if (!one.pressure.empty()) series.push_back(std::move(one));
  }
  PressurePlotOptions options;
  options.pressure_unit = unit_of(run, "packing", "pressure");
  draw_pressure_plot(path, series, options);
}

ChartPanel panel_of(const RunFile& run, const std::string& table, const ChartAxis& x,
                    const std::string& along, const ChartAxis& y,
                    const std::vector<std::pair<const char*, const char*>>& columns) {
  ChartPanel panel{x, y, {}};
  for (const auto& [column, label] : columns) {
    ChartSeries series{label, run.column(table, along), run.column(table, column)};
    series.color = line_palette[panel.series.size() % line_palette.size()];
    panel.series.push_back(std::move(series));
  }
  return panel;
}

void plot_uniaxial(const std::string& path, const RunFile& run) {
  const ChartAxis strain{"Strain", "%"};
  const auto panel = [&](const ChartAxis& y, const char* column) {
    return panel_of(run, "packing", strain, "strain", y, {{column, ""}});
  };
  draw_chart(path, {{{{panel({"Force on the wall", ""}, "wall_force"),
                       panel({"Vertex contacts per pair", ""}, "contact_length")},
                      1}},
                    300,
                    300});
}

/// Points of the rows of one branch that logarithmic axes can show.
ChartSeries branch_of_plates(const RunFile& run, const std::string& table, const std::string& column,
                             double branch) {
  const std::vector<double> x = run.column(table, "compression"), y = run.column(table, column),
                            sign = run.column(table, "branch");
  ChartSeries series{branch > 0 ? "loading" : "unloading", {}, {}};
  series.color = line_palette[branch > 0 ? 0 : 1];
  // Both branches mostly lie on each other: points are seen beside a line.
  series.marks = branch > 0 ? Marks::points : Marks::line;
  series.width = branch > 0 ? 1.6 : 0.9;
  for (std::size_t k = 0; k < x.size(); ++k)
    if (sign[k] == branch && x[k] > 0 && y[k] > 0) {
      series.x.push_back(x[k]);
      series.y.push_back(y[k]);
    }
  return series;
}

/// A thin line of this slope through half of the force at compression `at`, over all of the points.
ChartSeries slope_guide(const ChartSeries& points, double slope, double at, const std::vector<double>& dash) {
  ChartSeries guide{fmt::format("slope {}", slope), {}, {}, {}, gray, Marks::line, 0.5, dash};
  const auto place = std::find(points.x.begin(), points.x.end(), at);
  if (place == points.x.end()) return guide;
  const double force = points.y[static_cast<std::size_t>(place - points.x.begin())];
  const auto [low, high] = std::minmax_element(points.x.begin(), points.x.end());
  for (const double x : {*low, *high}) {
    guide.x.push_back(x);
    guide.y.push_back(0.5 * force * std::pow(x / at, slope));
  }
  return guide;
}

/// Force and, where the run found them, local exponents against compression.
void plot_plates(const std::string& path, const RunFile& run) {
  const ChartAxis x{"Compression \u03b4/D", "", {}, Spacing::logarithmic};
  const ChartSeries down = branch_of_plates(run, "plates", "force", 1),
                    up = branch_of_plates(run, "plates", "force", -1);
  ChartPanel force{x, {"Force", unit_of(run, "plates", "force"), {}, Spacing::logarithmic}, {}};
  // The steeper guide ends below the last point, or it would cross the data.
  const double first = down.x.empty() ? 0 : down.x.front(), last = down.x.empty() ? 0 : down.x.back();
  force.series = {slope_guide(down, 1, first, {}), slope_guide(down, 1.5, last, {3, 2}), up, down};
  if (up.x.empty()) force.series.erase(force.series.begin() + 2);
  force.weight = 1.6;
  ChartColumn column{{force}, 1};
  if (run.has_table("local_exponents") && run.rows("local_exponents") > 1) {
    ChartPanel exponent{x, {"Local exponent", ""}, {}};
    for (const double branch : {-1, 1}) {
      ChartSeries series = branch_of_plates(run, "local_exponents", "exponent", branch);
      series.label.clear();
      if (!series.x.empty()) exponent.series.push_back(std::move(series));
    }
    if (!exponent.series.empty()) column.panels.push_back(std::move(exponent));
  }
  draw_chart(path, {{column}, 300, 330});
}

void plot_motion(const std::string& path, const RunFile& run) {
  const ChartAxis time{"Time", ""};
  const auto panel = [&](const ChartAxis& y,
                         const std::vector<std::pair<const char*, const char*>>& columns) {
    return panel_of(run, "motion", time, "time", y, columns);
  };
  ChartColumn column{
      {panel({"Energy", ""},
             {{"potential_energy", "potential"}, {"kinetic_energy", "kinetic"}, {"total_energy", "total"}})},
      1};
  column.panels.back().weight = 1.6;
  if (has_column(run, "motion", "front"))
    column.panels.push_back(
        panel({"Length", ""}, {{"front", "front of the heap"}, {"top", "top of the heap"}}));
  else column.panels.push_back(panel({"Pressure", unit_of(run, "motion", "pressure")}, {{"pressure", ""}}));
  draw_chart(path, {{column}, 340, 300});
}

/// Pictures of the first way of the upper particle over the lower one, which has so many places.
SlidingRow pictured_way(const RunFile& run, std::int64_t places) {
  // Frames are evenly spaced over all ways.
  const std::int64_t last = std::max<std::int64_t>(1, run.rows("friction") - 1),
                     frames = 1 + (run.frames() - 1) * (places - 1) / last;
  const RunInfo<2> info = run.info();
  std::vector<SlidingPicture> all;
  for (std::int64_t k = 0; k < frames; ++k) all.push_back(sliding_picture(info, run.frame(k)));
  return {seven_of(all), run.resolved_case().contact.kind == "smooth" ? Outline::smooth : Outline::rough};
}

void plot_friction(const std::string& path, const RunFile& run) {
  const std::vector<double> leg = run.column("friction", "leg"), x = run.column("friction", "x_over_width"),
                            mu = run.column("friction", "friction"),
                            contacts = run.column("friction", "contacts");
  const Case c = run.resolved_case();
  SlidingPlot plot;
  if (const auto bound = run.find_value("constants", "friction_bound")) plot.bounds = {*bound};
  for (std::size_t k = 0; k < x.size(); ++k) {
    const bool turns = k > 0 && leg[k] != leg[k - 1];
    if (k == 0 || turns) {
      plot.curves.push_back({});
      if (c.sliding.path == "cyclic")
        plot.curves.back().label = leg[k] == 0 ? "there" : leg[k] == 1 ? "back" : "";
    }
    for (const std::size_t at : turns ? std::vector{k - 1, k} : std::vector{k}) {
      plot.curves.back().x.push_back(x[at]);
      plot.curves.back().friction.push_back(contacts[at] > 0 ? mu[at]
                                                             : std::numeric_limits<double>::quiet_NaN());
    }
  }
  plot.rows = {pictured_way(run, static_cast<std::int64_t>(plot.curves.front().x.size()))};
  draw_sliding_plot(path, plot);
}

/// How each figure is drawn, and from which table of the run.
struct Drawing {
  Figure figure;
  std::string_view subject;
  const char* table;
  void (*draw)(const std::string& path, const RunFile& run);
};
constexpr Drawing drawings[] = {{Figure::stress, "stress", nullptr, draw_run_plot},
                                {Figure::search, "pressure", "packing", plot_jamming},
                                {Figure::branches, "pressure", "packing", plot_compression},
                                {Figure::wall, "force", "packing", plot_uniaxial},
                                {Figure::plates, "force", "plates", plot_plates},
                                {Figure::motion, "energy", "motion", plot_motion},
                                {Figure::friction, "friction", "friction", plot_friction}};

const Drawing* find_drawing(Figure figure) {
  for (const Drawing& d : drawings)
    if (d.figure == figure) return &d;
  return nullptr;
}

}  // namespace

std::string_view figure_subject(Figure figure) {
  const Drawing* d = find_drawing(figure);
  return d ? d->subject : "course";
}

void draw_figure(const std::string& path, const RunFile& run) {
  const Case c = run.resolved_case();
  const Drawing* d = find_drawing(experiment_of(c).figure(c));
  if (!d) throw input_error("cannot plot " + run.path(), "it has no course: nothing moved");
  if (d->table) check_rows(run, d->table);
  d->draw(path, run);
}

}  // namespace supple
