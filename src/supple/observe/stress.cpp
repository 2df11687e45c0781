#include "supple/observe/stress.hpp"

#include "supple/observe/summary.hpp"

namespace supple {
namespace {

/// Sums over contacts of F l^T, and of the torques T_i + T_j = F_t d (S1-3). On the first disc F = -P n + F_t
/// t and l = -d n, so that
///     F l^T = d P n n^T - d F_t t n^T,
/// where n n^T is symmetric to the last bit.
struct ContactSums {
  double xx = 0, xy = 0, yx = 0, yy = 0, torque = 0;

  void add(const PairForce<2>& p) {
    const double central = p.distance * (p.elastic + p.viscous), couple = p.distance * p.tangential;
    const double nxx = p.normal[0] * p.normal[0], nxy = p.normal[0] * p.normal[1],
                 nyy = p.normal[1] * p.normal[1];
    xx += central * nxx + couple * nxy;
    xy += central * nxy + couple * nyy;
    yx += central * nxy - couple * nxx;
    yy += central * nyy - couple * nxy;
    torque += couple;
  }
  ContactSums& operator+=(const ContactSums& b) {
    xx += b.xx;
    xy += b.xy;
    yx += b.yx;
    yy += b.yy;
    torque += b.torque;
    return *this;
  }
  Mat2 love_weber() const { return {{{xx, xy}, {yx, yy}}}; }
  Mat2 torque_tensor() const { return {{{0, -0.5 * torque}, {0.5 * torque, 0}}}; }
};

void add_contacts(const System<2>& system, const Evaluation<2>& evaluation, StressTensors& s) {
  const Vec2* position = system.state.position.data();
  const Mobility* mobility = system.state.mobility.data();
  const Vec2 centre = system.box.centre();
  // Disjoint kinds of contact: a tensor is a sum of kinds, so that one without contacts is exactly zero.
  ContactSums internal, across_flow, other;
  Mat2 external;
  double plates = 0;
  int pair_register = 0, external_register = 0;
  const std::size_t rows = evaluation.pair.size();
  for (std::size_t row = 0; row < rows; ++row) {
    const PairForce<2>& p = evaluation.pair[row];
    if (!p.active) continue;
    const auto i = system.pairs.first[row], j = system.pairs.second[row];
    const bool first_free = mobility[i] == Mobility::free, second_free = mobility[j] == Mobility::free;
    const bool both_free = first_free & second_free;
    if (both_free & !p.crosses) {
      internal.add(p);
      pair_register += 8;
      continue;
    }
    (both_free && p.up == 0 ? across_flow : other).add(p);
    const Vec2 force = force_on_first(p);
    if (first_free) external.add_outer(-1, force, position[i] - centre);
    if (second_free) external.add_outer(1, force, position[j] - centre);
    external_register += 4 * (first_free + second_free);
    if (is_plate(mobility[i]) && second_free)
      plates -= position[j][gradient] > centre[gradient] ? force[flow] : -force[flow];
    if (is_plate(mobility[j]) && first_free)
      plates += position[i][gradient] > centre[gradient] ? force[flow] : -force[flow];
  }
  for (const SiteForce<2>& wall : evaluation.wall)
    external.add_outer(-1, wall.force, position[wall.site] - centre);

  s.pair_register = pair_register;
  s.external_register = external_register;
  s.external = external;
  // A force over a width, times the height, as all is divided by the area of the cell.
  s.plates = 0.5 * plates * system.box.length[gradient];
  s.love_weber = internal.love_weber();
  s.internal_torque = internal.torque_tensor();
  internal += across_flow;
  s.love_weber_periodic = internal.love_weber();
  internal += other;
  s.virial = internal.love_weber();
  s.tangential_torque = internal.torque_tensor();
}

void add_sites(const System<2>& system, const Evaluation<2>& evaluation, StressTensors& s) {
  const State<2>& state = system.state;
  const Vec2 centre = system.box.centre();
  Mat2 acceleration, otsuki;
  double rotational_energy = 0;
  for (int i = 0; i < state.size(); ++i) {
    if (state.mobility[i] != Mobility::free) continue;
    const Vec2 peculiar =
        synchronised_velocity(system, evaluation, i) - system.box.flow_velocity(state.position[i]);
    const double spin = synchronised_spin(system, evaluation, i);
    acceleration.add_outer(1, evaluation.force[i], state.position[i] - centre);
    otsuki.add_outer(-state.mass[i], peculiar, peculiar);
    rotational_energy += 0.5 * state.inertia[i] * (spin * spin);
  }
  s.linear_acceleration = acceleration;
  s.otsuki = otsuki;
  s.centrifugal[0][0] = s.centrifugal[1][1] = -rotational_energy;
}

}  // namespace

StressTensors stress_tensors(const System<2>& system, const Evaluation<2>& evaluation, double unit) {
  StressTensors s;
  add_contacts(system, evaluation, s);
  add_sites(system, evaluation, s);
  const double scale = unit / system.box.volume();
  for (Mat2* m : {&s.love_weber, &s.external, &s.linear_acceleration, &s.otsuki, &s.tangential_torque,
                  &s.internal_torque, &s.centrifugal, &s.love_weber_periodic, &s.virial})
    *m *= scale;
  s.plates *= scale;
  s.overall = s.love_weber + s.internal_torque + s.centrifugal;
  return s;
}

}  // namespace supple
