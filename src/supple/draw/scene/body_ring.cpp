#include "supple/draw/scene/body_ring.hpp"

#include <algorithm>
#include <numbers>
#include <numeric>

#include "supple/draw/scene/polygon_outline.hpp"

namespace supple {
namespace {

double twice_area(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

double area(std::span<const Vec2> ring) {
  double sum = 0;
  for (std::size_t k = 0; k < ring.size(); ++k)
    sum += 0.5 * twice_area(ring[0], ring[k], ring[(k + 1) % ring.size()]);
  return sum;
}

/// Joins directed pieces end to start into closed curves; pieces that meet nothing within `gap` are left out.
std::vector<std::vector<Vec2>> closed_curves(std::vector<std::vector<Vec2>> pieces, double gap) {
  std::vector<std::vector<Vec2>> curves;
  while (!pieces.empty()) {
    std::vector<Vec2> curve = std::move(pieces.back());
    pieces.pop_back();
    while (norm(curve.back() - curve.front()) > gap) {
      const auto next = std::find_if(pieces.begin(), pieces.end(), [&](const auto& piece) {
        return norm(piece.front() - curve.back()) <= gap;
      });
      if (next == pieces.end()) break;
      curve.insert(curve.end(), next->begin() + 1, next->end());
      pieces.erase(next);
    }
    if (curve.size() < 4 || norm(curve.back() - curve.front()) > gap) continue;
    curve.pop_back();
    curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace

std::vector<Vec2> outer_ring(std::span<const Vec2> ring, std::span<const double> radius) {
  const double thick = *std::max_element(radius.begin(), radius.end());
  std::vector<Vec2> outer(ring.begin(), ring.end());
  double largest = 0;
  for (std::vector<Vec2>& curve :
       closed_curves(body_outline(ring, radius, thick * std::numbers::pi / 16), 1e-6 * thick))
    if (const double its = area(curve); its > largest) {
      largest = its;
      outer = std::move(curve);
    }
  return outer;
}

std::vector<std::array<std::size_t, 3>> triangulate(std::span<const Vec2> ring) {
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<std::size_t> left(ring.size());
  std::iota(left.begin(), left.end(), std::size_t{0});
  if (area(ring) < 0) std::reverse(left.begin(), left.end());
  const auto at = [&](std::size_t k) { return left[k % left.size()]; };
  const auto is_ear = [&](std::size_t k) {
    const Vec2 &a = ring[at(k)], &b = ring[at(k + 1)], &c = ring[at(k + 2)];
    if (!(twice_area(a, b, c) > 0)) return false;
    return std::none_of(left.begin(), left.end(), [&](std::size_t p) {
      const Vec2& x = ring[p];
      return p != at(k) && p != at(k + 1) && p != at(k + 2) && twice_area(a, b, x) >= 0 &&
             twice_area(b, c, x) >= 0 && twice_area(c, a, x) >= 0;
    });
  };
  while (left.size() > 2) {
    std::size_t ear = 0;
    while (ear < left.size() && !is_ear(ear)) ++ear;
    ear %= left.size();  // rounding may hide the last ears, which are slivers
    triangles.push_back({at(ear), at(ear + 1), at(ear + 2)});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>((ear + 1) % left.size()));
  }
  return triangles;
}

}  // namespace supple
