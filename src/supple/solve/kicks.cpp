#include "supple/solve/kicks.hpp"

#include "supple/model/body_flow.hpp"
#include "supple/model/present_motion.hpp"
#include "supple/model/rigid.hpp"

namespace supple {

Mobility mobility_of_body(const System<2>& system, int b) {
  for (int i = system.topology.body_begin(b); i < system.topology.body_end(b); ++i)
    if (system.state.mobility[i] != Mobility::free) return system.state.mobility[i];
  return Mobility::free;
}

void hold(System<2>& system) {
  State<2>& s = system.state;
  std::uint8_t held = 0;
  for (const Mobility m : s.mobility) held |= static_cast<std::uint8_t>(m);
  if (held == static_cast<std::uint8_t>(Mobility::free)) return;
  share_sites_apart(system, [&](int i) {
    if (s.mobility[i] != Mobility::free)
      s.velocity[i] = plate_velocity(system.box, s.mobility[i], system.box.strain_rate);
  });
  for (int r = 0; r < system.rigid.size(); ++r) {
    const Mobility m = mobility_of_body(system, system.rigid.body[r]);
    if (m == Mobility::free) continue;
    system.rigid.velocity[r] = plate_velocity(system.box, m, system.box.strain_rate);
    system.rigid.spin[r] = 0;
    place_sites(system, r);
  }
}

void kick(System<2>& system, const Evaluation<2>& evaluation, double time) {
  State<2>& s = system.state;
  share_sites_apart(system, [&](int i) {
    if (evaluation.torque[i] != 0) s.spin[i] += time / s.inertia[i] * evaluation.torque[i];  // no vertex
    s.velocity[i] += time / s.mass[i] * evaluation.force[i];
  });
  RigidBodies& rigid = system.rigid;
  for (int r = 0; r < rigid.size(); ++r) {
    const RigidForce on_body = force_on_rigid(system, evaluation.force, r);
    rigid.velocity[r] += time / rigid.mass[r] * on_body.force;
    rigid.spin[r] += time / rigid.inertia[r] * on_body.torque;
  }
  place_sites(system);
  hold(system);
}

void accelerate(System<2>& system, const Evaluation<2>& evaluation) {
  const State<2>& s = system.state;
  const RigidBodies& rigid = system.rigid;
  Acceleration<2>& a = system.acceleration;
  const auto n = static_cast<std::size_t>(s.size());
  a.site.resize(n), a.spin.resize(n);
  a.rigid.resize(rigid.body.size()), a.rigid_spin.resize(rigid.body.size());
  share_sites_apart(system, [&](int i) {
    a.spin[i] = evaluation.torque[i] != 0 ? evaluation.torque[i] / s.inertia[i] : 0;  // no vertex
    a.site[i] = s.mobility[i] == Mobility::free ? 1 / s.mass[i] * evaluation.force[i] : Vec2{};
  });
  for (int r = 0; r < rigid.size(); ++r) {
    const bool moves = !held(system, r);
    const RigidForce on_body = moves ? force_on_rigid(system, evaluation.force, r) : RigidForce{};
    a.rigid[r] = 1 / rigid.mass[r] * on_body.force;
    a.rigid_spin[r] = 1 / rigid.inertia[r] * on_body.torque;
  }
}

void push(System<2>& system, double time) {
  State<2>& s = system.state;
  RigidBodies& rigid = system.rigid;
  const Acceleration<2>& a = system.acceleration;
  share_sites_apart(system, [&](int i) {
    s.spin[i] += time * a.spin[i];
    s.velocity[i] += time * a.site[i];
  });
  for (int r = 0; r < rigid.size(); ++r) {
    rigid.velocity[r] += time * a.rigid[r];
    rigid.spin[r] += time * a.rigid_spin[r];
  }
  place_sites(system);
  hold(system);
}

Acceleration<2> slow_down(System<2>& system, double factor, double time) {
  const std::vector<Vec2> velocity = system.state.velocity;
  const std::vector<double> spin = system.state.spin;
  const RigidBodies rigid = system.rigid;
  damp(system, factor, Drag::bodies);
  const double per_time = 1 / time;
  Acceleration<2> a = system.acceleration;
  for (std::size_t i = 0; i < velocity.size(); ++i) {
    a.site[i] = per_time * (system.state.velocity[i] - velocity[i]);
    a.spin[i] = per_time * (system.state.spin[i] - spin[i]);
  }
  for (int r = 0; r < rigid.size(); ++r) {
    a.rigid[r] = per_time * (system.rigid.velocity[r] - rigid.velocity[r]);
    a.rigid_spin[r] = per_time * (system.rigid.spin[r] - rigid.spin[r]);
  }
  return a;
}

namespace {

template <class T>
void add(const std::vector<T>& terms, std::vector<T>& to) {
  for (std::size_t k = 0; k < terms.size(); ++k) to[k] += terms[k];
}

}  // namespace

void add(const Acceleration<2>& terms, Acceleration<2>& to) {
  add(terms.site, to.site);
  add(terms.spin, to.spin);
  add(terms.rigid, to.rigid);
  add(terms.rigid_spin, to.rigid_spin);
}

void change_velocities_of_discs(System<2>& system, const Evaluation<2>& evaluation, double rate,
                                double half_before, double half_after, double damping) {
  State<2>& s = system.state;
  Acceleration<2>& a = system.acceleration;
  const auto n = static_cast<std::size_t>(s.size());
  a.site.resize(n), a.spin.resize(n);
  const double change = rate - system.box.strain_rate, turning = -0.5 * change, rotation = -0.5 * rate,
               middle = 0.5 * system.box.length[gradient], per_time = 1 / (half_before + half_after);
  const bool changes = change != 0, damps = damping != 1;
  system.box.strain_rate = rate;
  const auto change_disc = [&](std::size_t i) {
    const bool is_free = s.mobility[i] == Mobility::free;
    double spin = s.spin[i], turn = evaluation.torque[i] != 0 ? evaluation.torque[i] / s.inertia[i] : 0;
    Vec2 v = s.velocity[i], pull = is_free ? 1 / s.mass[i] * evaluation.force[i] : Vec2{};
    spin += half_before * turn;
    v += half_before * pull;
    if (changes) {
      v[flow] += (s.position[i][gradient] - middle) * change;
      spin += turning;
    }
    Vec2 drag{};
    double spin_drag = 0;
    if (damps) {
      const double spin_before = spin;
      spin = rotation + (spin - rotation) * damping;
      spin_drag = per_time * (spin - spin_before);
      if (is_free) {
        const Vec2 before = v, u = system.box.flow_velocity(s.position[i]);
        v = u + damping * (v - u);
        drag = per_time * (v - before);
      }
    }
    s.spin[i] = spin + half_after * turn;
    s.velocity[i] = is_free ? v + half_after * pull : plate_velocity(system.box, s.mobility[i], rate);
    a.spin[i] = damps ? turn + spin_drag : turn;
    a.site[i] = damps ? pull + drag : pull;
  };
  for_chunks(s.size(), [&](std::int64_t, std::int64_t begin, std::int64_t end) {
    for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) change_disc(i);
  });
}

}  // namespace supple
