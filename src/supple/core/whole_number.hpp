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

/// The largest number of anything; doubles hold every whole number up to 9e15.
inline constexpr double most_counted = 1e15;

/// The whole number nearest to x. Casting a double that the integer cannot hold is undefined, so it is an
/// input error, "`what` would be X (it can be MOST); `to_do`", where |x| is above `most` or what Integer
/// holds, or x is no number.
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
