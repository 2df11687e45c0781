#include "supple/io/run/run_pictures.hpp"

#include <fmt/format.h>

#include "supple/core/error.hpp"
#include "supple/draw/chart/plot.hpp"
#include "supple/experiment/experiments.hpp"

namespace supple {

namespace {

constexpr const char* stress_table = "stress";

Protocol protocol_of(const RunFile& run) {
  const auto constant = [&](const char* name) { return run.value("constants", name); };
  return {constant("frequency"), constant("strain_amplitude"), constant("pre_periods"), constant("periods"),
          constant("post_periods")};
}

/// A stress of the table: its name in columns and results, and its name in the legend.
struct StressName {
  std::string key, legend;
};

/// Those that the figure of a run shows and that it has.
std::vector<StressName> drawn_stresses(const RunFile& run, const Case& c) {
  std::vector<StressName> there;
  for (const auto& [key, legend] : experiment_of(c).matter->curves)
    for (const Column& column : run.columns(stress_table))
      if (column.name == fmt::format("shear_stress_{}", key))
        there.push_back({std::string(key), std::string(legend)});
  return there;
}

/// Series and moduli as the run holds them. It does not hold offset and drift: they are those of a fit to the
/// series, around which the cycles lie, whatever the stress was at rest.
StressEstimate estimate(const RunFile& run, const StressName& of, const std::vector<double>& time,
                        const Protocol& protocol) {
  const std::string name = of.key;
  StressEstimate e;
  e.name = of.legend;
  e.stress = run.column(stress_table, "shear_stress_" + name);
  for (const RunValue& v : run.values("results")) {
    if (v.name.name == "storage_modulus_" + name) e.storage = v.value, e.storage_error = v.error;
    if (v.name.name == "loss_modulus_" + name) e.loss = v.value, e.loss_error = v.error;
  }
  const Demodulation fit = demodulate(time, e.stress, protocol);
  e.offset = fit.offset;
  e.drift = fit.drift;
  return e;
}

/// (xx + yy)/2 of the virial of bodies, or of the overall tensor; empty where the run holds no tensors.
std::vector<double> pressure(const RunFile& run) {
  for (const Column& c : run.columns(stress_table)) {
    if (c.name == "pressure") return run.column(stress_table, c.name);
    if (c.name != "overall_00") continue;
    std::vector<double> p = run.column(stress_table, "overall_00");
    const std::vector<double> yy = run.column(stress_table, "overall_11");
    for (std::size_t i = 0; i < p.size(); ++i) p[i] = 0.5 * (p[i] + yy[i]);
    return p;
  }
  return {};
}

}  // namespace

void draw_run_plot(const std::string& path, const RunFile& run) {
  if (!run.has_table(stress_table))
    throw input_error("cannot plot " + run.path(), "the run has no stress series");
  const std::vector<double> time = run.column(stress_table, "t"), strain = run.column(stress_table, "strain");
  const Case c = run.resolved_case();
  const std::vector<StressName> names = drawn_stresses(run, c);
  if (!run.find_value("results", "storage_modulus_virial")) {
    DynamicsPlot plot{time, strain, {}, pressure(run)};
    for (const StressName& s : names)
      plot.stresses.push_back({s.legend, run.column(stress_table, std::string("shear_stress_") + s.key)});
    plot_dynamics(path, plot);
    return;
  }
  const Protocol protocol = protocol_of(run);
  const double scale = c.output.relative_y_scale_force * c.material.young_modulus;
  OscillatoryPlot plot{time, strain, {}, protocol, scale > 0 ? std::optional(scale) : std::nullopt};
  for (const Column& column : run.columns(stress_table)) {
    if (column.name == "t") plot.time_unit = column.unit;
    if (column.name == "shear_stress_virial") plot.stress_unit = column.unit;
  }
  for (const StressName& s : names) plot.stresses.push_back(estimate(run, s, time, protocol));
  plot_oscillatory(path, plot);
}

}  // namespace supple
