#include "supple/observe/plain_area.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "supple/geometry/disc_overlap.hpp"

namespace supple {

namespace {

using std::numbers::pi;

/// A ring about its mean, whose vertices follow each other in angle: edges of it lie in sectors of their own.
struct Rays {
  std::vector<Vec2> x;
  bool follow = false;      ///< once round, each step less than half a turn
  double nearest = 0;       ///< least distance of a vertex from the mean
  double sine = 1;          ///< of the least step, or 1 from a right angle on
  double tangent_half = 0;  ///< tangent of half the least step
  const Vec2& after(std::size_t k) const { return x[k + 1 < x.size() ? k + 1 : 0]; }
};

Rays rays_of(std::span<const Vec2> ring) {
  Rays r;
  Vec2 sum{};
  for (const Vec2& x : ring) sum += x - ring[0];
  const Vec2 mean = ring[0] + (1.0 / static_cast<double>(ring.size())) * sum;
  for (const Vec2& x : ring) r.x.push_back(x - mean);
  r.nearest = r.tangent_half = std::numeric_limits<double>::infinity();
  int turns = 0;
  double length = norm(r.x[0]);
  for (std::size_t k = 0; k < r.x.size(); ++k) {
    const Vec2 &a = r.x[k], &b = r.after(k);
    const double across = cross(a, b), along = dot(a, b), next = norm(b);
    if (!(across > 0)) return r;
    turns += a[1] < 0 && b[1] >= 0;
    r.nearest = std::min(r.nearest, length);
    if (along > 0) r.sine = std::min(r.sine, across / (length * next));
    r.tangent_half = std::min(r.tangent_half, across / (length * next + along));
    length = next;
  }
  r.follow = turns == 1;
  return r;
}

double area_of(const Rays& rays) {
  double twice = 0;
  for (std::size_t k = 0; k < rays.x.size(); ++k) twice += cross(rays.x[k], rays.after(k));
  return 0.5 * twice;
}

/// The polygon, the sectors of discs outside of it, less the outer half of what neighbours have in common.
/// Vertex and edge that do not belong together are a step apart at least, two vertices that are no neighbours
/// two steps: both are out of reach where nearest sin(step) > radius.
std::optional<double> rough_area(const Rays& rays, double radius) {
  if (!(rays.nearest * rays.sine > radius)) return std::nullopt;
  const auto n = static_cast<double>(rays.x.size());
  double area = area_of(rays) + 0.5 * radius * radius * (n + 2) * pi;  // exterior angles sum up to 2 pi
  for (std::size_t k = 0; k < rays.x.size(); ++k)
    area -= overlap_share(radius, radius, norm(rays.after(k) - rays.x[k]));
  return area;
}

/// What is nearer to an edge than to the rest of the ring is a rectangle of this height on it, cut along the
/// bisectors of corners that turn right; corners that turn left have a sector. These are all of the area if
/// none reaches further than half a step beyond its edge.
std::optional<double> smooth_area(const Rays& rays, double radius) {
  const std::size_t n = rays.x.size();
  std::vector<Vec2> edge(n);
  std::vector<double> length(n), inset(n, 0.0);  // by the corners at both ends of an edge
  double area = area_of(rays);
  for (std::size_t k = 0; k < n; ++k) {
    edge[k] = rays.after(k) - rays.x[k];
    length[k] = norm(edge[k]);
    edge[k] *= 1 / length[k];
    area += radius * length[k];
  }
  const auto within_half_step = [&](const Vec2& vertex, const Vec2& reach) {
    const Vec2 p = vertex + radius * reach;
    return std::abs(cross(vertex, p)) <= rays.tangent_half * dot(vertex, p);
  };
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t before = k > 0 ? k - 1 : n - 1;
    const double sine = cross(edge[before], edge[k]), cosine = dot(edge[before], edge[k]);
    const Vec2 in = -turned_left(edge[before]), out = -turned_left(edge[k]);
    if (sine >= 0) {
      if (!within_half_step(rays.x[k], in) || !within_half_step(rays.x[k], out)) return std::nullopt;
      area += 0.5 * radius * radius * std::atan2(sine, cosine);
      continue;
    }
    if (!(cosine > 0) || -sine * radius > std::min(length[before], length[k])) return std::nullopt;
    const double half = -sine / (1 + cosine);  // the tangent of half the angle
    if (!within_half_step(rays.x[k], out + half * edge[k])) return std::nullopt;
    inset[before] += half * radius;
    inset[k] += half * radius;
    area -= radius * radius * half;
  }
  for (std::size_t k = 0; k < n; ++k)
    if (inset[k] > length[k]) return std::nullopt;
  return area;
}

}  // namespace

std::optional<double> plain_area(std::span<const Vec2> ring, double radius, Outline outline) {
  if (ring.size() < 3) return std::nullopt;
  const Rays rays = rays_of(ring);
  if (!rays.follow) return std::nullopt;
  return outline == Outline::rough ? rough_area(rays, radius) : smooth_area(rays, radius);
}

}  // namespace supple
