/// What happens to a prepared sample in oscillatory shear: rest, shear gamma = A sin(2 pi f t) with t from
/// its start, rest.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "supple/solve/stepper.hpp"

namespace supple {

/// The protocol in steps: a whole number in a period, so that a cycle closes exactly, and in the rests and
/// the shear, whose lengths are rounded to steps.
struct OscillatoryProtocol {
  double amplitude = 0.2;
  double frequency = 1;  ///< [1/time]
  std::int64_t steps_per_period = 1000, pre_steps = 2000, shear_steps = 3000, post_steps = 1000;

  void keep(Keeper& k) {
    k("amplitude", amplitude);
    k("frequency", frequency);
    k("steps_per_period", steps_per_period);
    k("pre_steps", pre_steps);
    k("shear_steps", shear_steps);
    k("post_steps", post_steps);
  }

  double time_step() const { return 1 / (frequency * static_cast<double>(steps_per_period)); }
  std::int64_t steps() const { return pre_steps + shear_steps + post_steps; }
  double periods(std::int64_t n) const {
    return static_cast<double>(n) / static_cast<double>(steps_per_period);
  }

  /// Strain at the beginning of step i; zero before the shear and constant after it.
  double strain(std::int64_t i) const {
    return amplitude * std::sin(phase(std::clamp<std::int64_t>(i - pre_steps, 0, shear_steps)));
  }
  /// The strain rate at the beginning of step i [1/time], and the mean rate over the step, which makes the
  /// strain exact.
  ShearRates rates(std::int64_t i) const {
    const std::int64_t n = i - pre_steps;
    if (n < 0 || n > shear_steps) return {};
    const double now = amplitude * 2 * std::numbers::pi * frequency * std::cos(phase(n));
    return {now, (strain(i + 1) - strain(i)) / time_step()};
  }

 private:
  double phase(std::int64_t n) const {
    return 2 * std::numbers::pi * static_cast<double>(n % steps_per_period) /
           static_cast<double>(steps_per_period);
  }
};

}  // namespace supple
