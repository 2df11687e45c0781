/// The figures of a run: stress and strain against time, and the Lissajous loop.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "supple/observe/demodulate.hpp"

namespace supple {

/// One estimator of the shear stress with what was found from it.
struct StressEstimate {
  std::vector<double> stress;  ///< at each time [Pa]
  double storage = 0, loss = 0;                ///< G', G'' [Pa]
  double storage_error = -1, loss_error = -1;  ///< [Pa]; negative: unknown
  double offset = 0, drift = 0;  ///< taken out of the loop: offset [Pa] + drift [Pa/s] times the time since shear began
};

struct OscillatoryPlot {
  std::vector<double> time, strain;  ///< [s], [1]; time 0 is the start of the first rest
  StressEstimate internal, external;
  Protocol protocol;                 ///< frequency [Hz]
  std::optional<double> stress_scale = {};  ///< stress axes from -scale to scale [Pa], to compare figures
};

/// Left: strain, and both stresses, against time, rest shaded. Right: stress against strain cycle by cycle, freed of
/// offset and drift, with the ellipses of G' and G'', which stand above. Throws input and file errors.
void plot_oscillatory(const std::string& path, const OscillatoryPlot& plot);

struct DynamicsPlot {
  std::vector<double> time, strain;                 ///< [s], [1]
  std::vector<double> internal, external, pressure; ///< [Pa]; empty: not drawn
};

/// Strain (where it changes), shear stresses and pressure against time; where there is shear, stress against strain.
void plot_dynamics(const std::string& path, const DynamicsPlot& plot);

}  // namespace supple
