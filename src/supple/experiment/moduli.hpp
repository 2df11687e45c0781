/// Results of an oscillatory run: moduli by every estimator, contacts, pressure.
#pragma once
#include <optional>

#include "supple/experiment/stress_table.hpp"
#include "supple/observe/demodulate.hpp"

namespace supple {

/// A sheared slab between plates: its height [m] and density, mass over area of the cell [kg/m^3]. Between
/// plates that move against each other, shear waves of speed c = sqrt(G'/density) resonate at the frequency
/// c/height.
struct Gap {
  double height = 0, density = 0;
  double wavelengths(double storage, double frequency) const;  ///< wavelength over height; G' [Pa], f [Hz]
};
Gap gap_of(const System<2>& system, const Units& units);

/// A wavelength below this many heights counts as near the resonance: the stress then varies from plate to
/// plate.
inline constexpr double short_wavelength = 1.5;

/// A series of stresses, and which stress it is.
struct StressSeries {
  std::string name, meaning, unit;
  std::vector<double> time, stress;
};
/// Values in the group "results": storage_modulus_NAME, loss_modulus_NAME, their changes from cycle to cycle,
/// and the harmonics.
Demodulation record_modulus(const StressSeries& series, const Protocol& protocol, Demodulator demodulator,
                            Recorder& recorder);

/// The spans of a run that was stopped after these times, with the whole cycles that it has; nullopt where it
/// has none.
std::optional<Protocol> whole_cycles(Protocol protocol, const std::vector<double>& time);

/// The moduli from one of several stresses of the same sample.
struct Estimate {
  std::string name, unit;
  Demodulation found;
};
/// Warns where G' or G'' of the two estimates differ by more than 30 %. Each modulus is compared by itself,
/// as |G*| would hide a loss that only one of them sees.
void warn_if_apart(const Estimate& a, const Estimate& b, const std::string& why, Recorder& recorder);
/// Warns where a modulus goes on changing from cycle to cycle.
void warn_of_drift(const Estimate& e, Recorder& recorder);

/// Records storage_modulus_X, loss_modulus_X, ... in the group "results" for X = plates (if there are
/// plates), virial, periodic, and the published internal, external and external_corrected. Warns where
/// estimates differ, where cycles drift, where the jump correction is large, and near the resonance of the
/// gap.
void record_moduli(const StressTable& table, const Protocol& protocol, Demodulator demodulator,
                   const Gap& gap, Recorder& recorder);

/// Records the numbers of contacts, links and plate discs at the end.
void record_counts(const System<2>& system, const Evaluation<2>& evaluation, Recorder& recorder);

}  // namespace supple
