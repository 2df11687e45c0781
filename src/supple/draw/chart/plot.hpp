/// The figures of a run: stress and strain against time, and the Lissajous loop.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "supple/observe/demodulate.hpp"

namespace supple {

/// One estimator of the shear stress with what was found from it.
struct StressEstimate {
  std::string name;                            ///< as the legend says it
  std::vector<double> stress;                  ///< at each time [Pa]
  double storage = 0, loss = 0;                ///< G', G'' [Pa]
  double storage_error = -1, loss_error = -1;  ///< [Pa]; negative: unknown
  double offset = 0,
         drift = 0;  ///< taken out of the loop: offset [Pa] + drift [Pa/s] times the time since shear began
};

struct OscillatoryPlot {
  std::vector<double> time, strain;                 ///< [s], [1]; time 0 is the start of the first rest
  std::vector<StressEstimate> stresses;             ///< the loops are those of the first
  Protocol protocol;                                ///< frequency [Hz]
  std::optional<double> stress_scale = {};          ///< stress axes from -scale to scale, to compare figures
  std::string time_unit = "s", stress_unit = "Pa";  ///< of what stands above in s, Hz and Pa; empty: reduced
};

/// Left: strain, and the stresses, against time, rest shaded. Right: the first stress against strain cycle by
/// cycle, freed of offset and drift, with each stress' ellipse of G' and G'', which stand above. Throws input
/// and file errors.
void plot_oscillatory(const std::string& path, const OscillatoryPlot& plot);

/// A stress against time, as the legend names it.
struct NamedStress {
  std::string name;
  std::vector<double> stress;  ///< [Pa]
};

struct DynamicsPlot {
  std::vector<double> time, strain;  ///< [s], [1]
  std::vector<NamedStress> stresses;
  std::vector<double> pressure;  ///< [Pa]; empty: not drawn
};

/// Strain (where it changes), shear stresses and pressure against time; where there is shear, stress against
/// strain.
void plot_dynamics(const std::string& path, const DynamicsPlot& plot);

}  // namespace supple
