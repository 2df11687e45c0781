#include "supple/solve/line_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace supple {
namespace {

constexpr double decrease = 0.1, curvature = 0.9;  // delta and sigma of Hager and Zhang
constexpr double rounding = 1e-6;                  // of the energy: their epsilon
constexpr int most_trials = 25;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Minimum between `low`, where the slope is negative, and `high`, where it is positive or unknown.
double inside(double low, double low_slope, double high, double high_slope, int trial) {
  const double width = high - low;
  if (std::isnan(high_slope)) return low + (low > 0 ? 0.5 : 0.2) * width;
  if (trial % 4 == 3) return low + 0.5 * width;  // the secant may creep
  const double secant = low - low_slope * width / (high_slope - low_slope);
  return std::clamp(secant, low + 0.05 * width, high - 0.05 * width);
}

/// Where the slope, extrapolated, would vanish; well beyond `at`.
double beyond(double before, double before_slope, double at, double slope) {
  const double bend = (slope - before_slope) / (at - before);
  const double secant = bend > 0 ? at - slope / bend : 10 * at;
  return std::clamp(secant, 1.5 * at, 10 * at);
}

}  // namespace

double line_search(Descent& descent, std::span<const double> direction, double first, double most) {
  const std::vector<double> origin(descent.x.begin(), descent.x.end());
  const double energy = descent.report.energy, slope = dot(descent.gradient, direction);
  const auto evaluate = [&](double step) {
    for (std::size_t i = 0; i < origin.size(); ++i) descent.x[i] = origin[i] + step * direction[i];
    return descent.evaluate();
  };
  double low = 0, low_slope = slope, high = 0, high_slope = unknown;  // high = 0: not bracketed yet
  double step = std::min(first, most), last = 0;
  for (int trial = 0; trial < most_trials && slope < 0; ++trial) {
    const bool finite = evaluate(last = step);
    const double now = finite ? dot(descent.gradient, direction) : unknown;
    const double rise = descent.report.energy - energy;
    const bool level = finite && rise <= rounding * std::abs(energy);
    const bool lower = finite && rise <= decrease * step * slope;
    if ((lower || (level && now <= (2 * decrease - 1) * slope)) && now >= curvature * slope) return step;
    if (level && now < 0) {
      if (step >= most) return step;
      const double next = beyond(low, low_slope, step, now);
      low = step;
      low_slope = now;
      if (high == 0) {
        step = std::min(next, most);
        continue;
      }
    } else {
      high = step;
      high_slope = finite && now >= 0 ? now : unknown;
    }
    if (high - low < 1e-10 * high) break;
    step = inside(low, low_slope, high, high_slope, trial);
  }
  if (last != low || slope >= 0) evaluate(low);
  return low;
}

}  // namespace supple
