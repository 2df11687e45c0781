#include "supple/observe/summary.hpp"

#include "supple/model/rigid.hpp"

namespace supple {

RigidRates<2> synchronised_rigid(const System<2>& system, const Evaluation<2>& evaluation, int r) {
  const RigidBodies& rigid = system.rigid;
  if (held(system, r)) return {rigid.velocity[r], rigid.spin[r]};
  const RigidForce on_body = force_on_rigid(system, evaluation.force, r);
  return {rigid.velocity[r] + 0.5 * system.lag / rigid.mass[r] * on_body.force,
          rigid.spin[r] + 0.5 * system.lag / rigid.inertia[r] * on_body.torque};
}

namespace {

/// Velocities and spins as they stand, in the form of those of an instant.
template <int Dim>
struct AsTheyStand {
  const System<Dim>& system;
  RigidRates<Dim> site(int i) const { return {system.state.velocity[i], system.state.spin[i]}; }
  RigidRates<2> rigid(int r) const { return {system.rigid.velocity[r], system.rigid.spin[r]}; }
};
template <int Dim>
struct OfTheInstant {
  const System<Dim>& system;
  const Evaluation<Dim>& evaluation;
  RigidRates<Dim> site(int i) const {
    return {synchronised_velocity(system, evaluation, i), synchronised_spin(system, evaluation, i)};
  }
  RigidRates<2> rigid(int r) const { return synchronised_rigid(system, evaluation, r); }
};

double spin_energy(double inertia, double spin) { return 0.5 * inertia * spin * spin; }
double spin_energy(double inertia, const Vec3& spin) { return 0.5 * inertia * dot(spin, spin); }

template <int Dim, template <int> class Rates>
Momenta<Dim> momenta_of(const Rates<Dim>& rates) {
  const State<Dim>& s = rates.system.state;
  Momenta<Dim> sum;
  const auto add = [&](double mass, double inertia, const Vec<Dim>& at, const RigidRates<Dim>& now) {
    sum.linear += mass * now.velocity;
    sum.angular += mass * cross(at, now.velocity) + inertia * now.spin;
  };
  for_sites_apart(rates.system, [&](int i) { add(s.mass[i], s.inertia[i], s.position[i], rates.site(i)); });
  if constexpr (Dim == 2) {
    const RigidBodies& rigid = rates.system.rigid;
    for (int r = 0; r < rigid.size(); ++r)
      add(rigid.mass[r], rigid.inertia[r], rigid.centre[r], rates.rigid(r));
  }
  return sum;
}

template <int Dim, template <int> class Rates>
KineticEnergy kinetic_energy_of(const Rates<Dim>& rates) {
  const System<Dim>& system = rates.system;
  const State<Dim>& s = system.state;
  KineticEnergy sum;
  const auto translate = [&](double mass, const Vec<Dim>& at, const Vec<Dim>& v) {
    const Vec<Dim> peculiar = v - system.box.flow_velocity(at);
    sum.translation += 0.5 * mass * dot(v, v);
    sum.peculiar += 0.5 * mass * dot(peculiar, peculiar);
  };
  for_sites_apart(system, [&](int i) {
    const RigidRates<Dim> now = rates.site(i);
    sum.spin += spin_energy(s.inertia[i], now.spin);
    if (s.mobility[i] == Mobility::free) translate(s.mass[i], s.position[i], now.velocity);
  });
  if constexpr (Dim == 2) {
    const RigidBodies& rigid = system.rigid;
    for (int r = 0; r < rigid.size(); ++r) {
      if (held(system, r)) continue;
      const RigidRates<2> now = rates.rigid(r);
      sum.spin += spin_energy(rigid.inertia[r], now.spin);
      translate(rigid.mass[r], rigid.centre[r], now.velocity);
    }
  }
  return sum;
}

}  // namespace

template <int Dim>
Momenta<Dim> momenta(const System<Dim>& system, const Evaluation<Dim>& evaluation) {
  return momenta_of(OfTheInstant<Dim>{system, evaluation});
}
template <int Dim>
Momenta<Dim> momenta(const System<Dim>& system) {
  return momenta_of(AsTheyStand<Dim>{system});
}

template <int Dim>
KineticEnergy kinetic_energy(const System<Dim>& system, const Evaluation<Dim>& evaluation) {
  return kinetic_energy_of(OfTheInstant<Dim>{system, evaluation});
}
template <int Dim>
KineticEnergy kinetic_energy(const System<Dim>& system) {
  return kinetic_energy_of(AsTheyStand<Dim>{system});
}

template Momenta<2> momenta(const System<2>&, const Evaluation<2>&);
template Momenta<3> momenta(const System<3>&, const Evaluation<3>&);
template Momenta<2> momenta(const System<2>&);
template Momenta<3> momenta(const System<3>&);
template KineticEnergy kinetic_energy(const System<2>&, const Evaluation<2>&);
template KineticEnergy kinetic_energy(const System<3>&, const Evaluation<3>&);
template KineticEnergy kinetic_energy(const System<2>&);
template KineticEnergy kinetic_energy(const System<3>&);

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
