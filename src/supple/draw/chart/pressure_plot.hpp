/// Pressure against packing fraction.
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace supple {

/// The line pressure = slope (packing fraction - onset).
struct PressureFit {
  double onset, slope;
};

/// One compression or decompression, in its order.
struct PressureSeries {
  std::string label;  ///< in the legend; empty: not there
  std::vector<double> packing_fraction, pressure;
  std::optional<PressureFit> fit = {};  ///< drawn as a line; its onset stands in the legend
};

/// linear: P against phi. log_pressure: log P against phi. log_excess: log P against log (phi - onset), for
/// which every series needs its fit. Points that a logarithmic axis cannot show are left out.
enum class PressureAxes { linear, log_pressure, log_excess };

struct PressurePlotOptions {
  PressureAxes axes = PressureAxes::linear;
  std::string pressure_unit = {};     ///< empty: dimensionless
  std::optional<double> target = {};  ///< a pressure to mark by a dashed line
  std::string heading = {};           ///< above the chart
  double width = 300, height = 240;   ///< [pt]
};

/// Draws points, joined by a faint line in the order of the series, and the fits. The ending of `path`
/// chooses png, jpg, svg, pdf or ps. Throws input and file errors.
void draw_pressure_plot(const std::string& path, const std::vector<PressureSeries>& series,
                        const PressurePlotOptions& options = {});

}  // namespace supple
