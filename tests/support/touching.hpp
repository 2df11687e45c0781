/// Bodies that touch in every way that bodies can, alone in an open cell.
#pragma once
#include <memory>
#include <string>

#include "supple/contact/rough_contacts.hpp"
#include "supple/contact/smooth_contacts.hpp"
#include "supple/contact/touch_friction.hpp"
#include "supple/core/random.hpp"
#include "tests/support/probe.hpp"

namespace supple::testing {

enum class Toucher { disc, vertex };

/// Two bodies that touch, and their contacts.
struct Touching {
  std::string name;
  System<2> system;
  std::shared_ptr<BodyContacts<2>> contacts;
  double distance;  ///< about the distance of the two sides [length]

  /// A force field of their contacts, with friction.
  ForceField<2> field(const TouchLaw& law) const {
    ForceField<2> f(*contacts);
    f.add(TouchFriction(law));
    return f;
  }
};

template <class Contacts>
Touching touching(const std::string& name, const std::vector<Vec2>& ring, const Vec2& probe,
                  Toucher toucher) {
  Touching t{name, {}, std::make_shared<Contacts>(Harmonic{100}), 1};
  t.system.box.length = {100, 100};
  t.system.box.periodic = {false, false};
  const Vec2 middle{50, 50};
  std::vector<Vec2> moved = ring;
  for (Vec2& x : moved) x += middle;
  add_body(t.system, moved, 0.5);
  if (toucher == Toucher::disc) {
    add_disc_body(t.system, probe + middle, 0.7);
  } else {  // a triangle that points to the middle of the ring with a vertex at the probe
    Vec2 centre{};
    for (const Vec2& x : ring) centre += (1.0 / static_cast<double>(ring.size())) * x;
    const Vec2 out = (1 / norm(probe - centre)) * (probe - centre), side = turned_left(out);
    add_body(t.system, {probe + middle, probe + middle + 2 * out - side, probe + middle + 2.5 * out + side},
             0.45);
  }
  return t;
}

/// All cases, rough and smooth, of discs and vertices: on an edge, on a convex corner, in a concave corner,
/// and inside.
inline std::vector<Touching> all_touchings() {
  std::vector<Touching> all;
  for (const Toucher t : {Toucher::disc, Toucher::vertex}) {
    const std::string who = t == Toucher::disc ? "disc " : "vertex ";
    all.push_back(touching<RoughContacts<2>>(who + "on vertex", ell, {-0.4, -0.3}, t));
    all.push_back(touching<RoughContacts<2>>(who + "on two vertices", regular(12, 2), {2.3, 0.6}, t));
    all.push_back(touching<SmoothContacts>(who + "on edge", ell, {2.1, -0.4}, t));
    all.push_back(touching<SmoothContacts>(who + "on convex corner", ell, {-0.4, -0.3}, t));
    all.push_back(touching<SmoothContacts>(who + "in concave corner", ell, {1.6, 2.5}, t));
    all.push_back(touching<SmoothContacts>(who + "inside", ell, {1, 0.2}, t));
  }
  return all;
}

/// Gives all sites random velocities and spins.
inline void stir(System<2>& system, std::uint64_t seed) {
  for (int i = 0; i < system.state.size(); ++i) {
    RandomStream draw(seed, Purpose::test, static_cast<std::uint64_t>(i));
    system.state.velocity[i] = {draw.uniform(-1, 1), draw.uniform(-1, 1)};
    system.state.spin[i] = draw.uniform(-1, 1);
  }
}

/// sum f.v + T w over all sites.
inline double power(const Evaluation<2>& e, const State<2>& s) {
  double sum = 0;
  for (int i = 0; i < s.size(); ++i) sum += dot(e.force[i], s.velocity[i]) + e.torque[i] * s.spin[i];
  return sum;
}

/// Rotates everything about a point by an angle in one straight step, as a leapfrog does: velocities are
/// those that carried the positions.
inline void turn(System<2>& system, const Vec2& about, double angle, double dt) {
  State<2>& s = system.state;
  for (int i = 0; i < s.size(); ++i) {
    const Vec2 r = s.position[i] - about;
    const Vec2 to = about + std::cos(angle) * r + std::sin(angle) * turned_left(r);
    s.velocity[i] = (1 / dt) * (to - s.position[i]);
    s.position[i] = to;
    s.spin[i] = angle / dt;
  }
  system.lag = dt;
}

/// Energy lost over some time by the books of a leapfrog, and |energy now + energy lost - energy at first|.
struct EnergyCheck {
  double lost, error;
};

inline EnergyCheck check_energy(System<2> system, ForceField<2>& field, double dt, double time) {
  State<2>& s = system.state;
  Evaluation<2> out;
  double lost = 0, first = 0, last = 0;
  for (int step = 0; step * dt < time; ++step) {
    field.invalidate();
    field.evaluate(system, Detail::energies, out);
    // Velocities at the instant of the forces are half a kick ahead.
    last = out.energy.stored();
    for (int i = 0; i < s.size(); ++i) {
      const Vec2 v = s.velocity[i] + 0.5 * system.lag / s.mass[i] * out.force[i];
      const double spin = s.spin[i] + 0.5 * system.lag / s.inertia[i] * out.torque[i];
      last += 0.5 * s.mass[i] * dot(v, v) + 0.5 * s.inertia[i] * spin * spin;
    }
    lost += system.lag *
            (out.energy.viscous_power + out.energy.tangential_viscous_power + out.energy.sliding_power);
    if (step == 0) first = last;
    const double kick = 0.5 * (system.lag + dt);
    field.commit(system, out);
    for (int i = 0; i < s.size(); ++i) {
      s.velocity[i] += kick / s.mass[i] * out.force[i];
      s.spin[i] += kick / s.inertia[i] * out.torque[i];
      s.position[i] += dt * s.velocity[i];
    }
    system.lag = dt;
  }
  return {lost, std::abs(last + lost - first)};
}

}  // namespace supple::testing
