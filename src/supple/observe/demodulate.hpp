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

/// A stress at an instant of a series.
struct StressSample {
  double time, stress;
};

/// A way to demodulate a series that was checked. It sets all but the values of the moduli, which follow from
/// the amplitudes.
using Demodulator = Demodulation (*)(std::vector<StressSample>, const Protocol&);

/// Fits offset, ramp and harmonics together by least squares over these cycles, samples weighted by
/// the time they stand for; the rests have no part in it. Harmonics: the first to the fifth, as far as the
/// sampling allows; first and third in a single cycle, where a ramp cannot be told from more. Exact for such
/// signals at any sampling; for even sampling G' = sum tau sin / sum sin^2 / A, tau without its ramp.
/// Input errors: less than one period, or too few samples.
Demodulation fit_harmonics(std::vector<StressSample> series, const Protocol& protocol);

/// Demodulates the whole cycles from one period after the start of shear (from the start itself if periods <
/// 2) that end with it. Input errors: spans that differ in length, times that do not ascend, numbers out of
/// range, and those of the demodulator.
Demodulation demodulate(std::span<const double> time, std::span<const double> stress,
                        const Protocol& protocol, Demodulator demodulator = fit_harmonics);

/// Samples that a cycle needs: as many as unknowns, seven up to the third harmonic and one for the ramp.
inline constexpr int least_samples_of_cycle = 8;

}  // namespace supple
