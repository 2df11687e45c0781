/// How much of each pixel shapes cover.
#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "supple/core/vec.hpp"

namespace supple {

/// Pixels [left, right) x [top, bottom).
struct PixelArea {
  int left, top, right, bottom;
  int width() const { return right - left; }
  int height() const { return bottom - top; }
  bool empty() const { return right <= left || bottom <= top; }
};

/// Shares of pixels, 255 for all, come in rows with room for a block more behind their end, whose values mean
/// nothing.
inline constexpr int pixel_block = 16;
using RowOfCover = std::function<void(int y, std::uint8_t* cover)>;

/// Calls `row` for each row of the area in turn, with what the closed line goes around at least once: the
/// shares are exact where no two of its edges meet in a pixel.
void cover_ring(std::span<const Vec2> ring, const PixelArea& area, const RowOfCover& row);

/// What lines cover. Across a line, a pixel is taken as a strip of width 1, of which what is within half the
/// line's width counts. Where segments meet, the larger share holds.
class LineCover {
 public:
  explicit LineCover(const PixelArea& area);

  enum class End { flat, round };
  void segment(const Vec2& from, const Vec2& to, double width, End begin, End end);
  /// The parts of an open line that dashes take, one after the other with gaps between, with flat ends. What
  /// is outside the area is passed over.
  void dashes(std::span<const Vec2> line, double width, std::span<const double> dash);

  std::uint8_t* row(int y) {
    return &cover_[static_cast<std::size_t>(y - area_.top) * (area_.width() + pixel_block)];
  }
  /// Pixels [first, second) of the area's row that may be covered.
  std::pair<int, int> touched(int y) const { return touched_[y - area_.top]; }

 private:
  PixelArea area_;
  std::vector<std::uint8_t> cover_;
  std::vector<std::pair<int, int>> touched_;
};

}  // namespace supple
