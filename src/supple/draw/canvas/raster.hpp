/// Shapes as pixels.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "supple/core/vec.hpp"
#include "supple/draw/canvas/color.hpp"
#include "supple/draw/canvas/cover.hpp"

namespace supple {

/// Draws on pixels 0x..RRGGBB that others keep. Lengths are in pixels, x to the right and y downward from the
/// upper left corner. A pixel takes as much of the colour as the shape covers of it. Of points that are not
/// finite nothing is drawn.
class Raster {
 public:
  Raster(std::uint32_t* pixels, int width, int height, std::size_t stride);

  /// Fills what the closed line goes around at least once.
  void fill(std::span<const Vec2> ring, Color color);

  struct Line {
    double width;
    std::span<const double> dash;  ///< lengths of dashes and gaps; empty: solid
  };
  enum class Ends { open, joined };
  /// Draws a line with round corners; a solid one has round ends, dashes have flat ones.
  void stroke(std::span<const Vec2> line, Ends ends, const Line& style, Color color);

  enum class Side { inside, outside };
  /// From here to unclip(), only what is drawn on this side of the ring shows, in addition to earlier rings.
  void clip(std::span<const Vec2> ring, Side side);
  void unclip();

 private:
  using Pixel = std::uint32_t;
  struct Clip {
    PixelArea area;
    std::vector<std::uint8_t> mask;  ///< of each of its pixels; empty: all of them
    const std::uint8_t* mask_at(int x, int y) const {
      return &mask[static_cast<std::size_t>(y - area.top) * area.width() + (x - area.left)];
    }
    std::uint8_t* mask_at(int x, int y) {
      return &mask[static_cast<std::size_t>(y - area.top) * area.width() + (x - area.left)];
    }
  };

  PixelArea shown(const Vec2& low, const Vec2& high) const;
  void paint(int y, const PixelArea& area, std::pair<int, int> part, std::uint8_t* cover, Pixel color);

  Pixel* pixels_;
  int width_, height_;
  std::size_t stride_;
  std::vector<Clip> clips_;
};

}  // namespace supple
