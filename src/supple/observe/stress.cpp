#include "supple/observe/stress.hpp"

#include "supple/observe/summary.hpp"

namespace supple {
namespace {

/// Sums over the contacts of one kind: F l^T, and the torques T_i + T_j = F_t d (S1-3).
struct ContactSums {
  Mat2 force_lever;
  double torque = 0;
  ContactSums& operator+=(const ContactSums& b) {
    force_lever += b.force_lever;
    torque += b.torque;
    return *this;
  }
};

Mat2 torque_tensor(double torque) {
  Mat2 m;
  m[0][1] = -0.5 * torque;
  m[1][0] = 0.5 * torque;
  return m;
}

/// Disjoint kinds of contact; the tensors are sums of kinds, so that a tensor without contacts is exactly zero.
enum Kind { internal, across_flow, other, kinds };

void add_contacts(const System<2>& system, const Evaluation<2>& evaluation, StressTensors& s) {
  const auto& position = system.state.position;
  const auto& mobility = system.state.mobility;
  const Vec2 centre = system.box.centre();
  ContactSums sums[kinds];
  for (std::size_t row = 0; row < evaluation.pair.size(); ++row) {
    const PairForce<2>& p = evaluation.pair[row];
    if (!p.active) continue;
    const auto i = system.pairs.first[row], j = system.pairs.second[row];
    const bool first_free = mobility[i] == Mobility::free, second_free = mobility[j] == Mobility::free;
    const bool both_free = first_free && second_free;
    const Kind kind = both_free && !p.crosses ? internal : both_free && p.up == 0 ? across_flow : other;

    const Vec2 force = force_on_first(p);
    sums[kind].force_lever.add_outer(-p.distance, force, p.normal);
    sums[kind].torque += p.tangential * p.distance;
    if (kind == internal) {
      s.pair_register += 8;
      continue;
    }
    if (first_free) s.external.add_outer(-1, force, position[i] - centre);
    if (second_free) s.external.add_outer(1, force, position[j] - centre);
    s.external_register += 4 * (first_free + second_free);
  }
  for (const SiteForce<2>& wall : evaluation.wall)
    s.external.add_outer(-1, wall.force, position[wall.site] - centre);
  s.love_weber = sums[internal].force_lever;
  s.internal_torque = torque_tensor(sums[internal].torque);
  s.love_weber_periodic = s.love_weber + sums[across_flow].force_lever;
  s.virial = s.love_weber_periodic + sums[other].force_lever;
  s.tangential_torque = torque_tensor(sums[internal].torque + sums[across_flow].torque + sums[other].torque);
}

void add_sites(const System<2>& system, const Evaluation<2>& evaluation, StressTensors& s) {
  const State<2>& state = system.state;
  const Vec2 centre = system.box.centre();
  double rotational_energy = 0;
  for (int i = 0; i < state.size(); ++i) {
    if (state.mobility[i] != Mobility::free) continue;
    const Vec2 peculiar = synchronised_velocity(system, evaluation, i) - system.box.flow_velocity(state.position[i]);
    s.linear_acceleration.add_outer(1, evaluation.force[i], state.position[i] - centre);
    s.otsuki.add_outer(-state.mass[i], peculiar, peculiar);
    const double spin = synchronised_spin(system, evaluation, i);
    rotational_energy += 0.5 * state.inertia[i] * (spin * spin);
  }
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
  s.overall = s.love_weber + s.internal_torque + s.centrifugal;
  return s;
}

}  // namespace supple
