#include "supple/draw/chart/uncertainty.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace supple {

namespace {

/// Power of ten of the first digit once x > 0 is rounded to two: 1 for 9.96 (10), 0 for 9.94 (9.9).
int first_digit(double x) {
  const int power = static_cast<int>(std::floor(std::log10(x)));
  return x / std::pow(10, power) >= 9.95 ? power + 1 : power;
}

}  // namespace

std::string value_with_error(double value, double error) {
  if (!(error >= 0) || !std::isfinite(value)) return fmt::format("{:.5g}", value);
  if (error == 0 || !std::isfinite(error)) return fmt::format("{:.5g} \u00b1 {}", value, error);
  const double size = std::max(std::abs(value), error);
  const int largest = first_digit(size), last = std::max(first_digit(error) - 1, largest - 11);
  if (size < 1e-3 || size >= 1e7)
    return fmt::format("{:.{}e} \u00b1 {:.1e}", value, std::max(0, largest - last), error);
  if (last >= 0) {
    const double unit = std::pow(10, last);
    return fmt::format("{:.0f} \u00b1 {:.0f}", std::round(value / unit) * unit,
                       std::round(error / unit) * unit);
  }
  return fmt::format("{:.{}f} \u00b1 {:.{}f}", value, -last, error, -last);
}

}  // namespace supple
