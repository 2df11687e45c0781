/// The overlap of two discs.
#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>

namespace supple {

/// Area that the disc of radius `own` loses to the other one if the two meet in a straight interface, the
/// line through the points where the circles cross: the segment of the disc beyond that line [length^2;
/// MacKeith 2025, eq. 9.20]. The shares of the two discs add to their overlap, also where one disc holds the
/// other; two equal discs at one place have half of it each. 0 for discs apart.
inline double overlap_share(double own, double other, double distance) {
  if (!(distance < own + other)) return 0;
  if (distance == 0 && own == other) return 0.5 * std::numbers::pi * own * own;
  const double sum = (own - other) * (own + other) / distance;
  const double interface = std::clamp(0.5 * (distance + sum), -own, own);
  const double half_chord = std::sqrt((own - interface) * (own + interface));
  return own * own * std::atan2(half_chord, interface) - interface * half_chord;
}

}  // namespace supple
