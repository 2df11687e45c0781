#include "supple/draw/scene/polygon_outline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "supple/geometry/inside.hpp"
#include "supple/geometry/polygon.hpp"

namespace supple {

namespace {

constexpr double full_turn = 2 * std::numbers::pi;
constexpr double sliver = 1e-9;  // of a turn or an edge: shorter pieces are rounding

struct Body {
  std::span<const Vec2> ring;
  std::span<const double> radius;

  std::size_t size() const { return ring.size(); }
  Vec2 next(std::size_t k) const { return ring[(k + 1) % size()]; }

  bool in_a_disc_but(std::size_t excluded, const Vec2& x) const {
    for (std::size_t j = 0; j < size(); ++j)
      if (j != excluded && norm(x - ring[j]) < radius[j]) return true;
    return false;
  }
  bool in_polygon(const Vec2& x) const { return size() > 2 && is_inside(x, ring); }
};

/// Shares of the segment a, b at which it meets the circle.
std::vector<double> crossings(const Vec2& a, const Vec2& b, const Vec2& centre, double radius) {
  const Vec2 e = b - a, from = a - centre;
  const double half = dot(e, from), square = dot(e, e), rest = dot(from, from) - radius * radius;
  const double under = half * half - square * rest;
  std::vector<double> shares;
  if (!(under > 0) || square == 0) return shares;
  for (const double sign : {-1.0, 1.0}) {
    const double share = (-half + sign * std::sqrt(under)) / square;
    if (share > 0 && share < 1) shares.push_back(share);
  }
  return shares;
}

/// The stretches of [first, last] between cuts whose middle is visible, joined where they meet.
template <class Visible>
std::vector<std::pair<double, double>> visible_stretches(std::vector<double> cuts, double first, double last,
                                                         Visible visible) {
  cuts.push_back(first);
  cuts.push_back(last);
  std::sort(cuts.begin(), cuts.end());
  std::vector<std::pair<double, double>> stretches;
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    if (cuts[k + 1] - cuts[k] < sliver * (last - first) || !visible(0.5 * (cuts[k] + cuts[k + 1]))) continue;
    if (!stretches.empty() && cuts[k] - stretches.back().second < sliver * (last - first))
      stretches.back().second = cuts[k + 1];
    else stretches.emplace_back(cuts[k], cuts[k + 1]);
  }
  return stretches;
}

void add_arcs(std::vector<std::vector<Vec2>>& pieces, const Body& body, std::size_t i, double step) {
  const Vec2 centre = body.ring[i];
  const double radius = body.radius[i];
  const auto at = [&](double angle) { return centre + radius * Vec2{std::cos(angle), std::sin(angle)}; };
  std::vector<double> cuts;
  const auto cut = [&](double angle) { cuts.push_back(angle - full_turn * std::floor(angle / full_turn)); };
  for (std::size_t j = 0; j < body.size(); ++j) {
    const Vec2 r = body.ring[j] - centre;
    const double d = norm(r), other = body.radius[j];
    if (d > 0 && d < radius + other && d > std::abs(radius - other)) {
      const double half = std::acos((d * d + radius * radius - other * other) / (2 * d * radius));
      const double towards = std::atan2(r[1], r[0]);
      cut(towards - half);
      cut(towards + half);
    }
    const Vec2 a = body.ring[j], b = body.next(j);
    for (const double share : crossings(a, b, centre, radius)) {
      const Vec2 x = a + share * (b - a) - centre;
      cut(std::atan2(x[1], x[0]));
    }
  }
  // From a cut, so that no arc is divided where the angle begins anew.
  const double first = cuts.empty() ? 0 : *std::min_element(cuts.begin(), cuts.end());
  const auto is_visible = [&](double angle) {
    return !body.in_a_disc_but(i, at(angle)) && !body.in_polygon(at(angle));
  };
  for (const auto& [from, to] : visible_stretches(cuts, first, first + full_turn, is_visible)) {
    const int steps = static_cast<int>(std::clamp(std::ceil((to - from) * radius / step), 2.0, 1e4));
    std::vector<Vec2>& arc = pieces.emplace_back();
    for (int s = 0; s <= steps; ++s) arc.push_back(at(from + (to - from) * s / steps));
  }
}

void add_edge(std::vector<std::vector<Vec2>>& pieces, const Body& body, std::size_t k) {
  const Vec2 a = body.ring[k], e = body.next(k) - a;
  std::vector<double> cuts;
  for (std::size_t j = 0; j < body.size(); ++j) {
    const std::vector<double> met = crossings(a, a + e, body.ring[j], body.radius[j]);
    cuts.insert(cuts.end(), met.begin(), met.end());
  }
  const auto is_visible = [&](double share) { return !body.in_a_disc_but(body.size(), a + share * e); };
  for (const auto& [from, to] : visible_stretches(cuts, 0, 1, is_visible))
    pieces.push_back({a + from * e, a + to * e});
}

double twice_area(const Vec2& a, const Vec2& b, const Vec2& c) { return cross(b - a, c - a); }

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

std::vector<std::vector<Vec2>> body_outline(std::span<const Vec2> ring, std::span<const double> radius,
                                            double step) {
  const Body body{ring, radius};
  std::vector<std::vector<Vec2>> pieces;
  for (std::size_t i = 0; i < body.size(); ++i) add_arcs(pieces, body, i, step);
  if (body.size() > 2)
    for (std::size_t k = 0; k < body.size(); ++k) add_edge(pieces, body, k);
  return pieces;
}

std::vector<Vec2> outer_ring(std::span<const Vec2> ring, std::span<const double> radius) {
  const double thick = *std::max_element(radius.begin(), radius.end());
  std::vector<Vec2> outer(ring.begin(), ring.end());
  double largest = 0;
  for (std::vector<Vec2>& curve :
       closed_curves(body_outline(ring, radius, thick * std::numbers::pi / 16), 1e-6 * thick))
    if (const double its = polygon_area(curve); its > largest) {
      largest = its;
      outer = std::move(curve);
    }
  return outer;
}

std::vector<std::array<std::size_t, 3>> triangulate(std::span<const Vec2> ring) {
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<std::size_t> left(ring.size());
  std::iota(left.begin(), left.end(), std::size_t{0});
  if (polygon_area(ring) < 0) std::reverse(left.begin(), left.end());
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
