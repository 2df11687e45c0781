/// On which side of a line or of a plane a point lies, where rounding leaves no doubt.
#pragma once
#include <cmath>

#include "supple/core/vec.hpp"

namespace supple {

/// Sign of a sum of products that was computed with an error of at most `units` half units in the last place
/// of `magnitude`, the sum of the absolute products; 0 where this error could have made it.
inline int certain_sign(double sum, double magnitude, double units) {
  const double error = units * 0x1p-53 * magnitude;
  return (sum > error) - (sum < -error);
}

/// 1 where p is on the left of the line from a to b, -1 on the right, 0 on it: within a few roundings (4e-16
/// of the products of differences of coordinates; bound 3 + 16 eps of Shewchuk 1997). Exactly 0 where p is a
/// or b.
inline int side_of_line(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 u = a - p, v = b - p;
  const double left = u[0] * v[1], right = u[1] * v[0];
  return certain_sign(left - right, std::abs(left) + std::abs(right), 4);
}

/// 1 where p is on the side of the plane through a, b, c from which these turn counter-clockwise, -1 on the
/// other, 0 in it: within a few roundings (9e-16 of the products of differences of coordinates; bound
/// 7 + 56 eps of Shewchuk 1997). Exactly 0 where p is one of the three.
inline int side_of_plane(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 u = a - p, v = b - p, w = c - p;
  double sum = 0, magnitude = 0;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const double left = v[i] * w[j], right = v[j] * w[i];
    sum += u[k] * (left - right);
    magnitude += std::abs(u[k]) * (std::abs(left) + std::abs(right));
  }
  return certain_sign(-sum, magnitude, 8);
}

}  // namespace supple
