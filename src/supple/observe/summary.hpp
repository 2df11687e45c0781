/// A system in a few numbers: momenta, energies, contacts, packing.
#pragma once
#include "supple/model/evaluation.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// Velocity and spin of site i at the instant of the forces. A leapfrog keeps them half a step earlier
/// (System::lag).
inline Vec2 synchronised_velocity(const System<2>& system, const Evaluation<2>& evaluation, std::int32_t i) {
  const State<2>& s = system.state;
  if (s.mobility[i] != Mobility::free) return s.velocity[i];
  return s.velocity[i] + 0.5 * system.lag / s.mass[i] * evaluation.force[i];
}
inline double synchronised_spin(const System<2>& system, const Evaluation<2>& evaluation, std::int32_t i) {
  return system.state.spin[i] + 0.5 * system.lag / system.state.inertia[i] * evaluation.torque[i];
}

/// The same of rigid body r.
struct RigidRates {
  Vec2 velocity;
  double spin;
};
RigidRates synchronised_rigid(const System<2>& system, const Evaluation<2>& evaluation, int r);

/// Momenta of all sites and rigid bodies: linear, sum m v; angular, sum [m (x v_y - y v_x) + I w] about the
/// corner of the cell.
struct Momenta {
  Vec2 linear{};
  double angular = 0;
};
Momenta momenta(const System<2>& system, const Evaluation<2>& evaluation);
/// Of the velocities as they stand.
Momenta momenta(const System<2>& system);

/// Kinetic energies [energy]: of the translation of free sites and rigid bodies, of their translation
/// relative to the affine flow, and of all spins (plate discs are moved from outside, but spin freely).
struct KineticEnergy {
  double translation = 0, peculiar = 0, spin = 0;
  double total() const { return translation + spin; }
};
KineticEnergy kinetic_energy(const System<2>& system, const Evaluation<2>& evaluation);
/// Of the velocities as they stand. The energy of spins makes no pressure: the forces that keep a turning
/// body together cancel it.
KineticEnergy kinetic_energy(const System<2>& system);

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
