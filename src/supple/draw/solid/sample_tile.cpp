#include "supple/draw/solid/sample_tile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace supple {

namespace {

float as_float(double x) { return static_cast<float>(std::clamp(x, -1e30, 1e30)); }

/// What a row of samples crosses of a triangle.
struct Span {
  double low = std::numeric_limits<double>::max(), high = -low;
  void include(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
};

/// Adds where the row crosses the side from a to b. It is computed from the upper end, so that both triangles
/// at an edge get the same bits.
void cross_side(const Vec3& a, const Vec3& b, double row, Span& span) {
  const bool in_order = a[1] < b[1] || (a[1] == b[1] && a[0] < b[0]);
  const Vec3 &upper = in_order ? a : b, &lower = in_order ? b : a;
  if (row < upper[1] || row > lower[1]) return;
  if (upper[1] == lower[1]) {
    span.include(upper[0]);
    span.include(lower[0]);
    return;
  }
  const double x = upper[0] + (row - upper[1]) * ((lower[0] - upper[0]) / (lower[1] - upper[1]));
  span.include(std::clamp(x, std::min(upper[0], lower[0]), std::max(upper[0], lower[0])));
}

}  // namespace

SampleTile::SampleTile(int size)
    : size_(size), depth_(static_cast<std::size_t>(size) * size), shape_(depth_.size()) {}

void SampleTile::move_to(int left, int top) {
  left_ = left;
  top_ = top;
  std::ranges::fill(depth_, -std::numeric_limits<float>::infinity());
  std::ranges::fill(shape_, -1);
}

int SampleTile::first_at(double low, int origin) const {
  return static_cast<int>(std::clamp(std::ceil(low - 0.5 - origin), 0.0, 1.0 * size_));
}
int SampleTile::end_at(double high, int origin) const {
  return static_cast<int>(std::clamp(std::floor(high - 0.5 - origin) + 1, 0.0, 1.0 * size_));
}

void SampleTile::cover(const ScreenTriangle& t, std::int32_t shape) {
  if (!t.is_seen) return;
  const auto [a, b, c] = t.corner;
  const auto [high, low] = std::minmax({a[1], b[1], c[1]});
  // Near its sides the plane of a triangle that is seen at a slant goes beyond its corners, by rounding.
  const float farthest = static_cast<float>(t.farthest), nearest = static_cast<float>(t.nearest);
  const float slope = as_float(t.slope[0]);
  const int end = end_at(low, top_);
  for (int j = first_at(high, top_); j < end; ++j) {
    const double y = top_ + j + 0.5;
    Span span;
    cross_side(a, b, y, span);
    cross_side(b, c, y, span);
    cross_side(c, a, y, span);
    const int first = first_at(span.low, left_), count = end_at(span.high, left_) - first;
    if (count <= 0) continue;
    const float begin = as_float(t.depth(left_ + first + 0.5, y));
    float* depth = &depth_[at(first, j)];
    std::int32_t* shown = &shape_[at(first, j)];
    for (int i = 0; i < count; ++i) {
      const float z = std::min(std::max(begin + slope * static_cast<float>(i), farthest), nearest);
      const bool is_nearer = z > depth[i];
      depth[i] = is_nearer ? z : depth[i];
      shown[i] = is_nearer ? shape : shown[i];
    }
  }
}

void SampleTile::cover(const ScreenSphere& s, std::int32_t shape) {
  const int end = end_at(s.centre[1] + s.radius, top_);
  for (int j = first_at(s.centre[1] - s.radius, top_); j < end; ++j) {
    const double y = top_ + j + 0.5 - s.centre[1], half = s.radius * s.radius - y * y;
    if (half < 0) continue;
    const double reach = std::sqrt(half);
    const int first = first_at(s.centre[0] - reach, left_);
    const int count = end_at(s.centre[0] + reach, left_) - first;
    if (count <= 0) continue;
    const float begin = static_cast<float>(left_ + first + 0.5 - s.centre[0]);
    const float square = static_cast<float>(half), middle = static_cast<float>(s.centre[2]);
    float* depth = &depth_[at(first, j)];
    std::int32_t* shown = &shape_[at(first, j)];
    for (int i = 0; i < count; ++i) {
      const float x = begin + static_cast<float>(i);
      const float z = middle + std::sqrt(std::max(square - x * x, 0.0f));
      const bool is_nearer = z > depth[i];
      depth[i] = is_nearer ? z : depth[i];
      shown[i] = is_nearer ? shape : shown[i];
    }
  }
}

}  // namespace supple
