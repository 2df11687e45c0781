#include "supple/observe/onset.hpp"

#include <algorithm>
#include <cmath>

#include "supple/core/error.hpp"

namespace supple {

std::optional<Onset> fit_onset(std::span<const double> packing_fraction, std::span<const double> pressure,
                               double highest) {
  if (packing_fraction.size() != pressure.size())
    throw input_error("cannot fit an onset", "there are not as many pressures as packing fractions");
  const auto counts = [&](std::size_t i) { return pressure[i] > 0 && pressure[i] <= highest; };
  int n = 0;
  double p = 0, phi = 0;  // means
  for (std::size_t i = 0; i < pressure.size(); ++i)
    if (counts(i)) ++n, p += pressure[i], phi += packing_fraction[i];
  if (n < 3) return {};
  p /= n;
  phi /= n;
  double pp = 0, pf = 0, ff = 0;
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    if (!counts(i)) continue;
    const double dp = pressure[i] - p, df = packing_fraction[i] - phi;
    pp += dp * dp;
    pf += dp * df;
    ff += df * df;
  }
  if (!(pf > 0)) return {};
  const double ease = pf / pp;  // 1/slope
  const double variance = std::max(0.0, ff - ease * pf) / (n - 2);
  const double ease_error = std::sqrt(variance / pp);
  return Onset{phi - ease * p, 1 / ease, std::sqrt(variance * (1.0 / n + p * p / pp)),
               ease_error / (ease * ease), n};
}

std::optional<Onset> fit_onset(std::span<const double> packing_fraction, std::span<const double> pressure,
                               std::span<const std::uint8_t> rearranged, double highest) {
  if (rearranged.size() != pressure.size() || packing_fraction.size() != pressure.size())
    throw input_error("cannot fit an onset", "there are not as many pressures as packing fractions");
  std::optional<Onset> best;
  double lowest = 0;
  for (std::size_t begin = 0, end; begin < pressure.size(); begin = end) {
    for (end = begin + 1; end < pressure.size() && !rearranged[end];) ++end;
    const auto part = pressure.subspan(begin, end - begin);
    const auto fit = fit_onset(packing_fraction.subspan(begin, end - begin), part, highest);
    const double least = *std::min_element(part.begin(), part.end());
    if (!fit || (best && least >= lowest)) continue;
    best = fit;
    lowest = least;
  }
  return best;
}

}  // namespace supple
