#include "supple/draw/scene/flat_discs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "supple/draw/scene/layout.hpp"

namespace supple {

namespace {

struct Disc {
  std::int32_t body;
  Vec2 centre, shift;
  double radius;
  bool is_image;
};

FlatDisc circle(const Vec2& centre, double radius, int points) {
  FlatDisc disc;
  for (int k = 0; k < points; ++k) {
    const double angle = 2 * std::numbers::pi * k / points;
    disc.outline.push_back(centre + radius * Vec2{std::cos(angle), std::sin(angle)});
  }
  disc.across.assign(disc.outline.size(), -1);
  return disc;
}

/// Cuts the outline by the line normal . (x - centre) = offset and keeps the side below [Sutherland & Hodgman
/// 1974].
void cut(FlatDisc& disc, const Vec2& centre, const Vec2& normal, double offset, std::int32_t beyond) {
  FlatDisc kept;
  const std::size_t n = disc.outline.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Vec2 a = disc.outline[k], b = disc.outline[(k + 1) % n];
    const double above_a = dot(normal, a - centre) - offset, above_b = dot(normal, b - centre) - offset;
    if (above_a <= 0) {
      kept.outline.push_back(a);
      kept.across.push_back(disc.across[k]);
    }
    if ((above_a <= 0) != (above_b <= 0)) {
      kept.outline.push_back(a + (above_a / (above_a - above_b)) * (b - a));
      kept.across.push_back(above_a <= 0 ? beyond : disc.across[k]);
    }
  }
  disc = std::move(kept);
}

}  // namespace

std::vector<FlatDisc> flatten_discs(const Scene& scene) {
  std::vector<FlatDisc> flat(scene.bodies());
  double largest = 0;
  for (std::int32_t b = 0; b < scene.bodies(); ++b)
    if (scene.is_disc(b)) largest = std::max(largest, scene.radii_of(b)[0]);
  const int points = scene.bodies() > 3000 ? 24 : 72;
  std::vector<Disc> discs;
  for (const DrawnBody& body : lay_out_bodies(scene, largest)) {  // and the images that overlap them
    if (!scene.is_disc(body.body)) continue;
    FlatDisc& own = flat[body.body];
    const bool is_image = !own.outline.empty();
    discs.push_back({body.body, scene.centre_of(body.body) + body.shift, body.shift,
                     scene.radii_of(body.body)[0], is_image});
    if (!is_image) own = circle(discs.back().centre, discs.back().radius, points);
  }

  // Radical line at (d^2 + r_a^2 - r_b^2) / (2 d) from a.
  std::ranges::sort(discs, {}, [](const Disc& d) { return d.centre[0]; });
  for (std::size_t s = 0; s < discs.size(); ++s)
    for (std::size_t t = s + 1; t < discs.size(); ++t) {
      const Disc &a = discs[s], &b = discs[t];
      const Vec2 r = b.centre - a.centre;
      if (r[0] > 2 * largest) break;
      const double d = norm(r);
      if (d >= a.radius + b.radius || d == 0) continue;
      const double from_a = (d * d + a.radius * a.radius - b.radius * b.radius) / (2 * d);
      if (!a.is_image) cut(flat[a.body], a.centre, (1 / d) * r, from_a, b.body);
      if (!b.is_image) cut(flat[b.body], b.centre, (-1 / d) * r, d - from_a, a.body);
    }
  for (const Disc& d : discs)
    if (!d.is_image)
      for (Vec2& x : flat[d.body].outline) x -= d.shift;
  return flat;
}

}  // namespace supple
