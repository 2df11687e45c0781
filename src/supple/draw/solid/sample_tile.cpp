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

/// Covers a row of samples from arrays of their depths.
void cover_row(int count, const float* z, std::int32_t shape, float* depth, std::int32_t* shown) {
  for (int i = 0; i < count; ++i) {
    const bool is_nearer = z[i] > depth[i];
    depth[i] = is_nearer ? z[i] : depth[i];
    shown[i] = is_nearer ? shape : shown[i];
  }
}

}  // namespace

SampleTile::SampleTile(int size)
    : size_(size), depth_(static_cast<std::size_t>(size) * size), shape_(depth_.size()), row_(size) {}

void SampleTile::move_to(int left, int top, std::span<const ScreenCut> cuts) {
  constexpr float none = std::numeric_limits<float>::infinity();
  left_ = left;
  top_ = top;
  std::ranges::fill(depth_, -none);
  std::ranges::fill(shape_, -1);
  if (cuts.empty()) return;
  near_.assign(depth_.size(), none);
  far_.assign(depth_.size(), -none);
  side_.assign(depth_.size(), 0);
  inside_.assign(depth_.size(), 0);
  for (std::size_t k = 0; k < cuts.size(); ++k)
    for (int j = 0; j < size_; ++j) cut_row(cuts[k], static_cast<std::int32_t>(k), j);
}

/// Narrows what row j shows to what lies within a side.
void SampleTile::cut_row(const ScreenCut& cut, std::int32_t side, int j) {
  const float begin = as_float(cut.beyond(left_ + 0.5, top_ + j + 0.5)), slope = as_float(cut.slope[0]);
  const auto beyond = [&](int i) { return begin + slope * static_cast<float>(i); };
  float *near = &near_[at(0, j)], *far = &far_[at(0, j)];
  std::int32_t* by = &side_[at(0, j)];
  switch (cut.lies) {
    case ScreenCut::Lies::far:
      for (int i = 0; i < size_; ++i) far[i] = std::max(far[i], beyond(i));
      break;
    case ScreenCut::Lies::along:
      for (int i = 0; i < size_; ++i)
        far[i] = beyond(i) > 0 ? std::numeric_limits<float>::infinity() : far[i];
      break;
    case ScreenCut::Lies::near:
      for (int i = 0; i < size_; ++i) {
        const bool is_nearer = beyond(i) < near[i];
        near[i] = is_nearer ? beyond(i) : near[i];
        by[i] = is_nearer ? side : by[i];
      }
  }
}

int SampleTile::first_at(double place, int origin) const {
  return static_cast<int>(std::clamp(std::ceil(place - 0.5 - origin), 0.0, 1.0 * size_));
}

void SampleTile::touch(int first_row, int end_row) {
  if (first_row >= end_row) return;
  const bool is_first = first_row_ >= end_row_;
  first_row_ = is_first ? first_row : std::min(first_row_, first_row);
  end_row_ = is_first ? end_row : std::max(end_row_, end_row);
}

/// A surface through these depths in the row, that the viewer sees from outside (+1) or from inside (-1).
void SampleTile::cover(int first, int j, int count, int sees, std::int32_t shape) {
  const std::size_t begin = at(first, j);
  if (!is_cut()) return cover_row(count, row_.data(), shape, &depth_[begin], &shape_[begin]);
  const float *z = row_.data(), *near = &near_[begin], *far = &far_[begin];
  float* depth = &depth_[begin];
  std::int32_t *shown = &shape_[begin], *inside = &inside_[begin];
  for (int i = 0; i < count; ++i) {
    inside[i] -= z[i] < near[i] ? sees : 0;
    const bool shows = (far[i] <= z[i]) & (z[i] <= near[i]) & (z[i] > depth[i]);
    depth[i] = shows ? z[i] : depth[i];
    shown[i] = shows ? shape : shown[i];
  }
}

void SampleTile::cover_cut(std::int32_t shape) {
  for (int j = first_row_; j < end_row_ && is_cut(); ++j) {
    const float *near = &near_[at(0, j)], *far = &far_[at(0, j)];
    float* depth = &depth_[at(0, j)];
    std::int32_t *shown = &shape_[at(0, j)], *inside = &inside_[at(0, j)];
    for (int i = 0; i < size_; ++i) {
      const bool shows = (inside[i] > 0) & (far[i] <= near[i]) & (near[i] > depth[i]);
      depth[i] = shows ? near[i] : depth[i];
      shown[i] = shows ? shape : shown[i];
      inside[i] = 0;
    }
  }
  first_row_ = end_row_ = 0;
}

void SampleTile::cover(const ScreenTriangle& t, std::int32_t shape) {
  if (!t.is_seen) return;
  const auto [a, b, c] = t.corner;
  const auto [high, low] = std::minmax({a[1], b[1], c[1]});
  // Near its sides the plane of a triangle that is seen at a slant goes beyond its corners, by rounding.
  const float farthest = static_cast<float>(t.farthest), nearest = static_cast<float>(t.nearest);
  const float slope = as_float(t.slope[0]);
  const int first_row = first_at(high, top_), end = first_at(low, top_);
  touch(first_row, end);
  for (int j = first_row; j < end; ++j) {
    const double y = top_ + j + 0.5;
    Span span;
    cross_side(a, b, y, span);
    cross_side(b, c, y, span);
    cross_side(c, a, y, span);
    const int first = first_at(span.low, left_), count = first_at(span.high, left_) - first;
    if (count <= 0) continue;
    const float begin = as_float(t.depth(left_ + first + 0.5, y));
    for (int i = 0; i < count; ++i)
      row_[i] = std::min(std::max(begin + slope * static_cast<float>(i), farthest), nearest);
    cover(first, j, count, t.is_outside ? 1 : -1, shape);
  }
}

void SampleTile::cover(const ScreenSphere& s, std::int32_t shape) {
  const int first_row = first_at(s.centre[1] - s.radius, top_), end = first_at(s.centre[1] + s.radius, top_);
  touch(first_row, end);
  const float middle = static_cast<float>(s.centre[2]);
  for (int j = first_row; j < end; ++j) {
    const double y = top_ + j + 0.5 - s.centre[1], half = s.radius * s.radius - y * y;
    if (half < 0) continue;
    const double reach = std::sqrt(half);
    const int first = first_at(s.centre[0] - reach, left_);
    const int count = first_at(s.centre[0] + reach, left_) - first;
    if (count <= 0) continue;
    const float begin = static_cast<float>(left_ + first + 0.5 - s.centre[0]);
    const float square = static_cast<float>(half);
    const auto fill = [&](float way) {
      for (int i = 0; i < count; ++i) {
        const float x = begin + static_cast<float>(i);
        row_[i] = middle + way * std::sqrt(std::max(square - x * x, 0.0f));
      }
      cover(first, j, count, static_cast<int>(way), shape);
    };
    fill(1);
    if (is_cut()) fill(-1);
  }
}

}  // namespace supple
