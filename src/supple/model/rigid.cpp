#include "supple/model/rigid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "supple/core/error.hpp"
#include "supple/model/body_flow.hpp"

namespace supple {

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

int rigid_index(const System<2>& system, int b) {
  const std::vector<std::int32_t>& body = system.rigid.body;
  const auto at = std::lower_bound(body.begin(), body.end(), b);
  return at != body.end() && *at == b ? static_cast<int>(at - body.begin()) : -1;
}

void make_rigid(System<2>& system, int b) {
  RigidBodies& rigid = system.rigid;
  const int bodies = system.topology.body_count(system.state.size());
  if (b < 0 || b >= bodies)
    throw input_error(fmt::format("body {} cannot be rigid", b), fmt::format("there are {} bodies", bodies));
  const auto place = std::lower_bound(rigid.body.begin(), rigid.body.end(), b);
  if (place != rigid.body.end() && *place == b) throw input_error(fmt::format("body {} is rigid already", b));
  const BodyMotion m = body_motion(system, b);
  if (system.topology.body_size(b) == 1 || !(m.inertia > 0))
    throw input_error(fmt::format("body {} cannot be rigid", b), "it has no extent or no mass",
                      "a disc moves as a site");

  const auto r = static_cast<std::size_t>(place - rigid.body.begin());
  const auto insert = [r](auto& array, const auto& value) {
    array.insert(array.begin() + static_cast<std::ptrdiff_t>(r), value);
  };
  insert(rigid.body, b);
  insert(rigid.centre, m.centre);
  insert(rigid.velocity, m.velocity);
  insert(rigid.angle, 0.0);
  insert(rigid.spin, m.spin);
  insert(rigid.mass, m.mass);
  insert(rigid.inertia, m.inertia);
  if (rigid.begin.empty()) rigid.begin = {0};
  std::vector<Vec2> offset;
  for (int i = system.topology.body_begin(b); i < system.topology.body_end(b); ++i)
    offset.push_back(system.state.position[i] - m.centre);
  rigid.offset.insert(rigid.offset.begin() + rigid.begin[r], offset.begin(), offset.end());
  insert(rigid.begin, rigid.begin[r]);
  for (std::size_t k = r + 1; k < rigid.begin.size(); ++k)
    rigid.begin[k] += static_cast<std::int32_t>(offset.size());
  if (!system.shape.empty()) system.shape.stiffness[static_cast<std::size_t>(b)] = {};
  place_sites(system, static_cast<int>(r));
}

void place_sites(System<2>& system) {
  for (int r = 0; r < system.rigid.size(); ++r) place_sites(system, r);
}

RigidForce force_on_rigid(const System<2>& system, const std::vector<Vec2>& force, int r) {
  RigidForce total{};
  const int b = system.rigid.body[r];
  for (int i = system.topology.body_begin(b); i < system.topology.body_end(b); ++i) {
    total.force += force[i];
    total.torque += cross(system.state.position[i] - system.rigid.centre[r], force[i]);
  }
  return total;
}

Mat2 rigid_virial(const System<2>& system, const std::vector<Vec2>& force) {
  Mat2 sum;
  for (int r = 0; r < system.rigid.size(); ++r) {
    if (held(system, r)) continue;
    const int b = system.rigid.body[r];
    for (int i = system.topology.body_begin(b); i < system.topology.body_end(b); ++i)
      sum.add_outer(-1, force[i], system.state.position[i] - system.rigid.centre[r]);
  }
  return sum;
}

bool held(const System<2>& system, int r) {
  const int b = system.rigid.body[r];
  for (int i = system.topology.body_begin(b); i < system.topology.body_end(b); ++i)
    if (system.state.mobility[i] != Mobility::free) return true;
  return false;
}

double gyration_radius(const RigidBodies& rigid, int r) {
  return std::sqrt(rigid.inertia[r] / rigid.mass[r]);
}

}  // namespace supple
