/// Overlaps of discs and of spheres.
#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>

#include "supple/core/vec.hpp"

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

/// Volume of what two spheres have in common, two caps that meet in the plane through the circle where the
/// spheres cross, or the smaller sphere [length^3]. 0 for spheres apart.
inline double sphere_overlap(double a, double b, double distance) {
  if (!(distance < a + b)) return 0;
  const double least = std::min(a, b);
  if (distance <= std::abs(a - b)) return 4 * std::numbers::pi / 3 * least * least * least;
  const double depth = a + b - distance, difference = a - b;
  return std::numbers::pi * depth * depth *
         (distance * distance + 2 * distance * (a + b) - 3 * difference * difference) / (12 * distance);
}

/// Whether three discs, each of which overlaps the others, have a point in common.
inline bool discs_have_common_point(const Vec2 (&centre)[3], const double (&radius)[3]) {
  for (int k = 0; k < 3; ++k) {
    const int second = (k + 1) % 3, third = (k + 2) % 3;
    const Vec2 r = centre[second] - centre[k];
    const double distance = norm(r), a = radius[k], b = radius[second];
    if (distance <= std::abs(a - b)) return true;  // one lies in the other
    const double along = 0.5 * (distance + (a - b) * (a + b) / distance);
    const double height = std::sqrt(std::max(0.0, (a - along) * (a + along)));
    const Vec2 direction = (1 / distance) * r, foot = centre[k] + along * direction;
    for (const double side : {-height, height})
      if (norm(foot + side * turned_left(direction) - centre[third]) < radius[third]) return true;
  }
  return false;
}

/// The same of spheres: by symmetry they have a common point in the plane of their centres if they have any.
inline bool spheres_have_common_point(const Vec3 (&centre)[3], const double (&radius)[3]) {
  const Vec3 first = centre[1] - centre[0], second = centre[2] - centre[0];
  const double length = norm(first), along = length > 0 ? dot(second, first) / length : 0;
  const double across = std::sqrt(std::max(0.0, dot(second, second) - along * along));
  return discs_have_common_point({{0, 0}, {length, 0}, {along, across}}, radius);
}

}  // namespace supple
