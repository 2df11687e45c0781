#include "supple/solve/kicks.hpp"

#include "supple/model/body_flow.hpp"
#include "supple/model/present_motion.hpp"
#include "supple/model/rigid.hpp"

namespace supple {

template <int Dim>
Mobility mobility_of_body(const System<Dim>& system, int b) {
  for (int i = system.topology.body_begin(b); i < system.topology.body_end(b); ++i)
    if (system.state.mobility[i] != Mobility::free) return system.state.mobility[i];
  return Mobility::free;
}

template <int Dim>
void hold(System<Dim>& system) {
  State<Dim>& s = system.state;
  std::uint8_t held = 0;
  for (const Mobility m : s.mobility) held |= static_cast<std::uint8_t>(m);
  if (held == static_cast<std::uint8_t>(Mobility::free)) return;
  share_sites_apart(system, [&](int i) {
    if (s.mobility[i] != Mobility::free)
      s.velocity[i] = plate_velocity(system.box, s.mobility[i], system.box.strain_rate);
  });
  if constexpr (Dim == 2)
    for (int r = 0; r < system.rigid.size(); ++r) {
      const Mobility m = mobility_of_body(system, system.rigid.body[r]);
      if (m == Mobility::free) continue;
      system.rigid.velocity[r] = plate_velocity(system.box, m, system.box.strain_rate);
      system.rigid.spin[r] = 0;
      place_sites(system, r);
    }
}

template <int Dim>
void kick(System<Dim>& system, const Evaluation<Dim>& evaluation, double time) {
  State<Dim>& s = system.state;
  share_sites_apart(system, [&](int i) {
    if (evaluation.torque[i] != Angular<Dim>{})
      s.spin[i] += time / s.inertia[i] * evaluation.torque[i];  // no vertex
    s.velocity[i] += time / s.mass[i] * evaluation.force[i];
  });
  if constexpr (Dim == 2) {
    RigidBodies& rigid = system.rigid;
    for (int r = 0; r < rigid.size(); ++r) {
      const RigidForce on_body = force_on_rigid(system, evaluation.force, r);
      rigid.velocity[r] += time / rigid.mass[r] * on_body.force;
      rigid.spin[r] += time / rigid.inertia[r] * on_body.torque;
    }
    place_sites(system);
  }
  hold(system);
}

namespace {

/// Vertices have no torque, and need no inertia.
double turning_by(double torque, double inertia) { return torque != 0 ? torque / inertia : 0; }
Vec3 turning_by(const Vec3& torque, double inertia) {
  return torque == Vec3{} ? Vec3{} : 1 / inertia * torque;
}

}  // namespace

template <int Dim>
void accelerate(System<Dim>& system, const Evaluation<Dim>& evaluation) {
  const State<Dim>& s = system.state;
  Acceleration<Dim>& a = system.acceleration;
  const auto n = static_cast<std::size_t>(s.size());
  a.site.resize(n), a.spin.resize(n);
  share_sites_apart(system, [&](int i) {
    a.spin[i] = turning_by(evaluation.torque[i], s.inertia[i]);
    a.site[i] = s.mobility[i] == Mobility::free ? 1 / s.mass[i] * evaluation.force[i] : Vec<Dim>{};
  });
  if constexpr (Dim == 2) {
    const RigidBodies& rigid = system.rigid;
    a.rigid.resize(rigid.body.size()), a.rigid_spin.resize(rigid.body.size());
    for (int r = 0; r < rigid.size(); ++r) {
      const bool moves = !held(system, r);
      const RigidForce on_body = moves ? force_on_rigid(system, evaluation.force, r) : RigidForce{};
      a.rigid[r] = 1 / rigid.mass[r] * on_body.force;
      a.rigid_spin[r] = 1 / rigid.inertia[r] * on_body.torque;
    }
  }
}

template <int Dim>
void push(System<Dim>& system, double time) {
  State<Dim>& s = system.state;
  const Acceleration<Dim>& a = system.acceleration;
  share_sites_apart(system, [&](int i) {
    s.spin[i] += time * a.spin[i];
    s.velocity[i] += time * a.site[i];
  });
  if constexpr (Dim == 2) {
    RigidBodies& rigid = system.rigid;
    for (int r = 0; r < rigid.size(); ++r) {
      rigid.velocity[r] += time * a.rigid[r];
      rigid.spin[r] += time * a.rigid_spin[r];
    }
    place_sites(system);
  }
  hold(system);
}

template <int Dim>
Acceleration<Dim> slow_down(System<Dim>& system, double factor, double time) {
  const std::vector<Vec<Dim>> velocity = system.state.velocity;
  const std::vector<Angular<Dim>> spin = system.state.spin;
  const RigidBodiesOf<Dim> rigid = system.rigid;
  damp(system, factor, Drag::bodies);
  const double per_time = 1 / time;
  Acceleration<Dim> a = system.acceleration;
  for (std::size_t i = 0; i < velocity.size(); ++i) {
    a.site[i] = per_time * (system.state.velocity[i] - velocity[i]);
    a.spin[i] = per_time * (system.state.spin[i] - spin[i]);
  }
  for (int r = 0; r < rigid.size(); ++r) {  // none in 3D
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

template <int Dim>
void add(const Acceleration<Dim>& terms, Acceleration<Dim>& to) {
  add(terms.site, to.site);
  add(terms.spin, to.spin);
  add(terms.rigid, to.rigid);
  add(terms.rigid_spin, to.rigid_spin);
}

template <int Dim>
void change_velocities_of_discs(System<Dim>& system, const Evaluation<Dim>& evaluation, double rate,
                                double half_before, double half_after, double damping) {
  State<Dim>& s = system.state;
  Acceleration<Dim>& a = system.acceleration;
  const auto n = static_cast<std::size_t>(s.size());
  a.site.resize(n), a.spin.resize(n);
  const double change = rate - system.box.strain_rate, middle = 0.5 * system.box.length[gradient],
               per_time = 1 / (half_before + half_after);
  const Angular<Dim> turning = flow_spin<Dim>(change), rotation = flow_spin<Dim>(rate);
  const bool changes = change != 0, damps = damping != 1;
  system.box.strain_rate = rate;
  const auto change_disc = [&](std::size_t i) {
    const bool is_free = s.mobility[i] == Mobility::free;
    Angular<Dim> spin = s.spin[i], turn = turning_by(evaluation.torque[i], s.inertia[i]);
    Vec<Dim> v = s.velocity[i], pull = is_free ? 1 / s.mass[i] * evaluation.force[i] : Vec<Dim>{};
    spin += half_before * turn;
    v += half_before * pull;
    if (changes) {
      v[flow] += (s.position[i][gradient] - middle) * change;
      spin += turning;
    }
    Vec<Dim> drag{};
    Angular<Dim> spin_drag{};
    if (damps) {
      const Angular<Dim> spin_before = spin;
      spin = rotation + (spin - rotation) * damping;
      spin_drag = per_time * (spin - spin_before);
      if (is_free) {
        const Vec<Dim> before = v, u = system.box.flow_velocity(s.position[i]);
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

// clang-format off
#define SUPPLE_KICKS(Dim) \
  template Mobility mobility_of_body(const System<Dim>&, int); \
  template void hold(System<Dim>&); \
  template void kick(System<Dim>&, const Evaluation<Dim>&, double); \
  template void accelerate(System<Dim>&, const Evaluation<Dim>&); \
  template void push(System<Dim>&, double); \
  template Acceleration<Dim> slow_down(System<Dim>&, double, double); \
  template void add(const Acceleration<Dim>&, Acceleration<Dim>&); \
  template void change_velocities_of_discs(System<Dim>&, const Evaluation<Dim>&, double, double, double, \
                                           double);
// clang-format on
SUPPLE_KICKS(2)
SUPPLE_KICKS(3)
#undef SUPPLE_KICKS

}  // namespace supple
