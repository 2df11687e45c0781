#include "supple/core/duration.hpp"

#include <fmt/core.h>

#include <cmath>
#include <cstdint>

namespace supple {

std::string describe_seconds(double seconds) {
  if (!(seconds >= 0)) return "unknown";
  constexpr double day = 86400, year = 365.25 * day;
  if (seconds > 1000 * year) return "over 1000 years";
  if (seconds > 2 * year) return fmt::format("{:.0f} years", seconds / year);
  if (seconds > 4 * day) return fmt::format("{:.0f} days", seconds / day);
  if (seconds < 10) return fmt::format("{:.2g} s", seconds);
  const auto s = static_cast<std::int64_t>(std::llround(seconds));
  if (s < 60) return fmt::format("{} s", s);
  if (s < 3600) return fmt::format("{} min {} s", s / 60, s % 60);
  return fmt::format("{} h {} min", s / 3600, s % 3600 / 60);
}

}  // namespace supple
