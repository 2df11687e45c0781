#include "supple/geometry/self_crossing.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace supple {

namespace {

/// Segments p-q and r-s have a common point inside both.
bool cross_each_other(const Vec2& p, const Vec2& q, const Vec2& r, const Vec2& s) {
  const auto side = [](const Vec2& a, const Vec2& b, const Vec2& x) { return cross(b - a, x - a); };
  const auto apart = [](double a, double b) { return (a < 0 && b > 0) || (a > 0 && b < 0); };
  return apart(side(p, q, r), side(p, q, s)) && apart(side(r, s, p), side(r, s, q));
}

}  // namespace

std::optional<std::pair<int, int>> find_self_crossing(std::span<const Vec2> ring) {
  const auto n = ring.size();
  const auto end = [&](std::size_t k) -> const Vec2& { return ring[(k + 1) % n]; };
  const auto left = [&](std::size_t k) { return std::min(ring[k][0], end(k)[0]); };
  const auto right = [&](std::size_t k) { return std::max(ring[k][0], end(k)[0]); };
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return left(a) < left(b); });
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = a + 1; b < n && left(order[b]) <= right(order[a]); ++b) {
      const std::size_t i = std::min(order[a], order[b]), j = std::max(order[a], order[b]);
      if (j == i + 1 || (i == 0 && j == n - 1)) continue;  // neighbours share a vertex
      if (cross_each_other(ring[i], end(i), ring[j], end(j)))
        return std::pair(static_cast<int>(i), static_cast<int>(j));
    }
  return std::nullopt;
}

}  // namespace supple
