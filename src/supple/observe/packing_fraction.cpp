#include "supple/observe/packing_fraction.hpp"

#include <algorithm>
#include <cmath>

#include "supple/geometry/bands.hpp"
#include "supple/geometry/curve.hpp"
#include "supple/geometry/inside.hpp"
#include "supple/geometry/polygon.hpp"

namespace supple {
namespace {

/// The part of its body that a curve of an outline belongs to; that part cannot cover the curve.
enum class Source { disc, edge, offset_edge, corner };

struct OutlineCurve {
  Curve curve;
  Source source;
  int site;  ///< the disc, the corner, or the first site of the edge
  Bounds bounds;
};

/// An uncovered piece t0 .. t1 of a curve.
struct Piece {
  const OutlineCurve* on;
  double t0, t1;
};

/// Curves that together hold the outline of a body; parts of them may lie inside the body.
std::vector<OutlineCurve> outline_curves(const BodyShape& body, Outline outline) {
  std::vector<OutlineCurve> curves;
  const auto add = [&](const Curve& curve, Source source, int site) {
    curves.push_back({curve, source, site, curve.bounds()});
  };
  for (int i = 0; i < body.size(); ++i) {
    const Vec2 &x = body.ring[i], edge = body.ring[body.next(i)] - x;
    const double radius = body.radius[i], length = norm(edge);
    if (body.is_disc() || outline == Outline::rough) {
      if (radius > 0) add(Curve::circle(x, radius), Source::disc, i);
      if (length > 0) add(Curve::segment(x, x + edge), Source::edge, i);
      continue;
    }
    const Vec2 out = (-1 / length) * turned_left(edge);
    add(Curve::segment(x + radius * out, x + radius * out + edge), Source::offset_edge, i);
    const double turn = body.turn_at(i);
    if (radius > 0 && turn > 0)
      add(Curve::arc(x, radius, std::atan2(out[1], out[0]) - turn, turn), Source::corner, i);
  }
  return curves;
}

/// Heights between which each edge of a ring may cover a point, with the discs at its ends.
std::vector<Interval> heights_of_edges(const BodyShape& body, double tolerance) {
  double reach = tolerance;
  for (const double radius : body.radius) reach = std::max(reach, radius);
  std::vector<Interval> heights;
  for (int k = 0; k < body.size(); ++k) {
    const double a = body.ring[k][1], b = body.ring[body.next(k)][1];
    heights.push_back({std::min(a, b) - reach, std::max(a, b) + reach});
  }
  return heights;
}

/// What the curves take up in direction d.
std::vector<Interval> extents_of(const std::vector<OutlineCurve>& curves, int d) {
  std::vector<Interval> extents;
  for (const OutlineCurve& c : curves) extents.push_back({c.bounds.low[d], c.bounds.high[d]});
  return extents;
}

/// A body, and whether it covers points. It does not cover points on its outline, to within `tolerance`, so
/// that bodies which only touch keep both outlines.
class Body {
 public:
  Body(const BodyShape& shape, Outline outline, double tolerance)
      : shape_(shape),
        outline_(outline),
        tolerance_(tolerance),
        curves_(outline_curves(shape, outline)),
        edges_(heights_of_edges(shape, tolerance)) {}

  const BodyShape& shape() const { return shape_; }
  const std::vector<OutlineCurve>& curves() const { return curves_; }

  bool covers(const Vec2& x) const { return shape_.bounds.holds(x) && (reached(x, -1, -1) || in_polygon(x)); }
  /// Whether x, a point of its own curve, lies inside the body.
  bool covers_own(const Vec2& x, const OutlineCurve& on) const {
    if (shape_.is_disc()) return false;
    const int k = on.site, before = shape_.previous(k), after = shape_.next(k);
    switch (on.source) {  // most of what is covered is so by what is next on the ring
      case Source::edge: return reaches(k, x) || reaches(after, x) || reached(x, -1, -1);
      case Source::corner:
        return reaches(after, x) || reaches(shape_.previous(before), x) || reached(x, before, k) ||
               in_polygon(x);
      default: return reaches(after, x) || reaches(before, x) || reached(x, k, k) || in_polygon(x);
    }
  }

 private:
  /// Whether x is within the radius of a site (rough) or of an edge (smooth) other than these two.
  bool reached(const Vec2& x, int except, int or_except) const {
    for (const std::int32_t k : edges_.at(x[1]))
      if (k != except && k != or_except && reaches(k, x)) return true;
    return false;
  }
  /// Whether x is within the radius of this site (rough) or edge (smooth).
  bool reaches(int k, const Vec2& x) const {
    const bool discs = shape_.is_disc() || outline_ == Outline::rough;
    const double distance = discs ? norm(x - shape_.ring[k]) : shape_.distance_to_edge(k, x);
    return distance < shape_.radius[k] - tolerance_;
  }
  bool in_polygon(const Vec2& x) const {
    if (shape_.is_disc()) return false;
    int winding = 0;
    for (const std::int32_t k : edges_.at(x[1])) {
      const Vec2 &a = shape_.ring[k], &b = shape_.ring[shape_.next(k)];
      const bool is_near =
          std::min(a[0], b[0]) - tolerance_ <= x[0] && x[0] <= std::max(a[0], b[0]) + tolerance_;
      if (is_near && shape_.distance_to_edge(k, x) <= tolerance_) return false;
      winding += ray_crossing(x, a, b);
    }
    return winding != 0;
  }

