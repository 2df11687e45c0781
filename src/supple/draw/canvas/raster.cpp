#include "supple/draw/canvas/raster.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace supple {

namespace {

bool all_finite(std::span<const Vec2> points) {
  return std::ranges::all_of(points,
                             [](const Vec2& p) { return std::isfinite(p[0]) && std::isfinite(p[1]); });
}

/// The corners of the box about the points, moved out by `margin`.
std::pair<Vec2, Vec2> bounds_of(std::span<const Vec2> points, double margin) {
  constexpr double far = std::numeric_limits<double>::infinity();
  Vec2 low{far, far}, high{-far, -far};
  for (const Vec2& p : points)
    for (int d = 0; d < 2; ++d) {
      low[d] = std::min(low[d], p[d] - margin);
      high[d] = std::max(high[d], p[d] + margin);
    }
  return {low, high};
}

/// c / 255 of one colour and the rest of the other, for each byte.
std::uint32_t mixed(std::uint32_t below, std::uint32_t above, std::uint32_t c) {
  std::uint32_t out = 0;
  for (const int shift : {0, 8, 16}) {
    const std::uint32_t sum = (below >> shift & 0xff) * (255 - c) + (above >> shift & 0xff) * c + 128;
    out |= (sum + (sum >> 8)) >> 8 << shift;  // sum / 255, rounded
  }
  return out;
}

void mix_block(std::uint32_t* below, std::uint32_t above, const std::uint8_t* cover) {
  std::uint32_t c[pixel_block], out[pixel_block];
  for (int i = 0; i < pixel_block; ++i) c[i] = cover[i];
  for (int i = 0; i < pixel_block; ++i) out[i] = mixed(below[i], above, c[i]);
  for (int i = 0; i < pixel_block; ++i) below[i] = out[i];
}

bool all_are(const std::uint8_t* cover, std::uint64_t value) {
  std::uint64_t parts[pixel_block / 8];
  std::memcpy(parts, cover, pixel_block);
  value *= 0x0101010101010101;
  return parts[0] == value && parts[1] == value;
}

std::uint32_t product(std::uint32_t a, std::uint32_t b) {
  const std::uint32_t sum = a * b + 128;
  return (sum + (sum >> 8)) >> 8;
}

/// Leaves of the shares of a block what the mask shows.
void cut_block(std::uint8_t* cover, const std::uint8_t* mask) {
  std::uint32_t both[pixel_block];
#pragma omp simd
  for (int i = 0; i < pixel_block; ++i) both[i] = product(cover[i], mask[i]);
#pragma omp simd
  for (int i = 0; i < pixel_block; ++i) cover[i] = static_cast<std::uint8_t>(both[i]);
}

std::uint32_t as_pixel(Color color) {
  std::uint32_t out = 0;
  for (const double part : {color.red, color.green, color.blue})
    out = out << 8 | static_cast<std::uint32_t>(std::clamp(part, 0.0, 1.0) * 255 + 0.5);
  return out;
}

}  // namespace

Raster::Raster(std::uint32_t* pixels, int width, int height, std::size_t stride)
    : pixels_(pixels), width_(width), height_(height), stride_(stride), clips_{{{0, 0, width, height}, {}}} {}

PixelArea Raster::shown(const Vec2& low, const Vec2& high) const {
  const PixelArea& most = clips_.back().area;
  const auto within = [](double x, int least, int greatest) {
    return static_cast<int>(std::clamp(x, static_cast<double>(least), static_cast<double>(greatest)));
  };
  return {
      within(std::floor(low[0]), most.left, most.right), within(std::floor(low[1]), most.top, most.bottom),
      within(std::ceil(high[0]), most.left, most.right), within(std::ceil(high[1]), most.top, most.bottom)};
}

