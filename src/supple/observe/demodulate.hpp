/// Storage and loss modulus from a stress series under oscillatory shear.
#pragma once
#include <span>

namespace supple {

/// gamma = amplitude sin(2 pi (frequency t - pre)) for `periods`, after `pre` and before `post` periods of rest;
/// t = 0 is the start of the first rest, frequency [1/time].
struct Protocol {
  double frequency = 1, amplitude = 0.2;
  double pre = 2, periods = 3, post = 1;
};

/// How the drift between the rests before and after the shear is taken out: rightly, or with the reversed sign of the
/// published package (particleShear 1.0.2), which doubles it, and with its sums closed at both ends.
enum class DriftCorrection { right, published };

/// Stress = storage * gamma + loss * gamma'/omega + third harmonic + offset + drift; stresses in the series' unit.
struct Demodulation {
  double storage = 0, loss = 0;              ///< G', G''
  double storage_error = -1,
         loss_error = -1;                    ///< standard error of the mean over cycles; -1 with fewer than two cycles
  double in_phase = 0, out_of_phase = 0;     ///< amplitudes of sin and cos: G', G'' times the strain amplitude
  double third_amplitude = 0, third_phase = 0;  ///< third_amplitude * sin(3 phase + third_phase) [radian]
  double offset = 0;                         ///< of the rest before the shear, at the start of shear
  double drift = 0;                          ///< from the rest before to the rest after [stress/time]
};

/// Demodulates the part from one period after the start of shear (from the start itself if periods < 2) to its end;
/// offset and drift are means of the last third of the first and of the first third of the last rest.
///
/// `right` fits constant, first and third harmonic by least squares, samples weighted by the time they stand for, over
/// the last whole cycles (first harmonic only where there is not one): exact for such signals at any sampling, and for
/// even sampling the sums G' = sum tau sin / sum sin^2 / A. Without both rests no drift is removed.
/// `published` follows the package to rounding. Input errors: spans that differ in length, times that do not ascend,
/// numbers out of range, or too few samples.
Demodulation demodulate(std::span<const double> time, std::span<const double> stress, const Protocol& protocol,
                        DriftCorrection correction = DriftCorrection::right);

}  // namespace supple
