#include "supple/draw/solid/solid_image.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "supple/core/error.hpp"
#include "supple/core/parallel.hpp"
#include "supple/draw/solid/light.hpp"
#include "supple/draw/solid/on_screen.hpp"
#include "supple/draw/solid/sample_tile.hpp"

namespace supple {

namespace {

constexpr int samples = 4;       // of a pixel, along x and along y
constexpr int tile_pixels = 32;  // along x and along y: what is known of its samples stays in the cache

/// The shapes that may show in each tile, in their order.
struct Bins {
  int across, down;
  std::vector<std::size_t> begin;
  std::vector<std::int32_t> shape;

  /// `rim`: samples around a tile that it needs as well.
  Bins(const OnScreen& screen, const SolidWindow& window, int rim)
      : across((window.width + tile_pixels - 1) / tile_pixels),
        down((window.height + tile_pixels - 1) / tile_pixels),
        begin(static_cast<std::size_t>(across) * down + 1, 0) {
    const auto each = [&](auto&& visit) {
      for (const std::int32_t s : screen.in_order()) {
        const Bounds b = screen.bounds(s).grown(rim + 1);
        const auto tile = [&](double x, int count) {
          return static_cast<int>(std::clamp(std::floor(x / (tile_pixels * samples)), -1.0, 1.0 * count));
        };
        for (int j = std::max(tile(b.low[1], down), 0); j <= std::min(tile(b.high[1], down), down - 1); ++j)
          for (int i = std::max(tile(b.low[0], across), 0);
               i <= std::min(tile(b.high[0], across), across - 1); ++i)
            visit(static_cast<std::size_t>(j) * across + i, s);
      }
    };
    each([&](std::size_t tile, std::int32_t) { ++begin[tile + 1]; });
    for (std::size_t k = 1; k < begin.size(); ++k) begin[k] += begin[k - 1];
    shape.resize(begin.back());
    std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
    each([&](std::size_t tile, std::int32_t s) { shape[next[tile]++] = s; });
  }
  std::span<const std::int32_t> shapes(int column, int row) const {
    const std::size_t tile = static_cast<std::size_t>(row) * across + column;
    return std::span(shape).subspan(begin[tile], begin[tile + 1] - begin[tile]);
  }
};

struct Rgb {
  float red = 0, green = 0, blue = 0;
  void add(const Color& c, double share) {
    red += static_cast<float>(share * c.red);
    green += static_cast<float>(share * c.green);
    blue += static_cast<float>(share * c.blue);
  }
};

std::uint32_t packed(const Rgb& sum) {
  const auto byte = [](float x) {
    return static_cast<std::uint32_t>(std::clamp(255 * x / (samples * samples) + 0.5f, 0.0f, 255.0f));
  };
  return byte(sum.red) << 16 | byte(sum.green) << 8 | byte(sum.blue);
}

/// Colours the samples of tiles.
class TilePainter {
 public:
  TilePainter(const OnScreen& screen, std::span<const Color> color, const SolidStyle& style,
              const SampleTile& tile)
      : screen_(screen),
        color_(color),
        style_(style),
        tile_(tile),
        is_outline_(static_cast<std::size_t>(tile.size()) * tile.size()),
        owner_(is_outline_.size()) {}

  /// To be called when the tile shows something else.
  void begin() { mark_outlines(); }

  /// Paints pixel p, whose first sample is in column i of row j.
  void paint(int i, int j, SolidImage& image, std::size_t p) {
    int covered = 0;
    for (int y = j; y < j + samples; ++y)
      for (int x = i; x < i + samples; ++x) covered += tile_.shape(x, y) >= 0;
    image.covered[p] = static_cast<std::uint8_t>(covered);
    image.pixel[p] = pixel(i, j);
  }

