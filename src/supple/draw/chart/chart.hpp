/// Charts for papers: columns of stacked panels with round ticks, units, and legends outside of the data.
#pragma once
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "supple/core/vec.hpp"
#include "supple/draw/canvas/color.hpp"

namespace supple {

class Canvas;

enum class Marks { line, points };

/// y against x in SI units; values that are not finite leave a gap.
struct ChartSeries {
  std::string label;  ///< in the legend; empty: not there
  std::vector<double> x, y;
  std::vector<double> error = {};  ///< half the length of error bars; empty: none
  Color color = ink;
  Marks marks = Marks::line;
  double width = 1;               ///< of the line, or radius of the points [pt]
  std::vector<double> dash = {};  ///< [pt]; empty: solid
};

/// A logarithmic axis shows numbers above 0, in their unit without a prefix.
enum class Spacing { linear, logarithmic };

/// An axis. Numbers are shown in their unit as shown_unit() says (canvas/ticks.hpp).
struct ChartAxis {
  std::string label, unit;
  std::optional<std::pair<double, double>> range = {};  ///< SI; from the data where not given
  Spacing spacing = Spacing::linear;
};

/// A shaded range of x, named at the top of the panel.
struct ChartBand {
  double from, to;
  std::string label;
  Color color = white;
};

struct ChartPanel {
  ChartAxis x, y;
  std::vector<ChartSeries> series;  ///< later ones lie above
  std::vector<ChartBand> bands = {};
  std::vector<std::string> heading = {};  ///< lines above the panel
  double weight = 1;                      ///< share of the column's height
};

/// Panels above each other that share one x axis, that of the lowest.
struct ChartColumn {
  std::vector<ChartPanel> panels;
  double weight = 1;  ///< share of the chart's width
};

struct Chart {
  std::vector<ChartColumn> columns;
  double width = 504, height = 252;  ///< [pt]; 504: both columns of a journal page
  double dots_per_inch = 300;
  double room_below = 0;  ///< part of the height that is left free under the columns [pt]
  /// Draws what stands there, on the page of the chart, from `top` down [pt]; empty: nothing does.
  std::function<void(Canvas&, double top)> below = {};
};

/// Draws and writes a chart; the ending of `path` chooses png, jpg, svg, pdf or ps. Throws input and file
/// errors.
void draw_chart(const std::string& path, const Chart& chart);

/// The same curve with fewer points. Neighbours that together span less than `resolution` along x or along y
/// are reduced to the ends and the extremes of their run, so that every peak is kept. A point that is not
/// finite ends a run and stays.
std::vector<Vec2> thin(std::span<const Vec2> curve, double resolution);

}  // namespace supple
