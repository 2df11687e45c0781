/// 1/sqrt(x) by multiplications alone, so that loops over it wait for no divider.
#pragma once
#include <bit>
#include <cstdint>

#include "supple/core/multiply_add.hpp"

namespace supple {

/// 1/sqrt(x) for normal x > 0, with a measured relative error of 5e-16. At 0 the result is a large number y:
/// 0 y is 0, but y^2 overflows, so that an edge without length has no angle at its ends. The first guess
/// halves the exponent [Lomont 2003; for 64 bits Robertson 2012]; two Newton steps and one of third order
/// follow. Relative errors of the four: 3e-2, 2e-3, 5e-6, 2e-16.
inline double inverse_root(double x) {
  const double half = 0.5 * x;
  double y = std::bit_cast<double>(0x5FE6EB50C7B537A9 - (std::bit_cast<std::int64_t>(x) >> 1));
  for (int step = 0; step < 2; ++step) y = multiply_add(y, multiply_add(-(half * y), y, 0.5), y);
  const double r = multiply_add(-(x * y), y, 1.0);
  return multiply_add(y * r, multiply_add(0.375, r, 0.5), y);
}

}  // namespace supple
