/// Checks of numbers that a caller hands in.
#pragma once
#include <fmt/core.h>

#include <string_view>

#include "supple/core/error.hpp"

namespace supple {

/// Throws an input error unless `holds`: "NAME = VALUE (out of range); give RANGE".
inline void require(bool holds, std::string_view name, double value, std::string_view range) {
  if (!holds)
    throw input_error(fmt::format("{} = {}", name, value), "out of range", fmt::format("give {}", range));
}

}  // namespace supple
