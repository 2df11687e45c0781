/// Where pressure begins: the packing fraction at which a branch of compressed packings would reach zero
/// pressure.
#pragma once
#include <cstdint>
#include <optional>
#include <span>

namespace supple {

/// The line P = slope (phi - packing_fraction) through pressures P and packing fractions phi, with the
/// standard errors of slope and onset.
struct Onset {
  double packing_fraction = 0, slope = 0;
  double packing_fraction_error = 0, slope_error = 0;
  int points = 0;
};

/// The line through the points with 0 < P <= highest. Least squares are of phi = packing_fraction + P/slope,
/// as P is what a run prescribes and phi what it finds. Nothing with less than three points, or where phi
/// does not grow with P. Input error where the lists differ in length.
std::optional<Onset> fit_onset(std::span<const double> packing_fraction, std::span<const double> pressure,
                               double highest);

/// The same for a branch along which the packing may have rearranged; `rearranged` is 1 for a point where it
/// did since the point before. Only points between two rearrangements belong to one packing. Of these parts,
/// the fit is to the one with the lowest pressure for which a fit exists.
std::optional<Onset> fit_onset(std::span<const double> packing_fraction, std::span<const double> pressure,
                               std::span<const std::uint8_t> rearranged, double highest);

}  // namespace supple
