/// The overlap of two discs.
#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>

namespace supple {

/// Part of the overlap of two discs that lies on the far side, seen from the disc of radius `own`, of the
/// line through the points where the circles cross: what that disc loses if the two meet in a planar
/// interface [length^2; MacKeith 2025, eq. 9.20]. The two shares add to the overlap, also where one disc
/// holds the other; two equal discs at one place share it in halves. 0 for discs apart.
inline double overlap_share(double own, double other, double distance) {
  if (!(distance < own + other)) return 0;
  if (distance == 0 && own == other) return 0.5 * std::numbers::pi * own * own;
  const double sum = (own - other) * (own + other) / distance;
  const double interface = std::clamp(0.5 * (distance + sum), -own, own);
  const double half_chord = std::sqrt((own - interface) * (own + interface));
  return own * own * std::atan2(half_chord, interface) - interface * half_chord;
}

}  // namespace supple
