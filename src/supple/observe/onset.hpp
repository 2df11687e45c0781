/// Where pressure begins: the packing fraction at which a branch of compressed packings would lose it.
#pragma once
#include <cstdint>
#include <optional>
#include <span>

namespace supple {

/// P = slope (phi - packing_fraction), with standard errors of both.
struct Onset {
  double packing_fraction = 0, slope = 0;
  double packing_fraction_error = 0, slope_error = 0;
  int points = 0;
};

/// The line through the points of 0 < P <= highest, by least squares of phi = packing_fraction + P/slope: the
/// pressure is what was asked for, the packing fraction what came of it. None with less than three points, or
/// where phi does not grow with P.
std::optional<Onset> fit_onset(std::span<const double> packing_fraction, std::span<const double> pressure,
                               double highest);

/// The same of a branch along which the packing may have rearranged: `rearranged` says so of the way from the
/// point before to each. Only points between two rearrangements are of one packing: of these parts the one of
/// the lowest pressures that can be fitted.
std::optional<Onset> fit_onset(std::span<const double> packing_fraction, std::span<const double> pressure,
                               std::span<const std::uint8_t> rearranged, double highest);

}  // namespace supple
