#include "supple/observe/summary.hpp"

#include "supple/model/rigid.hpp"

namespace supple {

RigidRates synchronised_rigid(const System<2>& system, const Evaluation<2>& evaluation, int r) {
  const RigidBodies& rigid = system.rigid;
  if (held(system, r)) return {rigid.velocity[r], rigid.spin[r]};
  const RigidForce on_body = force_on_rigid(system, evaluation.force, r);
  return {rigid.velocity[r] + 0.5 * system.lag / rigid.mass[r] * on_body.force,
          rigid.spin[r] + 0.5 * system.lag / rigid.inertia[r] * on_body.torque};
}

Momenta momenta(const System<2>& system, const Evaluation<2>& evaluation) {
  const State<2>& s = system.state;
  Momenta sum;
  for_sites_apart(system, [&](int i) {
    const Vec2 v = synchronised_velocity(system, evaluation, i);
    sum.linear += s.mass[i] * v;
    sum.angular +=
        s.mass[i] * cross(s.position[i], v) + s.inertia[i] * synchronised_spin(system, evaluation, i);
  });
  const RigidBodies& rigid = system.rigid;
  for (int r = 0; r < rigid.size(); ++r) {
    const RigidRates now = synchronised_rigid(system, evaluation, r);
    sum.linear += rigid.mass[r] * now.velocity;
    sum.angular += rigid.mass[r] * cross(rigid.centre[r], now.velocity) + rigid.inertia[r] * now.spin;
  }
  return sum;
}

KineticEnergy kinetic_energy(const System<2>& system, const Evaluation<2>& evaluation) {
  const State<2>& s = system.state;
  KineticEnergy sum;
  const auto translate = [&](double mass, const Vec2& at, const Vec2& v) {
    const Vec2 peculiar = v - system.box.flow_velocity(at);
    sum.translation += 0.5 * mass * dot(v, v);
    sum.peculiar += 0.5 * mass * dot(peculiar, peculiar);
  };
  for_sites_apart(system, [&](int i) {
    const double spin = synchronised_spin(system, evaluation, i);
    sum.spin += 0.5 * s.inertia[i] * spin * spin;
    if (s.mobility[i] == Mobility::free)
      translate(s.mass[i], s.position[i], synchronised_velocity(system, evaluation, i));
  });
  const RigidBodies& rigid = system.rigid;
  for (int r = 0; r < rigid.size(); ++r) {
    if (held(system, r)) continue;
    const RigidRates now = synchronised_rigid(system, evaluation, r);
    sum.spin += 0.5 * rigid.inertia[r] * now.spin * now.spin;
    translate(rigid.mass[r], rigid.centre[r], now.velocity);
  }
  return sum;
}

ContactCounts contact_counts(const Evaluation<2>& evaluation) {
  ContactCounts counts;
  for (std::size_t row = 0; row < evaluation.pair.size(); ++row) {
    if (!evaluation.pair[row].active) continue;
    switch (evaluation.trial_state[row]) {
      case ContactState::stick: ++counts.stick; break;
      case ContactState::slip: ++counts.slip; break;
      case ContactState::permanent: ++counts.links; break;
      case ContactState::open: break;
    }
  }
  return counts;
}

double coordination(const System<2>& system, const Evaluation<2>& evaluation) {
  const int sites = system.state.size();
  return sites ? 2.0 * contact_counts(evaluation).total() / sites : 0;
}

double packing_fraction(const System<2>& system) {
  double squares = 0;
  for (const double r : system.state.radius) squares += r * r;
  return 3.14159265358979323846 * squares / system.box.volume();
}

}  // namespace supple
