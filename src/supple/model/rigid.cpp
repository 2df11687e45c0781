#include "supple/model/rigid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "supple/core/error.hpp"
#include "supple/core/rotation.hpp"
#include "supple/model/body_flow.hpp"

namespace supple {

template <>
void place_sites(System<2>& system, int r) {
  const RigidBodies& rigid = system.rigid;
  State<2>& s = system.state;
  const double c = std::cos(rigid.angle[r]), sine = std::sin(rigid.angle[r]);
  // R(angle) - R(angle - w lag) = 2 sin(w lag/2) z x R(angle - w lag/2).
  const double half = 0.5 * system.lag, turn = half * rigid.spin[r];
  const double rate = half > 0 ? std::sin(turn) / half : rigid.spin[r];
  const double back_c = std::cos(turn), back_s = std::sin(turn);
  int i = system.topology.body_begin(rigid.body[r]);
  for (int k = rigid.begin[r]; k < rigid.begin[r + 1]; ++k, ++i) {
    const Vec2 o = rigid.offset[k], arm{c * o[0] - sine * o[1], sine * o[0] + c * o[1]};
    s.position[i] = rigid.centre[r] + arm;
    s.velocity[i] = rigid.velocity[r] + cross(rate, back_c * arm - cross(back_s, arm));
  }
}

template <>
void place_sites(System<3>& system, int r) {
  const RigidBodiesOf<3>& rigid = system.rigid;
  State<3>& s = system.state;
  const Mat<3> placed = rotation(rigid.angle[r]);
  // As in 2D: the chord of a circle is across its radius in the middle of the step.
  const Vec3 turn = 0.5 * system.lag * rigid.spin[r];
  const double half_angle = norm(turn);
  const Vec3 rate = half_angle > 0 ? std::sin(half_angle) / half_angle * rigid.spin[r] : rigid.spin[r];
  const Mat<3> back = rotation(-turn);
  int i = system.topology.body_begin(rigid.body[r]);
  for (int k = rigid.begin[r]; k < rigid.begin[r + 1]; ++k, ++i) {
    const Vec3 arm = placed * rigid.offset[k];
    s.position[i] = rigid.centre[r] + arm;
    s.velocity[i] = rigid.velocity[r] + cross(rate, back * arm);
  }
}

template <int Dim>
int rigid_index(const System<Dim>& system, int b) {
  const std::vector<std::int32_t>& body = system.rigid.body;
  const auto at = std::lower_bound(body.begin(), body.end(), b);
  return at != body.end() && *at == b ? static_cast<int>(at - body.begin()) : -1;
}

namespace {

/// A body as a whole: its mass, its inertia about the centre of mass, and its motion.
template <int Dim>
struct Whole {
  Vec<Dim> centre{}, velocity{};
  double mass = 0;
  Inertia<Dim> inertia{};
  Angular<Dim> spin{};
  bool has_extent = false;  ///< in every direction that it could spin about
};

Whole<2> whole_of(const System<2>& system, int b) {
  const auto m = body_motion(system, b);
  return {m.centre, m.velocity, m.mass, m.inertia, m.spin, system.topology.body_size(b) > 1 && m.inertia > 0};
}

double trace(const Mat<3>& m) { return m[0][0] + m[1][1] + m[2][2]; }

Whole<3> whole_of(const System<3>& system, int b) {
  const State<3>& s = system.state;
  const int first = system.topology.body_begin(b), end = system.topology.body_end(b);
  Whole<3> w;
  Vec3 moment{}, momentum{}, angular{};
  for (int i = first; i < end; ++i) {
    w.mass += s.mass[i];
    moment += s.mass[i] * (s.position[i] - s.position[first]);
    momentum += s.mass[i] * s.velocity[i];
  }
  w.centre = s.position[first] + 1 / w.mass * moment;
  w.velocity = 1 / w.mass * momentum;
  for (int i = first; i < end; ++i) {
    const Vec3 arm = s.position[i] - w.centre;
    w.inertia.add_outer(-s.mass[i], arm, arm);
    for (int d = 0; d < 3; ++d) w.inertia[d][d] += s.mass[i] * dot(arm, arm);
    angular += s.mass[i] * cross(arm, s.velocity[i]);
  }
  // The determinant is the product of the moments, of which one is 0 where all sites are on a line.
  const Mat<3>& m = w.inertia;
  const double size = trace(m),
               determinant = dot(Vec3{m[0][0], m[0][1], m[0][2]},
                                 cross(Vec3{m[1][0], m[1][1], m[1][2]}, Vec3{m[2][0], m[2][1], m[2][2]}));
  w.has_extent = determinant > 1e-12 * size * size * size;
  if (w.has_extent) w.spin = solution(m, angular);
  return w;
}

}  // namespace

template <int Dim>
void make_rigid(System<Dim>& system, int b) {
  RigidBodiesOf<Dim>& rigid = system.rigid;
  const int bodies = system.topology.body_count(system.state.size());
  if (b < 0 || b >= bodies)
    throw input_error(fmt::format("body {} cannot be rigid", b), fmt::format("there are {} bodies", bodies));
  const auto place = std::lower_bound(rigid.body.begin(), rigid.body.end(), b);
  if (place != rigid.body.end() && *place == b) throw input_error(fmt::format("body {} is rigid already", b));
  const Whole<Dim> m = whole_of(system, b);
  if (!m.has_extent)
    throw input_error(fmt::format("body {} cannot be rigid", b), "it has no extent or no mass",
                      Dim == 2 ? "a disc moves as a site" : "a sphere moves as a site");

  const auto r = static_cast<std::size_t>(place - rigid.body.begin());
  const auto insert = [r](auto& array, const auto& value) {
    array.insert(array.begin() + static_cast<std::ptrdiff_t>(r), value);
  };
  insert(rigid.body, b);
  insert(rigid.centre, m.centre);
  insert(rigid.velocity, m.velocity);
  insert(rigid.angle, Angular<Dim>{});
  insert(rigid.spin, m.spin);
  insert(rigid.mass, m.mass);
  insert(rigid.inertia, m.inertia);
  if (rigid.begin.empty()) rigid.begin = {0};
  std::vector<Vec<Dim>> offset;
  for (int i = system.topology.body_begin(b); i < system.topology.body_end(b); ++i)
    offset.push_back(system.state.position[i] - m.centre);
  rigid.offset.insert(rigid.offset.begin() + rigid.begin[r], offset.begin(), offset.end());
  insert(rigid.begin, rigid.begin[r]);
  for (std::size_t k = r + 1; k < rigid.begin.size(); ++k)
    rigid.begin[k] += static_cast<std::int32_t>(offset.size());
  if (!system.shape.empty()) system.shape.stiffness[static_cast<std::size_t>(b)] = {};
  place_sites(system, static_cast<int>(r));
}

template <int Dim>
void place_sites(System<Dim>& system) {
  for (int r = 0; r < system.rigid.size(); ++r) place_sites(system, r);
}

void shorten_angles(System<3>& system) {
  for (Vec3& angle : system.rigid.angle) angle = shortest(angle);
}

template <int Dim>
RigidForceOf<Dim> force_on_rigid(const System<Dim>& system, const std::vector<Vec<Dim>>& force, int r) {
  RigidForceOf<Dim> total{};
  const int b = system.rigid.body[r];
  for (int i = system.topology.body_begin(b); i < system.topology.body_end(b); ++i) {
    total.force += force[i];
    total.torque += cross(system.state.position[i] - system.rigid.centre[r], force[i]);
  }
  return total;
}

template <>
double spin_change(const System<2>& system, int r, const double& torque) {
  return torque / system.rigid.inertia[r];
}
template <>
Vec3 spin_change(const System<3>& system, int r, const Vec3& torque) {
  const Mat<3> inertia = turned(system.rigid.inertia[r], rotation(system.rigid.angle[r]));
  const Vec3& spin = system.rigid.spin[r];
  return solution(inertia, torque - cross(spin, inertia * spin));
}

template <int Dim>
Mat<Dim> rigid_virial(const System<Dim>& system, const std::vector<Vec<Dim>>& force) {
  Mat<Dim> sum;
  for (int r = 0; r < system.rigid.size(); ++r) {
    if (held(system, r)) continue;
    const int b = system.rigid.body[r];
    for (int i = system.topology.body_begin(b); i < system.topology.body_end(b); ++i)
      sum.add_outer(-1, force[i], system.state.position[i] - system.rigid.centre[r]);
  }
  return sum;
}

template <int Dim>
bool held(const System<Dim>& system, int r) {
  const int b = system.rigid.body[r];
  for (int i = system.topology.body_begin(b); i < system.topology.body_end(b); ++i)
    if (system.state.mobility[i] != Mobility::free) return true;
  return false;
}

template <>
double gyration_radius(const RigidBodiesOf<2>& rigid, int r) {
  return std::sqrt(rigid.inertia[r] / rigid.mass[r]);
}
template <>
double gyration_radius(const RigidBodiesOf<3>& rigid, int r) {
  return std::sqrt(trace(rigid.inertia[r]) / (3 * rigid.mass[r]));
}

// clang-format off
#define SUPPLE_RIGID(Dim)                                                                            \
  template void make_rigid(System<Dim>&, int);                                                       \
  template int rigid_index(const System<Dim>&, int);                                                 \
  template void place_sites(System<Dim>&);                                                           \
  template RigidForceOf<Dim> force_on_rigid(const System<Dim>&, const std::vector<Vec<Dim>>&, int);  \
  template Mat<Dim> rigid_virial(const System<Dim>&, const std::vector<Vec<Dim>>&);                  \
  template bool held(const System<Dim>&, int);
// clang-format on
SUPPLE_RIGID(2)
SUPPLE_RIGID(3)
#undef SUPPLE_RIGID

}  // namespace supple
