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

namespace {

/// Velocities and spins as they stand, in the form of those of an instant.
struct AsTheyStand {
  const System<2>& system;
  RigidRates site(int i) const { return {system.state.velocity[i], system.state.spin[i]}; }
  RigidRates rigid(int r) const { return {system.rigid.velocity[r], system.rigid.spin[r]}; }
};
struct OfTheInstant {
  const System<2>& system;
  const Evaluation<2>& evaluation;
  RigidRates site(int i) const {
    return {synchronised_velocity(system, evaluation, i), synchronised_spin(system, evaluation, i)};
  }
  RigidRates rigid(int r) const { return synchronised_rigid(system, evaluation, r); }
};

template <class Rates>
Momenta momenta_of(const Rates& rates) {
  const State<2>& s = rates.system.state;
  const RigidBodies& rigid = rates.system.rigid;
  Momenta sum;
  const auto add = [&](double mass, double inertia, const Vec2& at, const RigidRates& now) {
    sum.linear += mass * now.velocity;
    sum.angular += mass * cross(at, now.velocity) + inertia * now.spin;
  };
  for_sites_apart(rates.system, [&](int i) { add(s.mass[i], s.inertia[i], s.position[i], rates.site(i)); });
  for (int r = 0; r < rigid.size(); ++r)
    add(rigid.mass[r], rigid.inertia[r], rigid.centre[r], rates.rigid(r));
  return sum;
}

template <class Rates>
KineticEnergy kinetic_energy_of(const Rates& rates) {
  const System<2>& system = rates.system;
  const State<2>& s = system.state;
  KineticEnergy sum;
  const auto translate = [&](double mass, const Vec2& at, const Vec2& v) {
    const Vec2 peculiar = v - system.box.flow_velocity(at);
    sum.translation += 0.5 * mass * dot(v, v);
    sum.peculiar += 0.5 * mass * dot(peculiar, peculiar);
  };
  for_sites_apart(system, [&](int i) {
    const RigidRates now = rates.site(i);
    sum.spin += 0.5 * s.inertia[i] * now.spin * now.spin;
    if (s.mobility[i] == Mobility::free) translate(s.mass[i], s.position[i], now.velocity);
  });
  const RigidBodies& rigid = system.rigid;
  for (int r = 0; r < rigid.size(); ++r) {
    if (held(system, r)) continue;
    const RigidRates now = rates.rigid(r);
    sum.spin += 0.5 * rigid.inertia[r] * now.spin * now.spin;
    translate(rigid.mass[r], rigid.centre[r], now.velocity);
  }
  return sum;
}

}  // namespace

Momenta momenta(const System<2>& system, const Evaluation<2>& evaluation) {
  return momenta_of(OfTheInstant{system, evaluation});
}
Momenta momenta(const System<2>& system) { return momenta_of(AsTheyStand{system}); }

KineticEnergy kinetic_energy(const System<2>& system, const Evaluation<2>& evaluation) {
  return kinetic_energy_of(OfTheInstant{system, evaluation});
}
KineticEnergy kinetic_energy(const System<2>& system) { return kinetic_energy_of(AsTheyStand{system}); }

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
