#include "supple/model/present_motion.hpp"

#include <algorithm>

#include "supple/core/parallel.hpp"
#include "supple/model/body_flow.hpp"
#include "supple/model/rigid.hpp"

namespace supple {

namespace {

/// v, a rigid motion about `centre`, for the sites of body b.
template <int Dim>
void turn_body(const System<Dim>& system, int b, const Vec<Dim>& velocity, const Angular<Dim>& spin,
               const Vec<Dim>& centre, std::vector<Vec<Dim>>& out) {
  for (int i = system.topology.body_begin(b); i < system.topology.body_end(b); ++i)
    out[i] += velocity + cross(spin, system.state.position[i] - centre);
}

void place_rigid(const System<2>& system, double half, PresentMotion<2>& out) {
  const RigidBodies& rigid = system.rigid;
  const Acceleration<2>& a = system.acceleration;
  const bool known = system.knows_acceleration();
  for (int r = 0; r < rigid.size(); ++r) {
    const int b = rigid.body[r];
    std::fill(out.velocity.begin() + system.topology.body_begin(b),
              out.velocity.begin() + system.topology.body_end(b), Vec2{});
    turn_body(system, b, rigid.velocity[r] + (known ? half * a.rigid[r] : Vec2{}),
              rigid.spin[r] + (known ? half * a.rigid_spin[r] : 0), rigid.centre[r], out.velocity);
  }
}

/// What set_strain_rate does to the velocities of bodies.
template <int Dim>
void change_flow(const System<Dim>& system, double change, PresentMotion<Dim>& out) {
  const double middle = 0.5 * system.box.length[gradient];
  const Angular<Dim> turning = flow_spin<Dim>(change);
  for (int b = 0; b < system.topology.body_count(system.state.size()); ++b) {
    const Vec<Dim> centre = centre_of_mass(system, b);
    Vec<Dim> velocity{};
    velocity[flow] = (centre[gradient] - middle) * change;
    turn_body(system, b, velocity, turning, centre, out.velocity);
    if (system.topology.body_size(b) == 1) out.spin[system.topology.body_begin(b)] += turning;
  }
}

}  // namespace

template <int Dim>
Vec<Dim> plate_velocity(const Box<Dim>& box, Mobility mobility, double rate) {
  Vec<Dim> v{};
  const double speed = 0.5 * rate * box.length[gradient];
  if (is_plate(mobility)) v[flow] = mobility == Mobility::upper_plate ? speed : -speed;
  return v;
}

template <int Dim>
void present_motion(const System<Dim>& system, double rate, PresentMotion<Dim>& out) {
  const State<Dim>& s = system.state;
  const double change = rate - system.box.strain_rate, half = 0.5 * system.lag;
  out.velocity.clear();
  out.strain_rate = rate;
  if (half == 0 && change == 0) return;
  out.velocity.resize(s.velocity.size());
  out.spin.resize(s.spin.size());
  const bool known = system.knows_acceleration(), discs = system.topology.begin.empty();
  const double middle = 0.5 * system.box.length[gradient];
  const Angular<Dim> turning = flow_spin<Dim>(change);
  const auto predict = [&](std::size_t i) {
    Vec<Dim> velocity = s.velocity[i];
    Angular<Dim> spin = s.spin[i];
    if (known) {
      velocity += half * system.acceleration.site[i];
      spin += half * system.acceleration.spin[i];
    }
    if (discs) {
      velocity[flow] += (s.position[i][gradient] - middle) * change;
      spin += turning;
    }
    out.velocity[i] = velocity;
    out.spin[i] = spin;
  };
  for_chunks(s.size(), [&](std::int64_t, std::int64_t begin, std::int64_t end) {
    for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) predict(i);
  });
  if (!discs) {
    if constexpr (Dim == 2) place_rigid(system, half, out);
    if (change != 0) change_flow(system, change, out);
  }
  for (int i = 0; i < s.size(); ++i)
    if (s.mobility[i] != Mobility::free) out.velocity[i] = plate_velocity(system.box, s.mobility[i], rate);
}

template Vec2 plate_velocity(const Box<2>&, Mobility, double);
template Vec3 plate_velocity(const Box<3>&, Mobility, double);
template void present_motion(const System<2>&, double, PresentMotion<2>&);
template void present_motion(const System<3>&, double, PresentMotion<3>&);

}  // namespace supple
