#include <algorithm>
#include <cmath>
#include <numbers>

#include "supple/geometry/curve.hpp"
#include "supple/geometry/disc_overlap.hpp"
#include "supple/geometry/inside.hpp"
#include "supple/geometry/polygon.hpp"
#include "supple/observe/packing_fraction.hpp"

namespace supple {
namespace {

using std::numbers::pi;

struct Disc {
  Vec2 centre;
  double radius;
  bool same_ring = false;  ///< as the disc in question
};

bool overlap(const Disc& a, const Disc& b) { return norm(b.centre - a.centre) < a.radius + b.radius; }

bool convex_of_equal_radii(const BodyShape& body) {
  constexpr double straight = -1e-9;
  if (body.is_disc()) return true;
  double turns = 0;
  for (int i = 0; i < body.size(); ++i) {
    const double turn = body.turn_at(i);
    if (turn < straight || body.radius[i] != body.radius[0]) return false;
    turns += turn;
  }
  return turns < 3 * pi;  // it goes round once
}

/// Area of body `b` alone, the parts added to `sum` [length^2].
double area_alone(const BodyShape& b, RoughSum& sum) {
  if (b.is_disc()) {
    const double disc = pi * b.radius[0] * b.radius[0];
    sum.vertices += disc;
    return disc;
  }
  const double polygon = polygon_area(b.ring);
  double vertices = 0, sectors = 0, pairs = 0;
  for (int i = 0; i < b.size(); ++i) {
    const double r = b.radius[i], other = b.radius[b.next(i)], edge = norm(b.ring[b.next(i)] - b.ring[i]);
    vertices += pi * r * r;
    sectors += 0.5 * r * r * (pi - b.turn_at(i));
    pairs += 0.5 *
             (overlap_share(r, other, edge) + overlap_share(other, r, edge));  // the half outside the polygon
  }
  sum.polygons += polygon;
  sum.vertices += vertices;
  sum.sectors += sectors;
  sum.pairs += pairs;
  return polygon + vertices - sectors - pairs;
}

/// Whether disc i meets more of its own ring than its two edges and neighbours, so that the sum is wrong.
bool meets_own_ring(const BodyShape& body, int i, bool convex) {
  for (int k = 0; k < body.size(); ++k) {
    if (k == i || k == body.previous(i)) continue;
    if (body.distance_to_edge(k, body.ring[i]) < body.radius[i]) {
      // Beyond an edge of a convex ring each point is counted as often as stretches of the chain of vertices
      // seen from there are within a radius: once, if it is within a radius of any vertex seen. Vertex i is
      // not seen. It adds nothing if each point of the edge is nearer to an end of the edge: if i is outside
      // the circle on that diameter.
      const Vec2 a = body.ring[k], b = body.ring[body.next(k)];
      if (!convex || norm(body.ring[i] - 0.5 * (a + b)) < 0.5 * norm(b - a)) return true;
    }
    const bool neighbour = k == body.next(i);
    if (!convex && !neighbour && norm(body.ring[k] - body.ring[i]) < body.radius[i] + body.radius[k])
      return true;
  }
  return false;
}

/// Whether disc i of `body`, or the edge that begins there, meets the polygon of another.
bool meets_polygon(const BodyShape& body, int i, const BodyShape& other, const Vec2& shift) {
  if (other.is_disc()) return false;
  const Vec2 x = body.ring[i] - shift;
  if (is_inside(x, other.ring)) return true;
  std::vector<double> crossings;
  for (int k = 0; k < other.size(); ++k) {
    if (other.distance_to_edge(k, x) < body.radius[i]) return true;
    if (!body.is_disc())
      append_crossings(Curve::segment(x, body.ring[body.next(i)] - shift),
                       Curve::segment(other.ring[k], other.ring[other.next(k)]), crossings);
  }
  return !crossings.empty();
}

/// Overlaps of site i with other bodies: what it loses by them, and whether the sum sees them right.
class SiteOverlaps {
 public:
  SiteOverlaps(std::span<const BodyShape> shapes) : shapes_(shapes) {}

  void measure(int body, int i, const std::vector<BodyImage>& near) {
    const BodyShape& own = shapes_[body];
    const Disc disc{own.ring[i], own.radius[i]};
    lost = 0;
    doubtful = false;
    overlapping_.clear();
    const Vec2 reach{disc.radius, disc.radius};
    Bounds bounds{disc.centre - reach, disc.centre + reach};
    bounds.include({own.ring[own.next(i)], own.ring[own.next(i)]});
    for (const BodyImage& image : near)
      if (image.bounds.meets(bounds)) meet(own, i, disc, shapes_[image.body], image.shift);
    if (overlapping_.empty()) return;
    for (int k = 0; k < own.size(); ++k)
      if (const Disc other{own.ring[k], own.radius[k], true}; k != i && overlap(disc, other))
        overlapping_.push_back(other);
    doubtful = doubtful || any_triple(disc);
  }

  double lost = 0;
  bool doubtful = false;

 private:
  void meet(const BodyShape& own, int i, const Disc& disc, const BodyShape& other, const Vec2& shift) {
    for (int j = 0; j < other.size(); ++j) {
      const Disc second{other.ring[j] + shift, other.radius[j]};
      if (!overlap(disc, second)) continue;
      lost += overlap_share(disc.radius, second.radius, norm(second.centre - disc.centre));
      overlapping_.push_back(second);
    }
    doubtful = doubtful || meets_polygon(own, i, other, shift);
  }
  bool any_triple(const Disc& disc) const {
    for (std::size_t j = 0; j < overlapping_.size(); ++j)
      for (std::size_t k = j + 1; k < overlapping_.size(); ++k) {
        const Disc &a = overlapping_[j], &b = overlapping_[k];
        if (!(a.same_ring && b.same_ring) && overlap(a, b) &&
            discs_have_common_point({disc.centre, a.centre, b.centre}, {disc.radius, a.radius, b.radius}))
          return true;
      }
    return false;
  }

  std::span<const BodyShape> shapes_;
  std::vector<Disc> overlapping_;
};

}  // namespace

RoughSum rough_sum(const System<2>& system) {
  const std::vector<BodyShape> shapes = body_shapes(system, Outline::rough);
  const ImageSearch search(shapes, system.box);
  RoughSum sum;
  SiteOverlaps overlaps(shapes);
  std::vector<BodyImage> near;
  for (int body = 0; body < static_cast<int>(shapes.size()); ++body) {
    const BodyShape& shape = shapes[body];
    double area = area_alone(shape, sum);
    const bool convex = convex_of_equal_radii(shape);
    search.find(body, near);
    for (int i = 0; i < shape.size(); ++i) {
      overlaps.measure(body, i, near);
      area -= overlaps.lost;
      sum.pairs += overlaps.lost;
      if (overlaps.doubtful || meets_own_ring(shape, i, convex)) ++sum.doubts;
    }
    sum.area.push_back(area);
    sum.total += area;
  }
  for (double* part : {&sum.total, &sum.polygons, &sum.vertices, &sum.sectors, &sum.pairs})
    *part /= system.box.volume();
  return sum;
}

}  // namespace supple
