/// From a double to a whole number.
#pragma once
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "supple/core/error.hpp"

namespace supple {

/// Doubles count without a gap up to 9e15.
inline constexpr double most_counted = 1e15;

/// The whole number nearest to x. A cast of what an integer cannot hold is undefined, so that is an input
/// error:
/// "`what` would be X; `to_do`".
template <class Integer = std::int64_t>
Integer whole_number(double x, const std::string& what, const std::string& to_do,
                     double most = most_counted) {
  const double largest = std::min(most, static_cast<double>(std::numeric_limits<Integer>::max()));
  const double nearest = std::round(x);
  if (!(std::abs(nearest) <= largest))
    throw input_error(fmt::format("{} would be {:.3g}", what, x), fmt::format("it can be {:.3g}", largest),
                      to_do);
  return static_cast<Integer>(nearest);
}

}  // namespace supple
