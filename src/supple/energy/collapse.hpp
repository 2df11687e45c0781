/// How much line tension a polygon bears before it shrinks to a point.
#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "supple/model/shape.hpp"

namespace supple {

/// Least line tension [energy/length] at which a regular polygon with these stiffnesses, preferred area a0
/// and preferred edges l_i shrinks to a point. A polygon of size s has the area s^2 a0 and n edges of length
/// s l, l^2 = 4 a0 tan(pi/n)/n; its angles do not depend on s. From the shape energy [MacKeith 2025, eq.
/// 9.1-9.2]:
///     U(s) = (A/2)(s^2 - 1)^2 + sum (k_l/2)(s l - l_i)^2 + gamma n l s,   A = k_a a0^2,
///     dU/ds = 2 A s^3 - (2 A - K) s - B + gamma n l,   K = n k_l l^2,   B = k_l l sum l_i.
/// An equilibrium s > 0 exists if dU/ds is negative somewhere: at s = 0, which needs B > gamma n l, or where
/// dU/ds is least, s^2 = (2 A - K)/(6 A).
inline double collapsing_tension(const ShapeStiffness& k, double rest_area,
                                 std::span<const double> rest_length) {
  const double n = static_cast<double>(rest_length.size());
  const double l = std::sqrt(4 * rest_area * std::tan(std::numbers::pi / n) / n);
  double rest = 0;
  for (const double x : rest_length) rest += x;
  const double A = k.volume * rest_area * rest_area, K = n * k.facet * l * l, B = k.facet * l * rest;
  const double dip = 2 * A > K ? 2.0 / 3 * (2 * A - K) * std::sqrt((2 * A - K) / (6 * A)) : 0;
  return (B + dip) / (n * l);
}

}  // namespace supple
