/// Segments and arcs, of which outlines are made: where they cross, and the area that they enclose.
#pragma once
#include <vector>

#include "supple/core/vec.hpp"
#include "supple/geometry/bounds.hpp"

namespace supple {

/// A segment, or an arc where `radius` > 0; the parameter t runs from 0 at its begin to 1 at its end.
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
  /// Half the integral of the cross product (x - origin) x dx from t0 to t1 [length^2]. Its sum over a closed
  /// counter-clockwise outline is the area within.
  double swept_area(const Vec2& origin, double t0, double t1) const;
  /// A rectangle that holds the curve (of an arc: the whole circle), a little larger, so that rounding hides
  /// no touch.
  Bounds bounds() const;
};

/// Appends the t of `a` at which it meets `b`, for cutting `a` into pieces that do not cross `b`. No crossing
/// is missed because of rounding; some points may be none (ends that touch; an arc `b` counts as its whole
/// circle).
void append_crossings(const Curve& a, const Curve& b, std::vector<double>& t);

}  // namespace supple
