#include "supple/io/run/body_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "supple/core/error.hpp"
#include "supple/draw/chart/chart.hpp"
#include "supple/draw/chart/pressure_plot.hpp"
#include "supple/io/run/run_pictures.hpp"

namespace supple {

namespace {

std::string unit_of(const RunFile& run, const std::string& table, const std::string& name) {
  for (const Column& column : run.columns(table))
    if (column.name == name) return column.unit;
  return "";
}

void check_rows(const RunFile& run, const std::string& table) {
  if (!run.has_table(table) || run.rows(table) < 2)
    throw input_error("cannot plot " + run.path(),
                      "it holds less than two rows of its table '" + table + "'");
}

/// The search, but for pressures far below the wanted one: they are zero, or what the minimiser left.
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
  if (run.experiment() == "slump")
    column.panels.push_back(
        panel({"Length", ""}, {{"front", "front of the heap"}, {"top", "top of the heap"}}));
  else column.panels.push_back(panel({"Pressure", unit_of(run, "motion", "pressure")}, {{"pressure", ""}}));
  draw_chart(path, {{column}, 340, 300});
}

}  // namespace

std::string body_plot_subject(const Case& c) {
  if (c.general.experiment == "oscillatory_shear") return "stress";
  if (c.general.experiment == "jamming" || c.general.experiment == "compression") return "pressure";
  return c.general.experiment == "uniaxial_compression" ? "force" : "energy";
}

void draw_body_plot(const std::string& path, const RunFile& run) {
  const std::string experiment = run.experiment();
  if (experiment == "oscillatory_shear") return draw_run_plot(path, run);
  const bool moves = experiment == "dynamics" || experiment == "slump";
  check_rows(run, moves ? "motion" : "packing");
  if (moves) plot_motion(path, run);
  else if (experiment == "jamming") plot_jamming(path, run);
  else if (experiment == "compression") plot_compression(path, run);
  else plot_uniaxial(path, run);
}

}  // namespace supple
