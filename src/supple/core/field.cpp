#include "supple/core/field.hpp"

#include <fmt/format.h>

namespace supple {

std::string describe(const Range& range) {
  const bool low = std::isfinite(range.low), high = std::isfinite(range.high);
  const std::string above = fmt::format("{} {}",
                                        range.open_low ? "above"
                                        : high         ? "from"
                                                       : "at least",
                                        range.low);
  const bool closed = !range.open_low && !range.open_high;
  const std::string_view until = range.open_high ? ", below"
                                 : closed && low ? " to"
                                 : low           ? ", at most"
                                                 : "at most";
  if (!high) return low ? above : "";
  return fmt::format("{}{} {}", low ? above : "", until, range.high);
}

}  // namespace supple
