/// How much tension a polygon or a surface bears before it shrinks to a point.
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

/// The same of a surface [energy/length^2], of which `area` holds the areas a_i that its triangles have where
/// it encloses its preferred volume v0. A surface of size s has the volume s^3 v0 and areas s^2 a_i. From the
/// shape energy, with S = sum a_i,
///     U(s) = (A/2)(s^3 - 1)^2 + sum (k_a/2)(s^2 a_i - a_i0)^2 + gamma s^2 S,   A = k_v v0^2,
///     dU/ds = s (3 A (s^4 - s) + 2 K s^2 - 2 B + 2 gamma S),   K = k_a sum a_i^2,   B = k_a sum a_i a_i0.
/// An equilibrium s > 0 exists if the bracket is negative somewhere; it is least where 3 A (4 s^3 - 1) + 4 K
/// s is 0.
inline double collapsing_tension(const ShapeStiffness& k, double rest_volume, std::span<const double> area,
                                 std::span<const double> rest_area) {
  double S = 0, K = 0, B = 0;
  for (std::size_t i = 0; i < area.size(); ++i) {
    S += area[i];
    K += k.facet * area[i] * area[i];
    B += k.facet * area[i] * rest_area[i];
  }
  const double A = k.volume * rest_volume * rest_volume;
  double low = 0, high = 1;  // the cubic grows with s, and is positive at 1
  for (int halvings = 0; halvings < 60; ++halvings) {
    const double s = 0.5 * (low + high);
    (3 * A * (4 * s * s * s - 1) + 4 * K * s > 0 ? high : low) = s;
  }
  const double s = low, least = 3 * A * (s * s * s * s - s) + 2 * K * s * s;
  return (2 * B - least) / (2 * S);
}

}  // namespace supple
