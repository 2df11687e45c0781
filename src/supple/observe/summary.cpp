#include "supple/observe/summary.hpp"

namespace supple {

Momenta momenta(const System<2>& system, const Evaluation<2>& evaluation) {
  const State<2>& s = system.state;
  Momenta sum;
  for (int i = 0; i < s.size(); ++i) {
    const Vec2 v = synchronised_velocity(system, evaluation, i);
    sum.linear += s.mass[i] * v;
    sum.angular +=
        s.mass[i] * cross(s.position[i], v) + s.inertia[i] * synchronised_spin(system, evaluation, i);
  }
  return sum;
}

KineticEnergy kinetic_energy(const System<2>& system, const Evaluation<2>& evaluation) {
  const State<2>& s = system.state;
  KineticEnergy sum;
  for (int i = 0; i < s.size(); ++i) {
    const double spin = synchronised_spin(system, evaluation, i);
    sum.spin += 0.5 * s.inertia[i] * spin * spin;
    if (s.mobility[i] != Mobility::free) continue;
    const Vec2 v = synchronised_velocity(system, evaluation, i);
    const Vec2 peculiar = v - system.box.flow_velocity(s.position[i]);
    sum.translation += 0.5 * s.mass[i] * dot(v, v);
    sum.peculiar += 0.5 * s.mass[i] * dot(peculiar, peculiar);
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
