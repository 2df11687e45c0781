/// The general contact: any number of sites of two bodies, seen as one scalar gap and one force.
#pragma once
#include <array>
#include <cstdint>

#include "supple/model/box.hpp"
#include "supple/model/state.hpp"

namespace supple {

/// Disc on disc, vertex on vertex, vertex on facet, site on wall: contacts differ only in how their record is
/// filled. The weights c_a are positive on the side that n points to and sum to zero; c_a n is the gradient
/// of the gap with respect to site a. A spin w_a enters with the arm from the centre of its site to the point
/// of contact. From these follow
///     relative velocity  v = sum c_a (v_a + w_a x arm_a) - jump over the boundary,
///     forces             f_a = c_a F,  torques  T_a = arm_a x f_a,
/// F being the force on the side of positive weight. The power of the contact is then that of F whatever the
/// law: sum (f_a.v_a + T_a.w_a) = F.(v + jump).
template <int Dim>
struct ContactRecord {
  static constexpr int most_sites = Dim + 1;  ///< a vertex and a facet

  int sites = 0;
  std::array<std::int32_t, most_sites> site{};
  std::array<double, most_sites> weight{};
  std::array<Vec<Dim>, most_sites> arm{};  ///< [length]; zero where the site does not spin
  Vec<Dim> normal{};                       ///< unit vector toward the sites of positive weight
  /// Sum c_a x_a over the images that meet [length]. Torques balance where it equals -sum c_a arm_a.
  Vec<Dim> branch{};
  double reach = 0;  ///< distance at which the surfaces meet [length]
  double gap = 0;    ///< distance less reach; negative: overlap [length]
  /// Factor on the law's energy and force: negative for a corner that takes back what two edges both counted;
  /// with the 1/2 of [MacKeith 2025, eq. 9.5].
  double multiplicity = 1;
  /// Records with the same number, one after the other, are one contact: their sum counts as one and has one
  /// friction. -1: a contact by itself.
  std::int32_t touch = -1;
  std::array<std::int32_t, 2> species{};  ///< of the two bodies, which decide on the law (LawTable)
  std::int32_t row = -1;                  ///< of the pair table, where the contact is remembered
  std::int32_t up = 0;                    ///< `cells` along the gradient
  bool crosses = false;                   ///< whether the contact is with a periodic image
  /// Cells between the sites as they stand: subtract their lattice vector from the positions of positive
  /// weight less those of negative weight.
  std::array<std::int32_t, Dim> cells{};

  void set_cells(const Vec<Dim>& n) {
    up = static_cast<std::int32_t>(n[gradient]);
    for (int d = 0; d < Dim; ++d) {
      cells[static_cast<std::size_t>(d)] = static_cast<std::int32_t>(n[d]);
      crosses = crosses || n[d] != 0;
    }
  }
  double distance() const { return reach + gap; }
  void add(std::int32_t a, double c, const Vec<Dim>& lever = {}) {
    site[sites] = a;
    weight[sites] = c;
    arm[sites++] = lever;
  }
};

/// d(branch)/dt: the velocity of the sites of positive weight relative to the others, without their spins.
template <int Dim>
Vec<Dim> branch_velocity(const ContactRecord<Dim>& record, const State<Dim>& state, const Box<Dim>& box) {
  Vec<Dim> v = -box.velocity_jump(record.up);
  for (int k = 0; k < record.sites; ++k) v += record.weight[k] * state.velocity[record.site[k]];
  return v;
}

/// Velocity at the contact of the side of positive weight, relative to the other; its part along n is
/// d(gap)/dt.
template <int Dim>
Vec<Dim> relative_velocity(const ContactRecord<Dim>& record, const State<Dim>& state, const Box<Dim>& box) {
  Vec<Dim> v = -box.velocity_jump(record.up);
  for (int k = 0; k < record.sites; ++k) {
    const std::int32_t a = record.site[k];
    v += record.weight[k] * (state.velocity[a] + cross(state.spin[a], record.arm[k]));
  }
  return v;
}

/// Adds the force F on the side of positive weight, its reaction and their torques to the sites of the
/// record.
template <int Dim>
void scatter(const ContactRecord<Dim>& record, const Vec<Dim>& force, std::vector<Vec<Dim>>& forces,
             std::vector<Angular<Dim>>& torques) {
  for (int k = 0; k < record.sites; ++k) {
    const Vec<Dim> share = record.weight[k] * force;
    forces[record.site[k]] += share;
    torques[record.site[k]] += cross(record.arm[k], share);
  }
}

}  // namespace supple