 private:
  std::uint32_t pixel(int i, int j) {
    lit_ = -1;
    if (const auto even = even_pixel(i, j)) return *even;
    Rgb sum;
    for (int y = j; y < j + samples; ++y)
      for (int x = i; x < i + samples; ++x) {
        const std::int32_t shape = tile_.shape(x, y);
        if (shape >= 0 && shape != lit_) light(shape, i + 0.5 * samples, j + 0.5 * samples);
        add(shape, x, y, sum);
      }
    return packed(sum);
  }

  /// The pixel where one shape covers all of it and nothing is drawn on that.
  std::optional<std::uint32_t> even_pixel(int i, int j) {
    const std::int32_t shape = tile_.shape(i, j);
    if (style_.edge_width > 0 && shape >= 0) return {};
    for (int y = j; y < j + samples; ++y) {
      int others = 0;
      for (int x = i; x < i + samples; ++x) others += tile_.shape(x, y) != shape || is_outline_[at(x, y)];
      if (others > 0) return {};
    }
    if (shape < 0) return 0xffffff;
    light(shape, i + 0.5 * samples, j + 0.5 * samples);
    Rgb sum;
    sum.add(color_[screen_.particle(shape)], samples * samples * bright_);
    return packed(sum);
  }

  /// Finds how bright the shape is in a pixel with this middle: it hardly changes within one.
  void light(std::int32_t shape, double i, double j) {
    const double x = tile_.left() + i, y = tile_.top() + j;
    lit_ = shape;
    if (screen_.is_cut(shape)) {
      bright_ = screen_.cuts()[tile_.side(static_cast<int>(i), static_cast<int>(j))].light;
    } else if (screen_.is_triangle(shape)) {
      if (shape != known_) triangle_ = screen_.triangle(known_ = shape);
      bright_ = brightness(triangle_.normal_at(x, y));
    } else {
      const ScreenSphere& s = screen_.sphere(shape);
      const double right = x - s.centre[0], down = y - s.centre[1];
      const double towards = std::sqrt(std::max(s.radius * s.radius - right * right - down * down, 0.0));
      bright_ = brightness({right, -down, towards});
    }
  }

  void add(std::int32_t shape, int i, int j, Rgb& sum) const {
    if (shape < 0) return sum.add(white, 1);
    const Color& own = color_[screen_.particle(shape)];
    if (is_outline_[at(i, j)]) return sum.add(mix(own, ink, 0.85), 1);
    sum.add(is_on_edge(shape, i, j) ? mix(own, ink, 0.45) : own, bright_);
  }
  bool is_on_edge(std::int32_t shape, int i, int j) const {
    return style_.edge_width > 0 && screen_.is_triangle(shape) &&
           triangle_.from_side(tile_.left() + i + 0.5, tile_.top() + j + 0.5) <
               0.5 * samples * style_.edge_width;
  }

  /// What gets an outline: a body, or where it is cut.
  std::int32_t owner(std::int32_t shape) const {
    return shape < 0 ? -1 : screen_.is_cut(shape) ? shape : screen_.body(shape);
  }
  std::size_t at(int i, int j) const { return static_cast<std::size_t>(j) * tile_.size() + i; }

  /// Marks the samples of a particle that are near to where a farther one, or nothing, shows.
  void mark_outlines() {
    const int n = tile_.size();
    std::ranges::fill(is_outline_, 0);
    if (style_.outline_width <= 0) return;
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) owner_[at(i, j)] = owner(tile_.shape(i, j));
    for (int j = 0; j < n; ++j) {
      const std::int32_t *row = &owner_[at(0, j)], *next = j + 1 < n ? row + n : row;
      int changes = 0;
      for (int i = 0; i + 1 < n; ++i) changes += row[i] != row[i + 1];
      for (int i = 0; i < n; ++i) changes += row[i] != next[i];
      for (int i = 0; i < n && changes > 0; ++i) {
        if (i + 1 < n && row[i] != row[i + 1]) mark_between(i, j, i + 1, j);
        if (row[i] != next[i]) mark_between(i, j, i, j + 1);
      }
    }
  }
  void mark_between(int i, int j, int k, int l) {
    const float a = tile_.depth(i, j), b = tile_.depth(k, l);
    constexpr float level = samples;  // where bodies go through each other the line keeps to one of them
    const bool is_first = std::abs(a - b) < level ? owner_[at(i, j)] < owner_[at(k, l)] : a > b;
    is_first ? mark_about(i, j) : mark_about(k, l);
  }
  void mark_about(int i, int j) {
    const std::int32_t own = owner_[at(i, j)];
    const double reach = samples * style_.outline_width - 0.5;
    const int r = static_cast<int>(reach), last = tile_.size() - 1;
    for (int y = std::max(j - r, 0); y <= std::min(j + r, last); ++y)
      for (int x = std::max(i - r, 0); x <= std::min(i + r, last); ++x)
        if ((x - i) * (x - i) + (y - j) * (y - j) <= reach * reach && owner_[at(x, y)] == own)
          is_outline_[at(x, y)] = 1;
  }

