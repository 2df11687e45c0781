#include "supple/draw/canvas/ticks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "supple/draw/canvas/superscript.hpp"

namespace supple {

std::string with_minus_sign(std::string number) {
  if (!number.empty() && number[0] == '-') number.replace(0, 1, "\u2212");
  return number;
}

double round_below(double x) {
  const double power = std::pow(10, std::floor(std::log10(x)));
  const double digits = x / power * (1 + 1e-12);
  return (digits >= 10 ? 10 : digits >= 5 ? 5 : digits >= 2 ? 2 : 1) * power;
}

Ticks nice_ticks(double low, double high, int count) {
  Ticks ticks;
  if (!(high > low) || !std::isfinite(high - low) || count < 1) return {{low}, 1};
  const double rough = (high - low) / count, power = std::pow(10, std::floor(std::log10(rough)));
  const auto misfit = [&](double digits) { return std::abs(std::log(digits * power / rough)); };
  double best = 10;
  for (double digits : {5.0, 2.5, 2.0, 1.0})
    if (misfit(digits) < misfit(best)) best = digits;
  ticks.step = best * power;
  const double slack = 1e-9;  // of a step: an end that is a tick up to rounding counts
  const double first = std::ceil(low / ticks.step - slack), last = std::floor(high / ticks.step + slack);
  for (double k = first; k <= last; ++k) ticks.at.push_back(k * ticks.step + 0.0);
  return ticks;
}

std::string tick_label(double value, double step) {
  const double size = std::max(std::abs(value), step);
  if (size >= 1e6 || step < 1e-5) {
    const int digits = std::clamp(static_cast<int>(std::ceil(std::log10(size / step))) + 2, 4, 15);
    return with_minus_sign(fmt::format("{:.{}g}", value, digits));
  }
  int decimals = 0;
  while (decimals < 6 &&
         std::abs(step * std::pow(10, decimals) - std::round(step * std::pow(10, decimals))) > 1e-6)
    ++decimals;
  return with_minus_sign(fmt::format("{:.{}f}", std::abs(value) < 1e-9 * step ? 0.0 : value, decimals));
}

Prefix si_prefix(double largest) {
  static const std::array<const char*, 17> symbols{"y", "z", "a", "f", "p", "n", "\u00b5", "m", "",
                                                   "k", "M", "G", "T", "P", "E", "Z",      "Y"};
  const double size = std::abs(largest);
  if (!(size > 0) || !std::isfinite(size)) return {};
  const int thousands = std::clamp(static_cast<int>(std::floor(std::log10(size * (1 + 1e-12)) / 3)), -8, 8);
  return {std::pow(1000.0, thousands), symbols[static_cast<std::size_t>(thousands + 8)]};
}

ShownUnit shown_unit(const std::string& unit, double largest) {
  const double size = std::abs(largest);
  if (unit == "%") return {0.01, unit};
  const bool symbols = unit.find('_') != unit.npos;
  if (unit.empty() || symbols) {
    if (!(size > 0) || !std::isfinite(size) || (size >= 1e-2 && size < 1e5)) return {1, unit};
    const int power = static_cast<int>(std::floor(std::log10(size * (1 + 1e-12))));
    return {std::pow(10.0, power), "10" + superscript(power) + (symbols ? "\u00a0" + unit : "")};
  }
  if (std::isdigit(static_cast<unsigned char>(unit[0]))) return {1, unit};
  const Prefix prefix = si_prefix(size);
  return {prefix.factor, prefix.symbol + unit};
}

std::string with_unit(double value, const std::string& unit, Digits digits) {
  const double size = std::abs(value);
  const double digit = size > 0 ? std::pow(10, std::floor(std::log10(size)) - 2) : 1;
  const double rounded = std::round(value / digit) * digit;  // 999.6 carries over to the next prefix
  const Prefix prefix = si_prefix(rounded);
  const double shown = rounded / prefix.factor;
  const int decimals = std::abs(shown) >= 99.95   ? 0
                       : std::abs(shown) >= 9.995 ? 1
                       : std::abs(shown) > 0      ? 2
                                                  : 0;
  const std::string number =
      digits == Digits::fewest ? fmt::format("{:.3g}", shown) : fmt::format("{:.{}f}", shown, decimals);
  return with_minus_sign(number) + "\u00a0" + prefix.symbol + unit;
}

}  // namespace supple