  const BodyShape& shape_;
  Outline outline_;
  double tolerance_;
  std::vector<OutlineCurve> curves_;
  Bands edges_;  ///< by height
};

/// Sorts the cuts of a curve and adds its two ends.
void finish_cuts(std::vector<double>& cuts) {
  cuts.insert(cuts.end(), {0.0, 1.0});
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
}

/// The outline of one body alone.
std::vector<Piece> own_outline(const Body& body) {
  std::vector<Piece> pieces;
  std::vector<double> cuts;
  const std::vector<Interval> heights = extents_of(body.curves(), 1), widths = extents_of(body.curves(), 0);
  const Bands bands(heights);
  for (const OutlineCurve& a : body.curves()) {
    cuts.clear();
    bands.for_each_meeting(a.bounds.low[1], a.bounds.high[1], heights, [&](std::int32_t k) {
      if (widths[k].high < a.bounds.low[0] || a.bounds.high[0] < widths[k].low)
        return;  // most, of a long list
      const OutlineCurve& b = body.curves()[k];
      if (&a != &b && a.bounds.meets(b.bounds)) append_crossings(a.curve, b.curve, cuts);
    });
    finish_cuts(cuts);
    for (std::size_t c = 0; c + 1 < cuts.size(); ++c)
      if (!body.covers_own(a.curve.at(0.5 * (cuts[c] + cuts[c + 1])), a))
        pieces.push_back({&a, cuts[c], cuts[c + 1]});
  }
  return pieces;
}

Curve shifted(Curve curve, const Vec2& by) {
  curve.from += by;
  curve.centre += by;
  return curve;
}

/// Sums the area of every body b, the integral of 1/(number of bodies that cover a point) over the points of
/// b. It is the integral over all outlines of the jump of that function: on the outline of b, where n others
/// cover it, from 1/(n+1) to 0; on the outline of another within b from 1/(n+1) to 1/n.
class Sharing {
 public:
  Sharing(const std::vector<Body>& bodies, std::vector<double>& area) : bodies_(bodies), area_(area) {}

  void add(int body, const Piece& piece, const std::vector<BodyImage>& near) {
    cuts_.clear();
    for (const BodyImage& image : near)
      if (image.bounds.meets(piece.on->bounds)) cut(piece, image);
    std::erase_if(cuts_, [&](double t) { return t < piece.t0 || t > piece.t1; });
    cuts_.insert(cuts_.end(), {piece.t0, piece.t1});
    std::sort(cuts_.begin(), cuts_.end());
    for (std::size_t c = 0; c + 1 < cuts_.size(); ++c)
      if (cuts_[c] < cuts_[c + 1]) add_part(body, piece.on->curve, cuts_[c], cuts_[c + 1], near);
  }

 private:
  void cut(const Piece& piece, const BodyImage& image) {
    for (const OutlineCurve& other : bodies_[image.body].curves())
      if (piece.on->bounds.meets(other.bounds.shifted(image.shift)))
        append_crossings(piece.on->curve, shifted(other.curve, image.shift), cuts_);
  }

  void add_part(int body, const Curve& curve, double t0, double t1, const std::vector<BodyImage>& near) {
    const Vec2 x = curve.at(0.5 * (t0 + t1));
    covering_.clear();
    for (const BodyImage& image : near)
      if (bodies_[image.body].covers(x - image.shift)) covering_.push_back(&image);
    const double others = static_cast<double>(covering_.size()), inside = 1 / (others + 1);
    area_[body] += inside * curve.swept_area(middle(body), t0, t1);
    for (const BodyImage* image : covering_)
      area_[image->body] +=
          (inside - 1 / others) * curve.swept_area(middle(image->body) + image->shift, t0, t1);
  }

  Vec2 middle(int body) const { return bodies_[body].shape().ring[0]; }

  const std::vector<Body>& bodies_;
  std::vector<double>& area_;
  std::vector<double> cuts_;
  std::vector<const BodyImage*> covering_;
};

}  // namespace

PackingFraction packing_fraction(const System<2>& system, Outline outline) {
  const std::vector<BodyShape> shapes = body_shapes(system, outline);
  const ImageSearch search(shapes, system.box);
  const Bounds all = bounds_of(shapes);
  const double tolerance = 1e-12 * (norm(all.high - all.low) + norm(system.box.length));
  std::vector<Body> bodies;
  bodies.reserve(shapes.size());
  for (const BodyShape& shape : shapes) bodies.emplace_back(shape, outline, tolerance);

  PackingFraction fraction;
  fraction.volume.resize(bodies.size());
  Sharing sharing(bodies, fraction.volume);
  std::vector<BodyImage> near;
  for (int body = 0; body < static_cast<int>(bodies.size()); ++body) {
    search.find(body, near);
    for (const Piece& piece : own_outline(bodies[body])) sharing.add(body, piece, near);
  }
  for (const double area : fraction.volume) fraction.total += area;
  fraction.total /= system.box.volume();
  return fraction;
}

}  // namespace supple
