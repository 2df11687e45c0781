/// One axis of a chart: its range, its ticks, and where a number lies on it.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "supple/draw/chart/chart.hpp"

namespace supple {

/// A tick of an axis.
struct AxisTick {
  double at;          ///< SI
  std::string label;  ///< empty: a small tick
};

struct AxisScale {
  double low = 0, high = 1;  ///< SI
  Spacing spacing = Spacing::linear;
  std::string title;  ///< label and unit
  std::vector<AxisTick> ticks;

  /// Place of a value on the axis, 0 at `low` and 1 at `high`; not finite where a logarithmic axis cannot
  /// show it.
  double share(double value) const;
  /// Moves the two ends outward, by these shares of the length of the axis.
  void widen(double below, double above);
  /// Chooses about `count` ticks, and the unit for the title.
  void set_ticks(const ChartAxis& axis, int count);
};

/// The scale of an axis over these values (least, largest), or over the range of the axis if it has one,
/// without ticks. Where all values are the same it gets some length.
AxisScale scale_of_axis(const ChartAxis& axis, std::pair<double, double> values);

/// Whether an axis can show this number: finite, and above 0 where it is logarithmic.
bool can_show(Spacing spacing, double value);

}  // namespace supple
