/// The figures of a run: stress and strain against time, and the Lissajous loop.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "supple/observe/demodulate.hpp"

namespace supple {

/// One estimate of the shear stress, with the moduli found from it.
struct StressEstimate {
  std::string name;                            ///< as the legend says it
  std::vector<double> stress;                  ///< at each time [Pa]
  double storage = 0, loss = 0;                ///< G', G'' [Pa]
  double storage_error = -1, loss_error = -1;  ///< [Pa]; negative: unknown
  double offset = 0,
         drift = 0;  ///< taken out of the loop: offset [Pa] + drift [Pa/s] times the time since shear began
};

/// What the figure of an oscillatory run shows.
struct OscillatoryPlot {
  std::vector<double> time, strain;                 ///< [s], [1]; time 0 is the start of the first rest
  std::vector<StressEstimate> stresses;             ///< the loops are those of the first
  Protocol protocol;                                ///< frequency [Hz]
  std::optional<double> stress_scale = {};          ///< stress axes from -scale to scale, to compare figures
  std::string time_unit = "s", stress_unit = "Pa";  ///< of what stands above in s, Hz and Pa; empty: reduced
};

/// Draws, on the left, strain and stresses against time, with the rests shaded; on the right, the first
/// stress less offset and drift against strain, cycle by cycle, with the ellipse of G' and G'' of every
/// stress. The moduli stand above. Throws input and file errors.
void plot_oscillatory(const std::string& path, const OscillatoryPlot& plot);

/// A stress against time, with its name in the legend.
struct NamedStress {
  std::string name;
  std::vector<double> stress;  ///< [Pa]
};

/// What the figure of any other run in shear shows.
struct DynamicsPlot {
  std::vector<double> time, strain;  ///< [s], [1]
  std::vector<NamedStress> stresses;
  std::vector<double> pressure;  ///< [Pa]; empty: not drawn
};

/// Draws strain (if it changes), shear stresses and pressure against time; with shear, also stress against
/// strain. Throws input and file errors.
void plot_dynamics(const std::string& path, const DynamicsPlot& plot);

}  // namespace supple
