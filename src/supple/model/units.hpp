/// Units of a run. The engine computes in them, files say what they are, and pictures convert to SI.
#pragma once
#include <string>
#include <utility>

namespace supple {

/// The unit of a quantity: what SI calls it, mass and force being per metre of depth in 2D, and the powers of
/// mass, length and time in it.
struct Unit {
  const char* si = "";
  int mass = 0, length = 0, time = 0;
};

namespace unit {
inline constexpr Unit none, angle{"rad"}, length{"m", 0, 1}, per_length{"1/m", 0, -1}, area{"m^2", 0, 2},
    volume{"m^3", 0, 3}, time{"s", 0, 0, 1}, rate{"1/s", 0, 0, -1}, spin{"rad/s", 0, 0, -1},
    speed{"m/s", 0, 1, -1}, acceleration{"m/s^2", 0, 1, -2}, turning{"rad/s^2", 0, 0, -2}, mass{"kg/m", 1},
    inertia{"kg m", 1, 2}, density{"kg/m^3", 1, -2}, force{"N/m", 1, 1, -2}, torque{"N", 1, 2, -2},
    energy{"J/m", 1, 2, -2}, power{"W/m", 1, 2, -3}, stress{"Pa", 1, 0, -2}, stiffness{"Pa", 1, 0, -2},
    viscosity{"Pa s", 1, 0, -1}, area_stiffness{"Pa/m^2", 1, -2, -2};
}

/// Sizes of the run's units of length, mass and time, in SI; mass and force are per metre of depth in 2D.
struct Units {
  std::string name = "SI";
  double length = 1, mass = 1, time = 1;

  /// The size of a unit that is made of these, in SI.
  double of(const Unit& unit) const {
    double size = 1, divisor = 1;
    for (const auto& [base, power] : {std::pair(mass, unit.mass), {length, unit.length}, {time, unit.time}}) {
      for (int k = 0; k < power; ++k) size *= base;
      for (int k = 0; k > power; --k) divisor *= base;
    }
    return size / divisor;
  }
  double speed() const { return of(unit::speed); }
  double force() const { return of(unit::force); }
  double stiffness() const { return of(unit::stiffness); }
  double viscosity() const { return of(unit::viscosity); }
  double torque() const { return of(unit::torque); }
  double stress() const { return of(unit::stress); }
  double density() const { return of(unit::density); }
  double inertia() const { return of(unit::inertia); }
};

inline Units si_units() { return {}; }
/// Dimensionless units of deformable particles: the preferred area of a small one is 1, a vertex has mass 1.
inline Units reduced_units() { return {"reduced", 1, 1, 1}; }
/// Units of the published package and its files: micrometre, milligram, second.
inline Units particleshear_units() { return {"um mg s", 1e-6, 1e-6, 1}; }

}  // namespace supple
