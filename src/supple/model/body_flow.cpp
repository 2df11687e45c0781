#include "supple/model/body_flow.hpp"

#include <algorithm>
#include <cmath>

#include "supple/model/rigid.hpp"
#include "supple/model/row_separation.hpp"

namespace supple {

namespace {

/// visit(i) for each site of body b.
template <class Visit>
void for_sites(const System<2>& system, int b, const Visit& visit) {
  for (int i = system.topology.body_begin(b); i < system.topology.body_end(b); ++i) visit(i);
}

bool is_one_site(const System<2>& system, int b) { return system.topology.body_size(b) == 1; }

/// Keeps the contacts and links of body b about the same images after the lattice vector of n was subtracted
/// from its sites.
void follow_body(System<2>& system, const std::vector<std::int32_t>& body, std::int32_t b, const Vec2& n) {
  const auto shift = [&](std::array<std::int32_t, 3>& cells, int sign) {
    for (int d = 0; d < 2; ++d) cells[static_cast<std::size_t>(d)] += sign * static_cast<std::int32_t>(n[d]);
  };
  for (Link& link : system.links) {
    if (body[link.second] == b) shift(link.cells, -1);
    if (body[link.first] == b) shift(link.cells, +1);
  }
  for (Touch& touch : system.touches.rows) {
    if (body[touch.key.site] == b) shift(touch.key.cells, -1);
    if (body_of_other(touch.key, body) == b) shift(touch.key.cells, +1);
  }
}

/// Adds `factor` times a rigid motion, of velocity and spin about the centre, to that of body b.
void add_motion(System<2>& system, int b, double factor, const Vec2& centre, const Vec2& velocity,
                double spin) {
  State<2>& s = system.state;
  if (is_one_site(system, b)) {
    s.velocity[system.topology.body_begin(b)] += factor * velocity;
    s.spin[system.topology.body_begin(b)] += factor * spin;
  } else if (const int r = rigid_index(system, b); r >= 0) {
    system.rigid.velocity[r] += factor * velocity;
    system.rigid.spin[r] += factor * spin;
    place_sites(system, r);
  } else {
    for_sites(system, b,
              [&](int i) { s.velocity[i] += factor * (velocity + cross(spin, s.position[i] - centre)); });
  }
}

/// The upper plate is the lower one of the next cell.
void change_plate(Mobility& m) {
  if (is_plate(m)) m = m == Mobility::upper_plate ? Mobility::lower_plate : Mobility::upper_plate;
}

}  // namespace

Vec2 centre_of_mass(const System<2>& system, int b) {
  const State<2>& s = system.state;
  const Vec2 origin =
      s.position[system.topology.body_begin(b)];  // keeps the digits of bodies that are far away
  if (is_one_site(system, b)) return origin;
  if (const int r = rigid_index(system, b); r >= 0) return system.rigid.centre[r];
  Vec2 moment{};
  double mass = 0;
  for_sites(system, b, [&](int i) {
    mass += s.mass[i];
    moment += s.mass[i] * (s.position[i] - origin);
  });
  return origin + (1 / mass) * moment;
}

BodyMotion body_motion(const System<2>& system, int b) {
  const State<2>& s = system.state;
  const int first = system.topology.body_begin(b);
  if (is_one_site(system, b))
    return {s.position[first], s.velocity[first], s.mass[first], s.inertia[first], s.spin[first]};
  const RigidBodies& rigid = system.rigid;
  if (const int r = rigid_index(system, b); r >= 0)
    return {rigid.centre[r], rigid.velocity[r], rigid.mass[r], rigid.inertia[r], rigid.spin[r]};
  BodyMotion motion;
  motion.centre = centre_of_mass(system, b);
  Vec2 momentum{};
  double angular = 0;
  for_sites(system, b, [&](int i) {
    const Vec2 arm = s.position[i] - motion.centre;
    motion.mass += s.mass[i];
    motion.inertia += s.mass[i] * dot(arm, arm);
    momentum += s.mass[i] * s.velocity[i];
    angular += s.mass[i] * cross(arm, s.velocity[i]);  // about the centre, whose own velocity adds nothing
  });
  motion.velocity = (1 / motion.mass) * momentum;
  motion.spin = motion.inertia > 0 ? angular / motion.inertia : 0;
  return motion;
}

void set_strain_rate(System<2>& system, double rate) {
  const double change = rate - system.box.strain_rate, turning = -0.5 * change;
  system.box.strain_rate = rate;
  if (change == 0) return;
  const double middle = 0.5 * system.box.length[gradient];
  if (system.topology.begin.empty()) {  // discs, at each step of a protocol
    State<2>& s = system.state;
    for (int i = 0; i < s.size(); ++i) {
      s.velocity[i][flow] += (s.position[i][gradient] - middle) * change;
      s.spin[i] += turning;
    }
    return;
  }
  for (int b = 0; b < system.topology.body_count(system.state.size()); ++b) {
    const Vec2 centre = centre_of_mass(system, b);
    Vec2 velocity{};
    velocity[flow] = (centre[gradient] - middle) * change;
    add_motion(system, b, 1, centre, velocity, turning);
  }
}

bool has_plates(const State<2>& state) {
  return std::any_of(state.mobility.begin(), state.mobility.end(), is_plate);
}

void leave_plates(System<2>& system) {
  for (Mobility& m : system.state.mobility)
    if (is_plate(m)) m = Mobility::free;
}

void damp(System<2>& system, double factor, Drag drag) {
  State<2>& s = system.state;
  RigidBodies& rigid = system.rigid;
  const double rotation = -0.5 * system.box.strain_rate;
  const auto slow = [&](Vec2& velocity, const Vec2& at) {
    const Vec2 u = system.box.flow_velocity(at);
    velocity = u + factor * (velocity - u);
  };
  const auto turn_less = [&](double& spin) { spin = rotation + (spin - rotation) * factor; };
  for (int b = 0; b < system.topology.body_count(s.size()); ++b) {
    if (is_one_site(system, b)) turn_less(s.spin[system.topology.body_begin(b)]);
    if (is_one_site(system, b) || (drag == Drag::sites && rigid_index(system, b) < 0)) {
      for_sites(system, b, [&](int i) {
        if (s.mobility[i] == Mobility::free) slow(s.velocity[i], s.position[i]);
      });
    } else if (const int r = rigid_index(system, b); r >= 0) {
      if (held(system, r)) continue;
      slow(rigid.velocity[r], rigid.centre[r]);
      turn_less(rigid.spin[r]);
      place_sites(system, r);
    } else {
      const BodyMotion m = body_motion(system, b);
      const Vec2 relative = m.velocity - system.box.flow_velocity(m.centre);
      add_motion(system, b, factor - 1, m.centre, relative, m.spin - rotation);
    }
  }
}

bool wrap_bodies(System<2>& system) {
  State<2>& s = system.state;
  if (system.topology.begin.empty()) {
    for (int i = 0; i < s.size(); ++i) wrap_site(system, i);
    return false;
  }
  bool moved = false;
  std::vector<std::int32_t> body;
  for (int b = 0; b < system.topology.body_count(s.size()); ++b) {
    Vec2 centre = centre_of_mass(system, b), velocity{};
    const Vec2 n = system.box.wrap(centre, velocity);
    if (n == Vec2{} || !is_passable(system.topology.body_begin(b), n)) continue;
    const Vec2 back = system.box.lattice().vector(n);
    if (const int r = rigid_index(system, b); r >= 0) {
      system.rigid.centre[r] -= back;
      system.rigid.velocity[r] += velocity;
      place_sites(system, r);
    } else {
      for_sites(system, b, [&](int i) {
        s.position[i] -= back;
        s.velocity[i] += velocity;
      });
    }
    if (std::fmod(n[gradient], 2) != 0) for_sites(system, b, [&](int i) { change_plate(s.mobility[i]); });
    if (body.empty()) body = bodies_of_sites(system.topology, s.size());
    follow_body(system, body, b, n);
    moved = true;
  }
  if (moved)
    std::sort(system.touches.rows.begin(), system.touches.rows.end(),
              [](const Touch& a, const Touch& b) { return a.key < b.key; });
  return moved;
}

}  // namespace supple
