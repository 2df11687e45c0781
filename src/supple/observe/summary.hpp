/// A system in a few numbers: momenta, energies, contacts, packing.
#pragma once
#include "supple/model/evaluation.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// Velocity and spin of site i at the instant of the forces. A leapfrog keeps them half a step earlier
/// (System::lag).
template <int Dim>
Vec<Dim> synchronised_velocity(const System<Dim>& system, const Evaluation<Dim>& evaluation, std::int32_t i) {
  const State<Dim>& s = system.state;
  if (s.mobility[i] != Mobility::free) return s.velocity[i];
  return s.velocity[i] + 0.5 * system.lag / s.mass[i] * evaluation.force[i];
}
template <int Dim>
Angular<Dim> synchronised_spin(const System<Dim>& system, const Evaluation<Dim>& evaluation, std::int32_t i) {
  return system.state.spin[i] + 0.5 * system.lag / system.state.inertia[i] * evaluation.torque[i];
}

/// Velocity and spin of a site or of a rigid body.
template <int Dim>
struct RigidRates {
  Vec<Dim> velocity;
  Angular<Dim> spin;
};
/// The same of rigid body r.
RigidRates<2> synchronised_rigid(const System<2>& system, const Evaluation<2>& evaluation, int r);

/// Momenta of all sites and rigid bodies: linear, sum m v; angular, sum [m x cross v + I w] about the corner
/// of the cell, in 2D of z alone.
template <int Dim>
struct Momenta {
  Vec<Dim> linear{};
  Angular<Dim> angular{};
};
template <int Dim>
Momenta<Dim> momenta(const System<Dim>& system, const Evaluation<Dim>& evaluation);
/// Of the velocities as they stand.
template <int Dim>
Momenta<Dim> momenta(const System<Dim>& system);

/// Kinetic energies [energy]: of the translation of free sites and rigid bodies, of their translation
/// relative to the affine flow, and of all spins (plate discs are moved from outside, but spin freely).
struct KineticEnergy {
  double translation = 0, peculiar = 0, spin = 0;
  double total() const { return translation + spin; }
};
template <int Dim>
KineticEnergy kinetic_energy(const System<Dim>& system, const Evaluation<Dim>& evaluation);
/// Of the velocities as they stand. The energy of spins makes no pressure: the forces that keep a turning
/// body together cancel it.
template <int Dim>
KineticEnergy kinetic_energy(const System<Dim>& system);

/// Numbers of pairs by state; links count whether or not their discs touch.
struct ContactCounts {
  int stick = 0, slip = 0, links = 0;
  int total() const { return stick + slip + links; }
};
ContactCounts contact_counts(const Evaluation<2>& evaluation);

/// Mean number of contacts and links of a site, two for each pair.
double coordination(const System<2>& system, const Evaluation<2>& evaluation);

/// Area of all discs over the area of the cell; overlaps count twice.
double packing_fraction(const System<2>& system);

}  // namespace supple
