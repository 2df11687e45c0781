/// Intervals of a line, sorted into bands so that those at a point are found without a look at all of them.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace supple {

/// A closed interval of a line.
struct Interval {
  double low, high;
};

/// Equal bands of the line, each with the list of the intervals that meet it. There are at most as many bands
/// as intervals, and none is narrower than the mean interval: the lists hold at most three numbers for each
/// interval.
class Bands {
 public:
  explicit Bands(std::span<const Interval> intervals) {
    double high = 0, mean = 0;
    for (const Interval& i : intervals) {
      low_ = begin_.empty() ? i.low : std::min(low_, i.low);
      high = begin_.empty() ? i.high : std::max(high, i.high);
      begin_ = {0};
      mean += (i.high - i.low) / static_cast<double>(intervals.size());
    }
    const double most = std::max<double>(1, static_cast<double>(intervals.size()));
    const double bands = mean > 0 ? std::clamp((high - low_) / mean, 1.0, most) : 1;
    width_ = (high - low_) / std::floor(bands);
    begin_.assign(static_cast<std::size_t>(bands) + 1, 0);
    for (const Interval& i : intervals)
      for (std::size_t b = band_of(i.low); b <= band_of(i.high); ++b) ++begin_[b + 1];
    for (std::size_t b = 1; b < begin_.size(); ++b) begin_[b] += begin_[b - 1];
    std::vector<std::int32_t> next(begin_.begin(), begin_.end() - 1);
    index_.resize(static_cast<std::size_t>(begin_.back()));
    for (std::size_t k = 0; k < intervals.size(); ++k)
      for (std::size_t b = band_of(intervals[k].low); b <= band_of(intervals[k].high); ++b)
        index_[static_cast<std::size_t>(next[b]++)] = static_cast<std::int32_t>(k);
  }

  /// Ascending indices of the intervals that meet the band of x: those that hold x, and a few others.
  std::span<const std::int32_t> at(double x) const { return band(band_of(x)); }

  /// f(index) for each interval that meets a band of low .. high: those that meet low .. high, and a few
  /// others, each once, in no order. `intervals` are those of the constructor.
  template <class F>
  void for_each_meeting(double low, double high, std::span<const Interval> intervals, const F& f) const {
    for (std::size_t b = band_of(low); b <= band_of(high); ++b)
      for (const std::int32_t k : band(b))
        if (b == std::max(band_of(low), band_of(intervals[static_cast<std::size_t>(k)].low))) f(k);
  }

 private:
  std::size_t band_of(double x) const {
    const double last = static_cast<double>(begin_.size()) - 2;
    return width_ > 0 && last > 0 ? static_cast<std::size_t>(std::clamp((x - low_) / width_, 0.0, last)) : 0;
  }
  std::span<const std::int32_t> band(std::size_t b) const {
    return {index_.data() + begin_[b], static_cast<std::size_t>(begin_[b + 1] - begin_[b])};
  }

  double low_ = 0, width_ = 0;
  std::vector<std::int32_t> begin_, index_;  ///< where each band begins; the intervals of all bands
};

}  // namespace supple
