#include "supple/model/body_flow.hpp"

#include <algorithm>
#include <cmath>

#include "supple/model/rigid.hpp"
#include "supple/model/row_separation.hpp"

namespace supple {

namespace {

/// visit(i) for each site of body b.
template <int Dim, class Visit>
void for_sites(const System<Dim>& system, int b, const Visit& visit) {
  for (int i = system.topology.body_begin(b); i < system.topology.body_end(b); ++i) visit(i);
}

template <int Dim>
bool is_one_site(const System<Dim>& system, int b) {
  return system.topology.body_size(b) == 1;
}

/// Keeps the contacts and links of body b about the same images after the lattice vector of n was subtracted
/// from its sites.
template <int Dim>
void follow_body(System<Dim>& system, const std::vector<std::int32_t>& body, std::int32_t b,
                 const Vec<Dim>& n) {
  const auto shift = [&](std::array<std::int32_t, 3>& cells, int sign) {
    for (int d = 0; d < Dim; ++d)
      cells[static_cast<std::size_t>(d)] += sign * static_cast<std::int32_t>(n[d]);
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
template <int Dim>
void add_motion(System<Dim>& system, int b, double factor, const Vec<Dim>& centre, const Vec<Dim>& velocity,
                const Angular<Dim>& spin) {
  State<Dim>& s = system.state;
  if (is_one_site(system, b)) {
    s.velocity[system.topology.body_begin(b)] += factor * velocity;
    s.spin[system.topology.body_begin(b)] += factor * spin;
    return;
  }
  if constexpr (Dim == 2)
    if (const int r = rigid_index(system, b); r >= 0) {
      system.rigid.velocity[r] += factor * velocity;
      system.rigid.spin[r] += factor * spin;
      return place_sites(system, r);
    }
  for_sites(system, b,
            [&](int i) { s.velocity[i] += factor * (velocity + cross(spin, s.position[i] - centre)); });
}

/// The upper plate is the lower one of the next cell.
void change_plate(Mobility& m) {
  if (is_plate(m)) m = m == Mobility::upper_plate ? Mobility::lower_plate : Mobility::upper_plate;
}

void add_point(double mass, const Vec2& arm, double& inertia) { inertia += mass * dot(arm, arm); }
void add_point(double mass, const Vec3& arm, Mat<3>& inertia) {
  const double square = dot(arm, arm);
  for (int a = 0; a < 3; ++a) inertia[a][a] += mass * square;
  inertia.add_outer(-mass, arm, arm);
}

void set_inertia(double of_site, double& inertia) { inertia = of_site; }
void set_inertia(double of_site, Mat<3>& inertia) {
  for (int a = 0; a < 3; ++a) inertia[a][a] = of_site;
}

double spin_of(double inertia, double angular) { return inertia > 0 ? angular / inertia : 0; }
/// Cramer's rule. Of sites on one line the determinant is 0 up to rounding.
Vec3 spin_of(const Mat<3>& inertia, const Vec3& angular) {
  Vec3 column[3];
  for (int a = 0; a < 3; ++a) column[a] = {inertia[0][a], inertia[1][a], inertia[2][a]};
  const double determinant = dot(column[0], cross(column[1], column[2]));
  const double trace = inertia[0][0] + inertia[1][1] + inertia[2][2];
  if (!(determinant > 1e-12 * trace * trace * trace)) return {};
  return (1 / determinant) * Vec3{dot(angular, cross(column[1], column[2])),
                                  dot(column[0], cross(angular, column[2])),
                                  dot(column[0], cross(column[1], angular))};
}

template <int Dim>
BodyMotion<Dim> motion_of_sites(const System<Dim>& system, int b) {
  const State<Dim>& s = system.state;
  BodyMotion<Dim> motion;
  motion.centre = centre_of_mass(system, b);
  Vec<Dim> momentum{};
  Angular<Dim> angular{};
  for_sites(system, b, [&](int i) {
    const Vec<Dim> arm = s.position[i] - motion.centre;
    motion.mass += s.mass[i];
    add_point(s.mass[i], arm, motion.inertia);
    momentum += s.mass[i] * s.velocity[i];
    angular += s.mass[i] * cross(arm, s.velocity[i]);  // about the centre, whose own velocity adds nothing
  });
  motion.velocity = (1 / motion.mass) * momentum;
  motion.spin = spin_of(motion.inertia, angular);
  return motion;
}

}  // namespace

template <int Dim>
Vec<Dim> centre_of_mass(const System<Dim>& system, int b) {
  const State<Dim>& s = system.state;
  const Vec<Dim> origin =
      s.position[system.topology.body_begin(b)];  // keeps the digits of bodies that are far away
  if (is_one_site(system, b)) return origin;
  if constexpr (Dim == 2)
    if (const int r = rigid_index(system, b); r >= 0) return system.rigid.centre[r];
  Vec<Dim> moment{};
  double mass = 0;
  for_sites(system, b, [&](int i) {
    mass += s.mass[i];
    moment += s.mass[i] * (s.position[i] - origin);
  });
  return origin + (1 / mass) * moment;
}

template <int Dim>
BodyMotion<Dim> body_motion(const System<Dim>& system, int b) {
  if (is_one_site(system, b)) {
    const State<Dim>& s = system.state;
    const int i = system.topology.body_begin(b);
    BodyMotion<Dim> motion{s.position[i], s.velocity[i], s.mass[i], {}, s.spin[i]};
    set_inertia(s.inertia[i], motion.inertia);
    return motion;
  }
  if constexpr (Dim == 2) {
    const RigidBodies& rigid = system.rigid;
    if (const int r = rigid_index(system, b); r >= 0)
      return {rigid.centre[r], rigid.velocity[r], rigid.mass[r], rigid.inertia[r], rigid.spin[r]};
  }
  return motion_of_sites(system, b);
}

template <int Dim>
void set_strain_rate(System<Dim>& system, double rate) {
  const double change = rate - system.box.strain_rate;
  const Angular<Dim> turning = flow_spin<Dim>(change);
  system.box.strain_rate = rate;
  if (change == 0) return;
  const double middle = 0.5 * system.box.length[gradient];
  if (system.topology.begin.empty()) {  // discs, at each step of a protocol
    State<Dim>& s = system.state;
    for (int i = 0; i < s.size(); ++i) {
      s.velocity[i][flow] += (s.position[i][gradient] - middle) * change;
      s.spin[i] += turning;
    }
    return;
  }
  for (int b = 0; b < system.topology.body_count(system.state.size()); ++b) {
    const Vec<Dim> centre = centre_of_mass(system, b);
    Vec<Dim> velocity{};
    velocity[flow] = (centre[gradient] - middle) * change;
    add_motion(system, b, 1, centre, velocity, turning);
  }
}

template <int Dim>
bool has_plates(const State<Dim>& state) {
  return std::any_of(state.mobility.begin(), state.mobility.end(), is_plate);
}

template <int Dim>
void leave_plates(System<Dim>& system) {
  for (Mobility& m : system.state.mobility)
    if (is_plate(m)) m = Mobility::free;
}

template <int Dim>
void damp(System<Dim>& system, double factor, Drag drag) {
  State<Dim>& s = system.state;
  const Angular<Dim> rotation = flow_spin<Dim>(system.box.strain_rate);
  const auto slow = [&](Vec<Dim>& velocity, const Vec<Dim>& at) {
    const Vec<Dim> u = system.box.flow_velocity(at);
    velocity = u + factor * (velocity - u);
  };
  const auto turn_less = [&](Angular<Dim>& spin) { spin = rotation + (spin - rotation) * factor; };
  for (int b = 0; b < system.topology.body_count(s.size()); ++b) {
    if (is_one_site(system, b)) turn_less(s.spin[system.topology.body_begin(b)]);
    if constexpr (Dim == 2)
      if (const int r = is_one_site(system, b) ? -1 : rigid_index(system, b); r >= 0) {
        if (held(system, r)) continue;
        slow(system.rigid.velocity[r], system.rigid.centre[r]);
        turn_less(system.rigid.spin[r]);
        place_sites(system, r);
        continue;
      }
    if (is_one_site(system, b) || drag == Drag::sites) {
      for_sites(system, b, [&](int i) {
        if (s.mobility[i] == Mobility::free) slow(s.velocity[i], s.position[i]);
      });
    } else {
      const BodyMotion<Dim> m = body_motion(system, b);
      const Vec<Dim> relative = m.velocity - system.box.flow_velocity(m.centre);
      add_motion(system, b, factor - 1, m.centre, relative, m.spin - rotation);
    }
  }
}

namespace {

/// Moves body b, with all its sites, by `back`, to the image whose velocity is another by `jump`.
template <int Dim>
void move_to_image(System<Dim>& system, int b, const Vec<Dim>& back, const Vec<Dim>& jump) {
  if constexpr (Dim == 2)
    if (const int r = rigid_index(system, b); r >= 0) {
      system.rigid.centre[r] -= back;
      system.rigid.velocity[r] += jump;
      return place_sites(system, r);
    }
  for_sites(system, b, [&](int i) {
    system.state.position[i] -= back;
    system.state.velocity[i] += jump;
  });
}

}  // namespace

template <int Dim>
bool wrap_bodies(System<Dim>& system) {
  State<Dim>& s = system.state;
  if (system.topology.begin.empty()) {
    for (int i = 0; i < s.size(); ++i) wrap_site(system, i);
    return false;
  }
  bool moved = false;
  std::vector<std::int32_t> body;
  for (int b = 0; b < system.topology.body_count(s.size()); ++b) {
    Vec<Dim> centre = centre_of_mass(system, b), velocity{};
    const Vec<Dim> n = system.box.wrap(centre, velocity);
    if (n == Vec<Dim>{} || !is_passable(system.topology.body_begin(b), n)) continue;
    move_to_image(system, b, system.box.lattice().vector(n), velocity);
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

// clang-format off
#define SUPPLE_BODY_FLOW(Dim) \
  template Vec<Dim> centre_of_mass(const System<Dim>&, int); \
  template BodyMotion<Dim> body_motion(const System<Dim>&, int); \
  template void set_strain_rate(System<Dim>&, double); \
  template bool has_plates(const State<Dim>&); \
  template void leave_plates(System<Dim>&); \
  template void damp(System<Dim>&, double, Drag); \
  template bool wrap_bodies(System<Dim>&);
// clang-format on
SUPPLE_BODY_FLOW(2)
SUPPLE_BODY_FLOW(3)
#undef SUPPLE_BODY_FLOW

}  // namespace supple
