#include "supple/draw/scene/polygon_outline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

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
  /// By the even-odd rule.
  bool in_polygon(const Vec2& x) const {
    bool inside = false;
    for (std::size_t k = 0; size() > 2 && k < size(); ++k) {
      const Vec2 a = ring[k], b = next(k);
      if ((a[1] > x[1]) == (b[1] > x[1])) continue;
      if (x[0] < a[0] + (x[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) inside = !inside;
    }
    return inside;
  }
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

}  // namespace supple
