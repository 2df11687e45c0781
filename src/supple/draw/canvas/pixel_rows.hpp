/// Pixels as they lie in memory.
#pragma once
#include <cstddef>
#include <cstdint>

namespace supple {

/// Pixels 0x..RRGGBB in rows, `stride` of them from row to row; the upper byte means nothing.
struct PixelRows {
  const std::uint32_t* first;
  std::size_t width, height, stride;
};

}  // namespace supple
