/// When frames are kept.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>

namespace supple {

/// Chooses `frames` of the instants 0 to last, evenly spaced, the first and the last included; one frame is
/// the last instant; all instants where there are fewer. due() must be asked for each instant in order.
class FrameSchedule {
 public:
  FrameSchedule(std::int64_t last, std::int64_t frames)
      : last_(last), intervals_(std::min(frames - 1, last)), next_(frames > 1 ? 0 : 1) {}

  /// Goes on at this instant, as if all before it had been asked for.
  void skip_to(std::int64_t instant) {
    while (instant > at(next_)) ++next_;
  }

  bool due(std::int64_t instant) {
    if (instant < at(next_)) return false;
    ++next_;
    return true;
  }

 private:
  std::int64_t at(std::int64_t k) const {
    if (intervals_ < 1) return last_;
    return std::llround(static_cast<double>(k) * static_cast<double>(last_) /
                        static_cast<double>(intervals_));
  }
  std::int64_t last_, intervals_, next_;
};

}  // namespace supple