/// Pixels [left, right) of a row of an area, where the clip shows them.
void Raster::paint(int y, const PixelArea& area, std::pair<int, int> part, std::uint8_t* cover, Pixel color) {
  const Clip& clip = clips_.back();
  const std::uint8_t* mask = clip.mask.empty() ? nullptr : clip.mask_at(area.left, y);
  Pixel* pixels = pixels_ + y * stride_ + area.left;
  // Rows lie far apart in memory: those that come next are asked for early.
  if (const int ahead = 4; y + ahead < area.bottom && part.second - part.first < 512) {
    for (int k = part.first; k < part.second; k += 16) __builtin_prefetch(pixels + ahead * stride_ + k, 1);
    if (mask)
      for (int k = part.first; k < part.second; k += 64)
        __builtin_prefetch(clip.mask_at(area.left + k, y + ahead));
  }
  for (int k = part.first; k < part.second; k += pixel_block) {
    const int n = std::min(pixel_block, part.second - k);
    if (all_are(cover + k, 0)) continue;
    if (mask && n == pixel_block) {
      if (all_are(mask + k, 0)) continue;
      if (!all_are(mask + k, 255)) cut_block(cover + k, mask + k);
    } else if (mask) {
      for (int i = k; i < k + n; ++i) cover[i] = static_cast<std::uint8_t>(product(cover[i], mask[i]));
    }
    if (n == pixel_block && all_are(cover + k, 255)) {
      std::fill_n(pixels + k, pixel_block, color);
    } else if (n == pixel_block) {
      mix_block(pixels + k, color, cover + k);
    } else {
      Pixel rest[pixel_block] = {};
      std::copy_n(pixels + k, n, rest);
      mix_block(rest, color, cover + k);
      std::copy_n(rest, n, pixels + k);
    }
  }
}

void Raster::fill(std::span<const Vec2> ring, Color color) {
  if (ring.size() < 3 || !all_finite(ring)) return;
  const auto [low, high] = bounds_of(ring, 0);
  const PixelArea area = shown(low, high);
  if (area.empty()) return;
  const Pixel pixel = as_pixel(color);
  cover_ring(ring, area, [&](int y, std::uint8_t* cover) {
    paint(y, area, {0, area.width()}, cover, pixel);
  });
}

void Raster::stroke(std::span<const Vec2> line, Ends ends, const Line& style, Color color) {
  if (line.empty() || !(style.width > 0) || !all_finite(line)) return;
  const auto [low, high] = bounds_of(line, 0.5 * style.width + 1);
  const PixelArea area = shown(low, high);
  if (area.empty()) return;
  std::vector<Vec2> joined(line.begin(), line.end());
  if (ends == Ends::joined || line.size() == 1) joined.push_back(line.front());
  LineCover cover(area);
  if (!style.dash.empty()) {
    cover.dashes(joined, style.width, style.dash);
  } else {
    for (std::size_t k = 0; k + 1 < joined.size(); ++k)
      cover.segment(joined[k], joined[k + 1], style.width, LineCover::End::round, LineCover::End::round);
  }
  const Pixel pixel = as_pixel(color);
  for (int y = area.top; y < area.bottom; ++y) paint(y, area, cover.touched(y), cover.row(y), pixel);
}

void Raster::clip(std::span<const Vec2> ring, Side side) {
  const Clip& outer = clips_.back();
  const auto [low, high] = bounds_of(ring, 0);
  const PixelArea area = ring.size() < 3 || !all_finite(ring) ? PixelArea{0, 0, 0, 0} : shown(low, high);
  Clip inner{side == Side::inside ? area : outer.area, {}};
  const std::uint8_t flip = side == Side::inside ? 0 : 255;
  inner.mask.assign(static_cast<std::size_t>(inner.area.width()) * inner.area.height(), flip);
  if (!area.empty())
    cover_ring(ring, area, [&](int y, std::uint8_t* cover) {
      std::transform(cover, cover + area.width(), inner.mask_at(area.left, y),
                     [&](std::uint8_t c) { return static_cast<std::uint8_t>(c ^ flip); });
    });
  if (!outer.mask.empty())
    for (int y = inner.area.top; y < inner.area.bottom; ++y) {
      std::uint8_t* mask = inner.mask_at(inner.area.left, y);
      std::transform(mask, mask + inner.area.width(), outer.mask_at(inner.area.left, y), mask,
                     [](std::uint8_t a, std::uint8_t b) { return static_cast<std::uint8_t>(product(a, b)); });
    }
  clips_.push_back(std::move(inner));
}

void Raster::unclip() { clips_.pop_back(); }

}  // namespace supple
