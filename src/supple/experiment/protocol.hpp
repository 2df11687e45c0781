/// What happens to a prepared suspension: rest, shear gamma = A sin(2 pi f t), rest (physics section 7.2).
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "supple/solve/stepper.hpp"

namespace supple {

/// A whole number of steps per period, so that a cycle closes exactly.
struct OscillatoryProtocol {
  double amplitude = 0.2;
  double frequency = 1;  ///< [1/time]
  double pre_periods = 2, periods = 3, post_periods = 1;
  int steps_per_period = 1000;

  double time_step() const { return 1 / (frequency * steps_per_period); }
  std::int64_t pre_steps() const { return std::llround(pre_periods * steps_per_period); }
  std::int64_t shear_steps() const { return std::llround(periods * steps_per_period); }
  std::int64_t steps() const { return pre_steps() + shear_steps() + std::llround(post_periods * steps_per_period); }

  /// Strain at the beginning of step i, zero before and constant after the shear.
  double strain(std::int64_t i) const {
    const std::int64_t n = std::clamp<std::int64_t>(i - pre_steps(), 0, shear_steps());
    return amplitude * std::sin(phase(n));
  }
  /// The rate at the beginning of step i, and the mean rate over it, which makes the strain exact.
  ShearRates rates(std::int64_t i) const {
    const std::int64_t n = i - pre_steps();
    if (n < 0 || n > shear_steps()) return {};
    const double now = amplitude * 2 * std::numbers::pi * frequency * std::cos(phase(n));
    return {now, (strain(i + 1) - strain(i)) / time_step()};
  }

 private:
  double phase(std::int64_t n) const {
    return 2 * std::numbers::pi * static_cast<double>(n % steps_per_period) / steps_per_period;
  }
};

}  // namespace supple
