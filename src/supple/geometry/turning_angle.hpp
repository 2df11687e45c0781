/// The angle between two vectors without libm: free of branches, so that loops over it become vector instructions.
#pragma once
#include <cmath>

namespace supple {

/// atan2(sine, cosine), where hypot(sine, cosine) = product (of the two lengths). Half of the angle has the tangent
/// |sine|/(product + cosine); it is reduced to at most tan(pi/8), where a polynomial of degree 23 serves. Measured error:
/// 5e-16 up to 1.6 rad, 5e-15 up to 3.1; towards pi product + cosine cancels (1e-9 at pi - 1e-7: a spike, as no particle has).
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
  const double low_part = (1.0 - 0.3333333333333312 * z) + (0.19999999999940893 - 0.14285714279250245 * z) * z2;
  const double middle =
      (0.11111110744919658 - 0.09090896809064027 * z) + (0.07692045330902225 - 0.06662951813629191 * z) * z2;
  const double high_part =
      (0.05846878297330872 - 0.05035102456601552 * z) + (0.03796525745386593 - 0.017805397205419446 * z) * z2;
  const double atan = t * (low_part + z4 * (middle + z4 * high_part));
  const double folds = folded ? quarter : 0, sign = steep ? -1 : 1;
  const double half = (steep ? 2 * quarter : 0) + sign * (folds + atan);
  return std::copysign(2 * half, sine);
}

}  // namespace supple
