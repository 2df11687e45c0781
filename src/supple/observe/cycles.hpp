/// What ways of demodulating share: series, phases, and what cycles say of their mean.
#pragma once
#include <cmath>
#include <numbers>
#include <vector>

#include "supple/core/error.hpp"
#include "supple/observe/demodulate.hpp"

namespace supple {

using Series = std::vector<StressSample>;

/// Phase 2 pi (frequency t - pre) of the oscillation at a time [radian].
inline double phase_of(const Protocol& p, double time) {
  return 2 * std::numbers::pi * (time * p.frequency - p.pre);
}

/// Periods of shear that are not measured: the first one, which is transient, where there are at least two.
inline double first_measured(const Protocol& p) { return p.periods >= 2 ? 1 : 0; }

/// Error and change per cycle of a modulus from its values in the cycles (docs/theory/microgel.md,
/// Demodulation). Does not set `value`.
Modulus modulus_of_cycles(const std::vector<double>& cycles);

inline Error too_few_samples() {
  return input_error("the stress cannot be demodulated", "too few samples in a cycle",
                     "take a smaller [time] step or step_factor");
}

}  // namespace supple
