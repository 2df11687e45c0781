#include "supple/draw/chart/chart_scale.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "supple/draw/canvas/superscript.hpp"
#include "supple/draw/canvas/ticks.hpp"

namespace supple {

namespace {

constexpr double slack = 1e-9;  // of a decade: an end that is a power of ten up to rounding counts

std::vector<AxisTick> linear_ticks(double low, double high, double factor, int count) {
  Ticks ticks;
  do ticks = nice_ticks(low / factor, high / factor, count);
  while (ticks.at.size() < 3 && ++count < 9);  // less than three tell little
  std::vector<AxisTick> out;
  for (const double at : ticks.at) out.push_back({at * factor, tick_label(at, ticks.step)});
  return out;
}

/// A power of ten, plain where all ticks are plain.
std::string decade_label(int power, bool plain) {
  return plain ? short_number(std::pow(10.0, power)) : "10" + superscript(power);
}

/// Labels at powers of ten, or at 1, 2 and 5 times one where there are less than two; small ticks between.
std::vector<AxisTick> decade_ticks(double low, double high, int count) {
  const int first = static_cast<int>(std::ceil(std::log10(low) - slack));
  const int last = static_cast<int>(std::floor(std::log10(high) + slack));
  const int decades = last - first + 1, stride = std::max(1, (decades + count) / (count + 1));
  const bool plain = low >= 1e-3 && high < 1e4;
  std::vector<AxisTick> ticks;
  for (int power = first - 1; power <= last; ++power)
    for (int digit = 1; digit <= (stride == 1 ? 9 : 1); ++digit) {
      const double at = digit * std::pow(10.0, power);
      if (at < low * (1 - slack) || at > high * (1 + slack)) continue;
      std::string label;
      if (digit == 1 && (power - first) % stride == 0) label = decade_label(power, plain);
      if (decades < 2 && (digit == 2 || digit == 5)) label = short_number(at);
      ticks.push_back({at, label});
    }
  return ticks;
}

}  // namespace

double AxisScale::share(double value) const {
  if (spacing == Spacing::linear) return (value - low) / (high - low);
  return std::log(value / low) / std::log(high / low);
}

void AxisScale::widen(double below, double above) {
  if (spacing == Spacing::linear) {
    const double span = high - low;
    low -= below * span;
    high += above * span;
  } else {
    const double ratio = high / low;
    low *= std::pow(ratio, -below);
    high *= std::pow(ratio, above);
  }
}

void AxisScale::set_ticks(const ChartAxis& axis, int count) {
  ShownUnit shown = shown_unit(axis.unit, std::max(std::abs(low), std::abs(high)));
  if (spacing == Spacing::logarithmic) shown = {1, axis.unit};
  title = axis.label + (shown.text.empty() ? "" : " (" + shown.text + ")");
  ticks = spacing == Spacing::linear ? linear_ticks(low, high, shown.factor, count)
                                     : decade_ticks(low, high, count);
}

AxisScale scale_of_axis(const ChartAxis& axis, std::pair<double, double> values) {
  auto [low, high] = axis.range.value_or(values);
  if (axis.spacing == Spacing::logarithmic) {
    if (!(low > 0 && high >= low)) std::tie(low, high) = std::pair(0.1, 1.0);
    if (high == low) std::tie(low, high) = std::pair(low / 2, high * 2);
  } else if (!(low <= high)) {
    std::tie(low, high) = std::pair(0.0, 1.0);
  } else if (low == high) {
    const double half = low == 0 ? 1 : 0.1 * std::abs(low);
    std::tie(low, high) = std::pair(low - half, high + half);
  }
  return {low, high, axis.spacing, axis.label, {}};
}

bool can_show(Spacing spacing, double value) {
  return std::isfinite(value) && (spacing == Spacing::linear || value > 0);
}

}  // namespace supple
