/// Rectangles of a plane, sorted into tiles so that those at a point are found without a look at all of them.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "supple/geometry/bands.hpp"

namespace supple {

/// Equal tiles of the plane, each with the list of the rectangles that meet it. A tile is about as large as
/// the mean rectangle, and there are at most as many as rectangles.
class Tiles {
 public:
  /// Of rectangle k, x[k] and y[k] are the sides.
  Tiles(std::span<const Interval> x, std::span<const Interval> y)
      : x_(x), y_(y), begin_(x_.tiles * y_.tiles + 1, 0) {
    for_each_meeting(x, y, [&](std::size_t tile, std::int32_t) { ++begin_[tile + 1]; });
    for (std::size_t t = 1; t < begin_.size(); ++t) begin_[t] += begin_[t - 1];
    std::vector<std::int32_t> next(begin_.begin(), begin_.end() - 1);
    index_.resize(static_cast<std::size_t>(begin_.back()));
    for_each_meeting(x, y, [&](std::size_t tile, std::int32_t k) { index_[next[tile]++] = k; });
  }

  /// Ascending indices of the rectangles that meet the tile of (x, y): those that hold it, and a few others.
  std::span<const std::int32_t> at(double x, double y) const {
    const std::size_t tile = x_.tile(x) * y_.tiles + y_.tile(y);
    return {index_.data() + begin_[tile], static_cast<std::size_t>(begin_[tile + 1] - begin_[tile])};
  }

 private:
  /// How one side of the plane is cut.
  struct Axis {
    double low = 0, width = 0;
    std::size_t tiles = 1;

    explicit Axis(std::span<const Interval> sides) {
      if (sides.empty()) return;
      const auto count = static_cast<double>(sides.size());
      double high = sides[0].high, mean = 0;
      low = sides[0].low;
      for (const Interval& i : sides) {
        low = std::min(low, i.low);
        high = std::max(high, i.high);
        mean += (i.high - i.low) / count;
      }
      if (mean > 0)
        tiles =
            static_cast<std::size_t>(std::clamp((high - low) / mean, 1.0, std::max(1.0, std::sqrt(count))));
      width = (high - low) / static_cast<double>(tiles);
    }
    std::size_t tile(double at) const {
      return width > 0 ? static_cast<std::size_t>(
                             std::clamp((at - low) / width, 0.0, static_cast<double>(tiles) - 1))
                       : 0;
    }
  };

  template <class F>
  void for_each_meeting(std::span<const Interval> x, std::span<const Interval> y, const F& f) const {
    for (std::size_t k = 0; k < x.size(); ++k)
      for (std::size_t i = x_.tile(x[k].low); i <= x_.tile(x[k].high); ++i)
        for (std::size_t j = y_.tile(y[k].low); j <= y_.tile(y[k].high); ++j)
          f(i * y_.tiles + j, static_cast<std::int32_t>(k));
  }

  Axis x_, y_;
  std::vector<std::int32_t> begin_, index_;  ///< where each tile begins; the rectangles of all tiles
};

}  // namespace supple
