/// The result of one evaluation of all forces.
#pragma once
#include <cstdint>
#include <vector>

#include "supple/core/vec.hpp"
#include "supple/model/lattice.hpp"
#include "supple/model/pair_table.hpp"
#include "supple/model/touch_table.hpp"

namespace supple {

/// Forces of one row of the pair table; all zero where the pair neither touches nor is linked. In 2D
/// `tangential` is the force on `first` along t = (-n_y, n_x), and its couple is shared by S1-3; in 3D it is
/// a vector.
template <int Dim>
struct PairForce {
  Vec<Dim> normal;            ///< unit vector from first to the image of second that the row is about
  double distance = 0;        ///< between the centres [length]
  double elastic = 0;         ///< repulsion, positive [force]; negative: tension of a link
  double viscous = 0;         ///< viscous repulsion: positive on approach [force]
  Angular<Dim> tangential{};  ///< on first along t, on second along -t [force]
  std::int32_t up = 0;        ///< cells between them along the gradient
  bool crosses = false;       ///< whether the contact is with a periodic image
  bool active = false;        ///< touching or linked
};

/// Force on `first` of a pair, the opposite of that on `second`: repulsion along -n, tangential along t.
inline Vec2 force_on_first(double repulsion, double tangential, const Vec2& normal) {
  return -repulsion * normal + tangential * turned_left(normal);
}
inline Vec2 force_on_first(const PairForce<2>& row) {
  return force_on_first(row.elastic + row.viscous, row.tangential, row.normal);
}
/// Torque on each disc of a pair over its radius, F_t d / d0 with d0 = r_i + r_j (S1-3) [force].
inline double torque_per_radius(double tangential, double distance, double d0) {
  return tangential * distance / d0;
}

/// A force [force] from outside the sample on one site.
template <int Dim>
struct SiteForce {
  std::int32_t site;
  Vec<Dim> force;
};

/// The direction across the wall that pushes with this force: a wall beside pushes straight, and what has a
/// part along the gradient is of floor or lid, which may rub.
template <int Dim>
int direction_of(const SiteForce<Dim>& wall) {
  if (wall.force[gradient] != 0) return gradient;
  return Dim == 3 && wall.force[flow] == 0 ? Dim - 1 : flow;
}

/// Whether an evaluation computes energies and the virial beside the forces.
enum class Detail { forces, energies };

/// Energy stored and power dissipated, by what stores or dissipates it.
struct EnergyParts {
  double terms = 0, elastic = 0, tangential = 0, wall = 0, external = 0;  ///< [energy]
  double viscous_power = 0, tangential_viscous_power = 0,
         sliding_power = 0;  ///< [energy / time], positive: lost
  EnergyParts& operator+=(const EnergyParts& b) {
    terms += b.terms;
    elastic += b.elastic;
    tangential += b.tangential;
    wall += b.wall;
    external += b.external;
    viscous_power += b.viscous_power;
    tangential_viscous_power += b.tangential_viscous_power;
    sliding_power += b.sliding_power;
    return *this;
  }
  double stored() const { return terms + elastic + tangential + wall + external; }
};

/// Velocities [length/time] and spins [1/time] of sites, and the shear rate [1/time], at the instant of the
/// positions, as dashpots need them. Empty: those of the system are of that instant.
template <int Dim>
struct PresentMotion {
  std::vector<Vec<Dim>> velocity;
  std::vector<Angular<Dim>> spin;
  double strain_rate = 0;

  bool empty() const { return velocity.empty(); }
};

/// Forces [force] and torques [torque] on every site, the contacts that made them, and what contacts will
/// remember if the step is accepted (ForceField::commit). `virial` [energy] is the volume of the cell times
/// the static stress, compression positive: the sum of F l^T over contacts (F on a site, l from the other
/// site to it), of f r^T over the terms of bodies, and of what keeps rigid bodies together (rigid_virial).
/// `energy` and `virial` are filled on request (Detail::energies).
template <int Dim>
struct Evaluation {
  PresentMotion<Dim> now;  ///< given: what present_motion() finds
  std::vector<Vec<Dim>> force;
  std::vector<Angular<Dim>> torque;
  std::vector<PairForce<Dim>> pair;         ///< aligned with System::pairs
  std::vector<ContactState> trial_state;    ///< aligned with System::pairs
  std::vector<double> trial_history;        ///< aligned with System::pairs.history
  std::vector<Touch> trial_touch;           ///< the next System::touches, in their order
  std::vector<double> trial_link;           ///< the next elongations of System::links
  std::vector<TouchForce> touch_force;      ///< of contacts of bodies with friction, in no order
  std::vector<LinkForce> link_force;        ///< aligned with System::links
  std::vector<double> trial_floor_contact;  ///< aligned with sites; empty: no floor with friction
  std::vector<SiteForce<Dim>> wall;         ///< forces of repulsive plates and walls, external to the sample
  EnergyParts energy;
  Mat<Dim> virial;
};

}  // namespace supple
