/// Storage and loss modulus from a series of stresses under oscillatory shear.
#pragma once
#include <span>
#include <vector>

namespace supple {

/// The strain is amplitude sin(2 pi (frequency t - pre)) for `periods` periods, with `pre` periods of rest
/// before and `post` after. t = 0 is the start of the first rest; frequency [1/time].
struct Protocol {
  double frequency = 1, amplitude = 0.2;
  double pre = 2, periods = 3, post = 1;
};

/// How drift is taken out. `right`: fitted together with the harmonics. `published`: as particleShear 1.0.2
/// does it, from the rests before and after, with the wrong sign, which doubles the drift, and with sums that
/// hold both ends of the window.
enum class DriftCorrection { right, published };

/// A modulus, the mean over the measured cycles, and its error: how far many more cycles of the same sample
/// might lead. The error is the root of the sum of two squares: the standard error of the mean times
/// student_factor(), and the change over the measured cycles, as samples age. Twice the error is meant to
/// cover 95 %; docs/statistics.md says how often it does.
struct Modulus {
  double value = 0, error = -1;          ///< -1 with fewer than three cycles
  double change = 0, change_error = -1;  ///< per cycle, by the straight line through the cycles; -1 as above
  bool drifts() const {
    return change_error >= 0 && (change > 2 * change_error || -change > 2 * change_error);
  }
};

/// Stress = storage * gamma + loss * (dgamma/dt)/omega + higher harmonics + offset + drift * (t - start of
/// shear), with omega = 2 pi frequency. Stresses and moduli are in the unit of the series.
struct Demodulation {
  Modulus storage, loss;                        ///< G', G''
  double in_phase = 0, out_of_phase = 0;        ///< of sin and cos: G', G'' times the strain amplitude
  double third_amplitude = 0, third_phase = 0;  ///< third_amplitude * sin(3 phase + third_phase) [radian]
  double offset = 0;                            ///< stress without strain at the start of shear
  double drift = 0;                             ///< [stress/time]
  int cycles = 0;                               ///< whole cycles that were measured
};

/// Demodulates whole cycles: those that end with the shear and begin at least one period after its start (if
/// periods < 2, after the start itself).
///
/// `right` fits offset, ramp and harmonics together by least squares over these cycles; a sample weighs as
/// much as the time it stands for, and the rests have no part. Harmonics: the first to the fifth, as far as
/// the sampling allows; in a single cycle, where a ramp cannot be told from more, the first and the third.
/// The fit is exact for such signals at any sampling. For even sampling G' = sum tau sin / sum sin^2 / A, tau
/// without its ramp. `published` follows the package to rounding, from one period after the start of shear to
/// its end, whole cycles or not. Input errors: spans of different length, times that do not ascend, numbers
/// out of range, less than one period, too few samples.
Demodulation demodulate(std::span<const double> time, std::span<const double> stress,
                        const Protocol& protocol, DriftCorrection correction = DriftCorrection::right);

/// Samples that a cycle needs: as many as unknowns, seven up to the third harmonic and one for the ramp.
inline constexpr int least_samples_of_cycle = 8;

}  // namespace supple
