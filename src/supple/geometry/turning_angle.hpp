/// The angle between two vectors without libm: free of branches, so that loops over it become vector
/// instructions.
#pragma once
#include <cmath>

#include "supple/core/multiply_add.hpp"

namespace supple {

/// The angle from one vector to another [radian], atan2(sine, cosine): `sine` is their cross product,
/// `cosine` their dot product and `product` the product of their lengths, hypot(sine, cosine). Half of the
/// angle has the tangent |sine|/(product + cosine), reduced to at most tan(pi/8), where a polynomial of
/// degree 23 is enough. Measured error: 5e-16 up to 1.6 rad, 5e-15 up to 3.1. Near pi product + cosine
/// cancels (error 1e-9 at pi - 1e-7: a spike sharper than any particle has).
inline double turning_angle(double sine, double cosine, double product) {
  constexpr double quarter = 0.78539816339744830961, tan_eighth = 0.41421356237309504880;
  const double up = std::abs(sine), down = product + cosine;
  const bool steep = up > down;
  const double low = steep ? down : up, high = steep ? up : down;
  const bool folded = low > tan_eighth * high;
  const double t = (folded ? low - high : low) / (folded ? low + high : high);
  const double z = t * t;
  // Chebyshev interpolation of atan(t)/t in z on |t| <= tan(pi/8): error 2e-17.
  // In three parts, for short chains of operations.
  const double z2 = z * z, z4 = z2 * z2;
  const double low_part =
      (1.0 - 0.3333333333333312 * z) + (0.19999999999940893 - 0.14285714279250245 * z) * z2;
  const double middle =
      (0.11111110744919658 - 0.09090896809064027 * z) + (0.07692045330902225 - 0.06662951813629191 * z) * z2;
  const double high_part =
      (0.05846878297330872 - 0.05035102456601552 * z) + (0.03796525745386593 - 0.017805397205419446 * z) * z2;
  const double atan = t * (low_part + z4 * (middle + z4 * high_part));
  const double folds = folded ? quarter : 0, sign = steep ? -1 : 1;
  const double half = (steep ? 2 * quarter : 0) + sign * (folds + atan);
  return std::copysign(2 * half, sine);
}

/// Least cosine that blunt_turning_angle is right for: that of 60 degrees.
inline constexpr double least_blunt_cosine = 0.5;

/// The same for two unit vectors at no more than 60 degrees, in half the time: theta = sin(theta) g(1 -
/// cos(theta)) with the smooth function g(w) = acos(1 - w)/sqrt(w (2 - w)), a polynomial without division.
/// Measured error: 3e-16.
inline double blunt_turning_angle(double sine, double cosine) {
  const double w = 1 - cosine, w2 = w * w, w4 = w2 * w2;
  // Chebyshev interpolation on 0 <= w <= 1/2: relative error 5e-17. In parts, for short chains of operations.
  const double a = multiply_add(multiply_add(0.057142857358995415, w, 0.13333333332908753), w2,
                                multiply_add(0.3333333333333661, w, 1.0));
  const double b = multiply_add(multiply_add(0.002492752247049941, w, 0.005327082707021123), w2,
                                multiply_add(0.011544102029105635, w, 0.025396819672730327));
  const double c = multiply_add(multiply_add(0.0004773708779307974, w, 3.431558141457508e-05), w2,
                                multiply_add(0.000654516722174787, w, 0.0011398460185199327));
  const double d = multiply_add(0.00018967032401237104, w, -0.00027179837089317155);
  return sine * multiply_add(multiply_add(d, w4, c), w4 * w4, multiply_add(b, w4, a));
}

}  // namespace supple
