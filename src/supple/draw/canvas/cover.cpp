#include "supple/draw/canvas/cover.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace supple {

namespace {

/// A piece of the ring that goes down (sign 1) or up from y = top to bottom, in lengths of the area.
struct Edge {
  double top, bottom, x_at_top, slope, sign;
  double x(double y) const { return x_at_top + slope * (y - top); }
};

std::vector<Edge> edges_of(std::span<const Vec2> ring, const PixelArea& area) {
  std::vector<Edge> edges;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Vec2 corner{1.0 * area.left, 1.0 * area.top};
    Vec2 a = ring[k] - corner, b = ring[k + 1 == ring.size() ? 0 : k + 1] - corner;
    const double sign = a[1] < b[1] ? 1 : -1;
    if (sign < 0) std::swap(a, b);
    if (a[1] == b[1] || b[1] <= 0 || a[1] >= area.height()) continue;
    edges.push_back({a[1], b[1], a[0], (b[0] - a[0]) / (b[1] - a[1]), sign});
  }
  std::ranges::stable_sort(edges, {}, &Edge::top);
  return edges;
}

/// Adds to a row what lies right of a piece of an edge within it, of signed height `height` and of x from
/// `left` to `right`. The mean over the piece of how much of [0, x) is right of it is 0, (x - left)^2 / (2
/// (right - left)), or x - (left + right)/2; from pixel to pixel it grows by the covered share.
void add_piece(float* steps, double left, double right, double height) {
  const double extent = right - left;
  const auto covered = [&](double x) {
    if (x >= right) return x - 0.5 * (left + right);
    return x > left ? 0.5 * (x - left) * (x - left) / extent : 0;
  };
  double share = 0, before = 0;
  for (auto i = static_cast<std::ptrdiff_t>(left);; ++i) {
    const double behind = covered(static_cast<double>(i + 1)), here = behind - before;
    steps[i] += static_cast<float>(height * (here - share));
    share = here;
    before = behind;
    if (static_cast<double>(i + 1) < right) continue;
    steps[i + 1] += static_cast<float>(height * (1 - share));
    return;
  }
}

/// Shares of the pixels of a row, the sums of the steps, which are zero afterwards.
void sum_steps(float* steps, int width, std::uint8_t* cover) {
  constexpr float none[pixel_block] = {};
  float sum = 0;
  const auto share = [&] { return static_cast<std::uint8_t>(std::min(std::abs(sum), 1.0f) * 255 + 0.5f); };
  for (int k = 0; k < width; k += pixel_block) {
    if (std::memcmp(steps + k, none, sizeof none) == 0) {
      std::memset(cover + k, share(), pixel_block);
      continue;
    }
    for (int i = k; i < k + pixel_block; ++i) {
      sum += steps[i];
      cover[i] = share();
      steps[i] = 0;
    }
  }
}

}  // namespace

void cover_ring(std::span<const Vec2> ring, const PixelArea& area, const RowOfCover& row) {
  const std::vector<Edge> edges = edges_of(ring, area);
  std::vector<Edge> here;
  std::size_t next = 0;
  std::vector<float> steps(area.width() + 2 * pixel_block, 0.0f);
  std::vector<std::uint8_t> cover(area.width() + pixel_block);
  for (int y = 0; y < area.height(); ++y) {
    for (; next < edges.size() && edges[next].top < y + 1; ++next) here.push_back(edges[next]);
    for (const Edge& edge : here) {
      const double from = std::max<double>(edge.top, y), to = std::min<double>(edge.bottom, y + 1);
      const double a = std::clamp<double>(edge.x(from), 0, area.width());
      const double b = std::clamp<double>(edge.x(to), 0, area.width());
      add_piece(steps.data(), std::min(a, b), std::max(a, b), edge.sign * (to - from));
    }
    std::erase_if(here, [&](const Edge& edge) { return edge.bottom <= y + 1; });
    sum_steps(steps.data(), area.width(), cover.data());
    steps[area.width()] = steps[area.width() + 1] = 0;
    row(area.top + y, cover.data());
  }
}

LineCover::LineCover(const PixelArea& area)
    : area_(area),
      cover_(static_cast<std::size_t>(area.width() + pixel_block) * area.height(), 0),
      touched_(area.height(), {area.width(), 0}) {}

