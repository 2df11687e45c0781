/// The result of one evaluation of all forces.
#pragma once
#include <cstdint>
#include <vector>

#include "supple/core/vec.hpp"
#include "supple/model/pair_table.hpp"
#include "supple/model/touch_table.hpp"

namespace supple {

/// Forces of one row of the pair table; all zero where the pair does not touch. In 2D tangential is the force
/// along t = (-n_y, n_x) on `first`; the couple that it exerts is shared by S1-3. In 3D it is a vector.
template <int Dim>
struct PairForce {
  Vec<Dim> normal;            ///< unit vector from first to the nearest image of second
  double distance = 0;        ///< between the centres [length]
  double elastic = 0;         ///< repulsion, positive [force]; negative: tension of a link
  double viscous = 0;         ///< viscous repulsion: positive on approach [force]
  Angular<Dim> tangential{};  ///< on first along t, on second along -t [force]
  std::int32_t up = 0;        ///< cells between them along the gradient
  bool crosses = false;       ///< whether the contact is with a periodic image
  bool active = false;        ///< touching or linked
};

/// Force on `first` of a pair, and its opposite on `second`: repulsion along -n, tangential along t.
inline Vec2 force_on_first(double repulsion, double tangential, const Vec2& normal) {
  return -repulsion * normal + tangential * turned_left(normal);
}
inline Vec2 force_on_first(const PairForce<2>& row) {
  return force_on_first(row.elastic + row.viscous, row.tangential, row.normal);
}
/// Torque per radius on both discs of a pair, F_t d / (r_i + r_j) (S1-3).
inline double torque_per_radius(double tangential, double distance, double d0) {
  return tangential * distance / d0;
}

/// A force from outside on one site.
template <int Dim>
struct SiteForce {
  std::int32_t site;
  Vec<Dim> force;
};

/// Whether energies and the virial are wanted beside the forces.
enum class Detail { forces, energies };

/// Energy stored and power dissipated, by channel.
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

/// Forces and torques on every site, the contacts that made them, and what the law will remember if the step
/// is accepted (ForceField::commit). `virial` is the sum over contacts of F l^T (F on a site, l from the
/// other site to it) and over terms of f r^T, and of what keeps rigid bodies together: volume times static
/// stress, compression positive. `energy` and `virial` are filled on request (Detail::energies).
template <int Dim>
struct Evaluation {
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