  const OnScreen& screen_;
  std::span<const Color> color_;
  const SolidStyle& style_;
  const SampleTile& tile_;
  std::vector<std::uint8_t> is_outline_;  ///< of each sample
  std::vector<std::int32_t> owner_;       ///< the body that shows; -1: none
  std::int32_t known_ = -1, lit_ = -1;    ///< the shape of triangle_, and that of bright_
  ScreenTriangle triangle_;
  double bright_ = 0;
};

void check_window(const SolidWindow& window) {
  const std::string what = fmt::format("cannot draw {} by {} pixels", window.width, window.height);
  if (window.width < 1 || window.height < 1) throw input_error(what, "", "ask for a larger picture");
  if (static_cast<std::int64_t>(window.width) * window.height > std::int64_t{1} << 28)
    throw input_error(what, "", "ask for a smaller picture");
  if (!(std::isfinite(window.pixels_per_length) && window.pixels_per_length > 0))
    throw input_error(what, fmt::format("{} of them for a length of 1", window.pixels_per_length));
}

}  // namespace

SolidImage draw_solid(const SolidScene& scene, std::span<const Color> color, const SolidWindow& window,
                      const SolidStyle& style) {
  check_window(window);
  const OnScreen screen(scene, window, samples, style.shading);
  const int rim =
      style.outline_width > 0 ? static_cast<int>(std::ceil(samples * style.outline_width)) + 1 : 0;
  const Bins bins(screen, window, rim);
  SolidImage image{{}, {}, window.width, window.height};
  image.pixel.resize(static_cast<std::size_t>(window.width) * window.height, 0xffffff);
  image.covered.resize(image.pixel.size());
  for_parts(bins.down, [&](std::int64_t row) {
    SampleTile tile(tile_pixels * samples + 2 * rim);
    TilePainter painter(screen, color, style, tile);
    for (int column = 0; column < bins.across; ++column) {
      const int left = column * tile_pixels, top = static_cast<int>(row) * tile_pixels;
      const std::span<const std::int32_t> shapes = bins.shapes(column, static_cast<int>(row));
      if (shapes.empty()) continue;  // white
      tile.move_to(left * samples - rim, top * samples - rim, screen.cuts());
      std::int32_t body = -1;
      for (const std::int32_t shape : shapes) {
        if (body >= 0 && body != screen.body(shape)) tile.cover_cut(screen.cut_of(body));
        body = screen.body(shape);
        screen.is_triangle(shape) ? tile.cover(screen.triangle(shape), shape)
                                  : tile.cover(screen.sphere(shape), shape);
      }
      if (body >= 0) tile.cover_cut(screen.cut_of(body));
      painter.begin();
      for (int y = 0; y < std::min(tile_pixels, window.height - top); ++y)
        for (int x = 0; x < std::min(tile_pixels, window.width - left); ++x)
          painter.paint(rim + x * samples, rim + y * samples, image,
                        static_cast<std::size_t>(top + y) * window.width + left + x);
    }
  });
  return image;
}

}  // namespace supple