/// Row by row, between where the segment comes within reach of the row.
void LineCover::segment(const Vec2& from, const Vec2& to, double width, End begin, End end) {
  const double length = norm(to - from), reach = 0.5 * width + 0.5;
  const Vec2 along = length > 0 ? (1 / length) * (to - from) : Vec2{1, 0};
  const bool is_level = std::abs(along[1]) < 1e-9;
  const double per_row = is_level ? 0 : 1 / along[1];
  const int first = static_cast<int>(std::max(std::floor(std::min(from[1], to[1]) - reach), 1.0 * area_.top));
  const int last =
      static_cast<int>(std::min(std::ceil(std::max(from[1], to[1]) + reach), 1.0 * area_.bottom));
  constexpr float far = std::numeric_limits<float>::max();
  const auto ux = static_cast<float>(along[0]), uy = static_cast<float>(along[1]);
  const auto inner = static_cast<float>(0.5 - 0.5 * width), outer = static_cast<float>(reach);
  const auto l = static_cast<float>(length);
  const float least = begin == End::round ? 0 : -far, most = end == End::round ? l : far;
  const float cut_begin = begin == End::round ? far : 0.5f, cut_end = end == End::round ? far : l + 0.5f;
  for (int y = first; y < last; ++y) {
    const double height = y + 0.5 - from[1];
    double near = 0, rear = length;
    if (!is_level) {
      const double s = (height - reach) * per_row, t = (height + reach) * per_row;
      near = std::max(near, std::min(s, t));
      rear = std::min(rear, std::max(s, t));
    }
    const double x0 = from[0] + near * along[0], x1 = from[0] + rear * along[0];
    const int left = static_cast<int>(std::max(std::min(x0, x1) - reach - 1, 1.0 * area_.left)) - area_.left;
    const int right =
        static_cast<int>(std::min(std::max(x0, x1) + reach + 1, 1.0 * area_.right)) - area_.left;
    if (near > rear || left >= right) continue;
    auto& [touched_left, touched_right] = touched_[y - area_.top];
    touched_left = std::min(touched_left, left);
    touched_right = std::max(touched_right, right);
    std::uint8_t* cover = row(y);
    const auto py = static_cast<float>(height), start = static_cast<float>(area_.left + 0.5 - from[0]);
    for (int k = left; k < right; k += pixel_block) {
      std::int32_t share[pixel_block];
#pragma omp simd
      for (int i = 0; i < pixel_block; ++i) {
        const float px = start + static_cast<float>(k + i), t = px * ux + py * uy;
        const float s = std::min(std::max(t, least), most);
        const float dx = px - s * ux, dy = py - s * uy, d = std::sqrt(dx * dx + dy * dy);
        const float across = std::min(std::max(outer - d, 0.0f), 1.0f) - std::max(inner - d, 0.0f);
        const float cut = std::min(std::min(t + cut_begin, cut_end - t), 1.0f);
        share[i] = static_cast<std::int32_t>(across * std::max(cut, 0.0f) * 255 + 0.5f);
      }
#pragma omp simd
      for (int i = 0; i < pixel_block; ++i)
        cover[k + i] = std::max(cover[k + i], static_cast<std::uint8_t>(share[i]));
    }
  }
}

void LineCover::dashes(std::span<const Vec2> line, double width, std::span<const double> dash) {
  double period = 0;
  for (const double part : dash) period += part;
  if (!(period > 0)) return;
  if (dash.size() % 2 == 1) period *= 2;
  double begun = 0;  // length of the line before the segment, within a period
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const double length = norm(line[k + 1] - line[k]);
    if (!(length > 0)) continue;
    const Vec2 along = (1 / length) * (line[k + 1] - line[k]);
    // the segment within the area and a margin
    double near = 0, far = length;
    const double low[] = {area_.left - width - 1.0, area_.top - width - 1.0};
    const double high[] = {area_.right + width + 1.0, area_.bottom + width + 1.0};
    for (int d = 0; d < 2; ++d) {
      if (std::abs(along[d]) < 1e-12) {
        if (line[k][d] < low[d] || line[k][d] > high[d]) far = -1;
        continue;
      }
      const double s = (low[d] - line[k][d]) / along[d], t = (high[d] - line[k][d]) / along[d];
      near = std::max(near, std::min(s, t));
      far = std::min(far, std::max(s, t));
    }
    if (near < far) {
      const double skipped = std::floor((begun + near) / period) * period;
      double at = skipped - begun;  // of the begin of a period, from the begin of the segment
      for (std::size_t part = 0; at < far; at += dash[part++ % dash.size()]) {
        const double end = at + dash[part % dash.size()];
        if (part % 2 == 1 || end <= near || end <= 0) continue;
        // Round at a corner, unless the dash goes on behind it by less than the round would.
        const double before = k > 0 ? std::max(-at, 0.0) : 0;
        const double after = k + 2 < line.size() ? std::max(end - length, 0.0) : 0;
        const bool round_begin = before > 0.5 * width, round_end = after > 0.5 * width;
        const double from = round_begin ? 0 : std::max(at, 0.0) - before;
        const double to = round_end ? length : std::min(end, length) + after;
        segment(line[k] + from * along, line[k] + to * along, width, round_begin ? End::round : End::flat,
                round_end ? End::round : End::flat);
      }
    }
    begun = std::fmod(begun + length, period);
  }
}

}  // namespace supple
