/// What both ways of demodulating share: series, phases, and what cycles say of their mean.
#pragma once
#include <cmath>
#include <numbers>
#include <vector>

#include "supple/core/error.hpp"
#include "supple/observe/demodulate.hpp"

namespace supple {

struct Sample {
  double time, stress;
};
using Series = std::vector<Sample>;

inline double phase_of(const Protocol& p, double time) {
  return 2 * std::numbers::pi * (time * p.frequency - p.pre);
}

/// Periods from the start of shear to the first that is measured: the first is transient.
inline double first_measured(const Protocol& p) { return p.periods >= 2 ? 1 : 0; }

/// Error and change per cycle from the values of the cycles; the value is for the caller to set.
Modulus modulus_of_cycles(const std::vector<double>& cycles);

/// The package's sums. Sets all but the values of the moduli.
Demodulation project_as_published(Series series, const Protocol& p);

inline Error too_few_samples() {
  return input_error("the stress cannot be demodulated", "too few samples in a cycle",
                     "take a smaller [time] step or step_factor");
}

}  // namespace supple
