/// Rectangles and boxes along the axes, which hold shapes.
#pragma once
#include <algorithm>

#include "supple/core/vec.hpp"

namespace supple {

/// What lies between `low` and `high` in every direction, both included.
template <int Dim>
struct BoundsOf {
  Vec<Dim> low{}, high{};

  bool meets(const BoundsOf& b) const {
    for (int d = 0; d < Dim; ++d)
      if (!(low[d] <= b.high[d] && b.low[d] <= high[d])) return false;
    return true;
  }
  bool holds(const Vec<Dim>& x) const {
    for (int d = 0; d < Dim; ++d)
      if (!(low[d] <= x[d] && x[d] <= high[d])) return false;
    return true;
  }
  BoundsOf shifted(const Vec<Dim>& by) const { return {low + by, high + by}; }
  /// Larger by `reach` on every side.
  BoundsOf grown(double reach) const {
    BoundsOf b = *this;
    for (int d = 0; d < Dim; ++d) {
      b.low[d] -= reach;
      b.high[d] += reach;
    }
    return b;
  }
  /// Grows to hold `b`.
  void include(const BoundsOf& b) {
    for (int d = 0; d < Dim; ++d) {
      low[d] = std::min(low[d], b.low[d]);
      high[d] = std::max(high[d], b.high[d]);
    }
  }
  void include(const Vec<Dim>& x) { include(BoundsOf{x, x}); }
};
using Bounds = BoundsOf<2>;

/// What both hold; nothing (a low beyond a high) where they do not meet.
template <int Dim>
BoundsOf<Dim> common_part(const BoundsOf<Dim>& a, const BoundsOf<Dim>& b) {
  BoundsOf<Dim> both = a;
  for (int d = 0; d < Dim; ++d) {
    both.low[d] = std::max(a.low[d], b.low[d]);
    both.high[d] = std::min(a.high[d], b.high[d]);
  }
  return both;
}

}  // namespace supple
