/// A small chart for papers: columns of stacked panels with round ticks, units, legends outside of the data.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "supple/core/vec.hpp"
#include "supple/draw/canvas/color.hpp"

namespace supple {

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

/// A logarithmic axis shows what is above 0, in the unit as it is.
enum class Spacing { linear, logarithmic };

/// Numbers are shown in the unit with an SI prefix; "%": times 100; a unit that begins with a digit takes no
/// prefix; without a unit or with a symbol ("k_a a0"), very large and very small numbers are shown with a
/// power of ten.
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

/// Panels above each other with one x axis, that of the lowest.
struct ChartColumn {
  std::vector<ChartPanel> panels;
  double weight = 1;  ///< share of the chart's width
};

struct Chart {
  std::vector<ChartColumn> columns;
  double width = 504, height = 252;  ///< [pt]; 504: both columns of a journal page
  double dots_per_inch = 300;
};

/// Draws and writes a chart; the ending of `path` chooses png, jpg, svg, pdf or ps. Throws input and file
/// errors.
void draw_chart(const std::string& path, const Chart& chart);

/// Fewer points of the same curve: a run of neighbours that spans less than `resolution` along x or along y
/// is reduced to its ends and its extremes, so every peak is kept. A point that is not finite ends a run and
/// stays.
std::vector<Vec2> thin(std::span<const Vec2> curve, double resolution);

}  // namespace supple
