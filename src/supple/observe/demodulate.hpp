/// Storage and loss modulus from a stress series under oscillatory shear.
#pragma once
#include <span>
#include <vector>

namespace supple {

/// gamma = amplitude sin(2 pi (frequency t - pre)) for `periods`, after `pre` and before `post` periods of
/// rest; t = 0 is the start of the first rest, frequency [1/time].
struct Protocol {
  double frequency = 1, amplitude = 0.2;
  double pre = 2, periods = 3, post = 1;
};

/// How drift is taken out: fitted together with the harmonics; or as the published package does
/// (particleShear 1.0.2), from the rests before and after, with the reversed sign, which doubles it, and with
/// its sums closed at both ends.
enum class DriftCorrection { right, published };

/// A modulus: mean of the measured cycles. The error is of what many more cycles of the same sample would
/// give: the standard error of the mean times Student's factor, so that twice it covers 95 % where cycles
/// scatter, and beside it (as squares) the change over the measured cycles, as samples age
/// (docs/statistics.md: how often it covers).
struct Modulus {
  double value = 0, error = -1;          ///< -1 with fewer than three cycles
  double change = 0, change_error = -1;  ///< per cycle, by the straight line through the cycles; -1 as above
  bool drifts() const {
    return change_error >= 0 && (change > 2 * change_error || -change > 2 * change_error);
  }
};

/// Stress = storage * gamma + loss * gamma'/omega + higher harmonics + offset + drift; stresses in the
/// series' unit.
struct Demodulation {
  Modulus storage, loss;                  ///< G', G''
  double in_phase = 0, out_of_phase = 0;  ///< amplitudes of sin and cos: G', G'' times the strain amplitude
  double third_amplitude = 0, third_phase = 0;  ///< third_amplitude * sin(3 phase + third_phase) [radian]
  double offset = 0;                            ///< at the start of shear
  double drift = 0;                             ///< [stress/time]
  int cycles = 0;                               ///< whole cycles that were measured
};

/// Demodulates the whole cycles from one period after the start of shear (from the start itself if periods <
/// 2) that end with it.
///
/// `right` fits offset, ramp and harmonics together by least squares over these cycles, samples weighted by
/// the time they stand for; the rests have no part in it. Harmonics: the first to the fifth, as far as the
/// sampling allows; first and third in a single cycle, where a ramp cannot be told from more. Exact for such
/// signals at any sampling; for even sampling G' = sum tau sin / sum sin^2 / A, tau without its ramp.
/// `published` follows the package to rounding, from one period after the start to the end, whole cycles or
/// not. Input errors: spans that differ in length, times that do not ascend, numbers out of range, less than
/// one period, or too few samples.
Demodulation demodulate(std::span<const double> time, std::span<const double> stress,
                        const Protocol& protocol, DriftCorrection correction = DriftCorrection::right);

/// Samples that a cycle needs: seven unknowns up to the third harmonic, and the ramp.
inline constexpr int least_samples_of_cycle = 8;

}  // namespace supple
