/// Segments and arcs of which outlines are made: crossings, and the area that they enclose.
#pragma once
#include <vector>

#include "supple/core/vec.hpp"

namespace supple {

/// A rectangle along the axes.
struct Bounds {
  Vec2 low{}, high{};

  bool meets(const Bounds& b) const {
    return low[0] <= b.high[0] && b.low[0] <= high[0] && low[1] <= b.high[1] && b.low[1] <= high[1];
  }
  bool holds(const Vec2& x) const {
    return low[0] <= x[0] && x[0] <= high[0] && low[1] <= x[1] && x[1] <= high[1];
  }
  Bounds shifted(const Vec2& by) const { return {low + by, high + by}; }
  /// Grows it to hold `b`.
  void include(const Bounds& b);
};

/// A segment, or an arc where `radius` > 0; t runs through it from 0 to 1.
struct Curve {
  Vec2 from{}, along{};  ///< segment: from + t along
  Vec2 centre{};         ///< arc: about this point, from angle `begin` by `sweep` > 0
  double radius = 0, begin = 0, sweep = 0;

  static Curve segment(const Vec2& a, const Vec2& b) { return {a, b - a, {}, 0, 0, 0}; }
  static Curve arc(const Vec2& centre, double radius, double begin, double sweep) {
    return {{}, {}, centre, radius, begin, sweep};
  }
  static Curve circle(const Vec2& centre, double radius);

  bool straight() const { return !(radius > 0); }
  Vec2 at(double t) const;
  /// 1/2 of the integral of (x - origin) x dx over [t0, t1]: summed over a closed outline, the area within
  /// it.
  double swept_area(const Vec2& origin, double t0, double t1) const;
  /// A rectangle that holds it, a little larger, so that rounding hides no touch; for an arc, of its whole
  /// circle.
  Bounds bounds() const;
};

/// Appends the t at which `a` meets `b`. It never misses a crossing for rounding, and may add points that are
/// none (touching ends; an arc `b` counts as its circle): for cutting `a` into pieces that do not cross `b`.
void append_crossings(const Curve& a, const Curve& b, std::vector<double>& t);

}  // namespace supple
