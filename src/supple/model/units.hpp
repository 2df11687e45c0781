/// Units of a run. The engine computes in them, files say what they are, and pictures convert to SI.
#pragma once
#include <string>

namespace supple {

/// Sizes of the run's units of length, mass and time, in SI; mass and force are per metre of depth in 2D.
struct Units {
  std::string name = "SI";
  double length = 1, mass = 1, time = 1;

  double speed() const { return length / time; }
  double force() const { return mass * length / (time * time); }
  double stiffness() const { return mass / (time * time); }
  double viscosity() const { return mass / time; }
  double torque() const { return force() * length; }
  double stress() const { return force() / length; }
  double density() const {
    return mass / (length * length);
  }  ///< per area in 2D: kg/m^3, mass being per depth
  double inertia() const { return mass * length * length; }
};

inline Units si_units() { return {}; }
/// Dimensionless units of deformable particles: the preferred area of a small one is 1, a vertex has mass 1.
inline Units reduced_units() { return {"reduced", 1, 1, 1}; }
/// Units of the published package and its files: micrometre, milligram, second.
inline Units particleshear_units() { return {"um mg s", 1e-6, 1e-6, 1}; }

}  // namespace supple
