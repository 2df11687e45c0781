#include "supple/observe/power_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "supple/core/error.hpp"

namespace supple {

namespace {

/// Ends of ranges are powers and quotients of the same numbers as the data: they agree to rounding only.
constexpr double slack = 1e-9;

bool can_count(double x, double y) { return x > 0 && y > 0 && std::isfinite(x) && std::isfinite(y); }

void check_lengths(std::span<const double> x, std::span<const double> y) {
  if (x.size() != y.size())
    throw input_error("cannot fit a power law", "there are not as many values of y as of x");
}

}  // namespace

std::optional<PowerLaw> fit_power_law(std::span<const double> x, std::span<const double> y, double from,
                                      double to) {
  check_lengths(x, y);
  const auto counts = [&](std::size_t k) {
    return can_count(x[k], y[k]) && x[k] >= from * (1 - slack) && x[k] <= to * (1 + slack);
  };
  PowerLaw law{.from = std::numeric_limits<double>::infinity()};
  double mean_x = 0, mean_y = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (!counts(k)) continue;
    ++law.points;
    mean_x += std::log(x[k]);
    mean_y += std::log(y[k]);
    law.from = std::min(law.from, x[k]);
    law.to = std::max(law.to, x[k]);
  }
  if (law.points < 3) return {};
  mean_x /= law.points;
  mean_y /= law.points;
  double xx = 0, xy = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (!counts(k)) continue;
    const double dx = std::log(x[k]) - mean_x;
    xx += dx * dx;
    xy += dx * (std::log(y[k]) - mean_y);
  }
  if (!(xx > 0)) return {};
  law.exponent = xy / xx;
  law.factor = std::exp(mean_y - law.exponent * mean_x);
  double scatter = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (!counts(k)) continue;
    const double off = std::log(y[k]) - mean_y - law.exponent * (std::log(x[k]) - mean_x);
    scatter += off * off;
  }
  law.error = std::sqrt(scatter / (law.points - 2) / xx);
  return law;
}

std::vector<std::optional<PowerLaw>> local_power_laws(std::span<const double> x, std::span<const double> y,
                                                      double decades) {
  check_lengths(x, y);
  std::vector<std::optional<PowerLaw>> laws(x.size());
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (std::size_t k = 0; k < x.size(); ++k)
    if (can_count(x[k], y[k])) least = std::min(least, x[k]), most = std::max(most, x[k]);
  const double width = std::pow(10, decades), half = std::sqrt(width);
  if (!(most >= least * width * (1 - slack))) return laws;
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (!can_count(x[k], y[k])) continue;
    const double from = std::clamp(x[k] / half, least, std::max(least, most / width));
    laws[k] = fit_power_law(x, y, from, from * width);
  }
  return laws;
}

}  // namespace supple
