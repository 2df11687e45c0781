#include "supple/contact/walls.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "supple/core/error.hpp"

namespace supple {

namespace {

constexpr double unstuck = std::numeric_limits<double>::quiet_NaN();

/// visit(site, direction, distance, sign of the push) for each site that overlaps a wall.
template <int Dim, class Visit>
void for_overlaps(const System<Dim>& system, const WallLaw<Dim>& walls, const Visit& visit) {
  const State<Dim>& state = system.state;
  for (std::int32_t i = 0; i < state.size(); ++i)
    for (int d = 0; d < Dim; ++d) {
      if (system.box.periodic[d]) continue;
      const double x = state.position[i][d], to_top = system.box.length[d] - x;
      if (walls.stands[d][0] && x < state.radius[i]) visit(i, d, x, 1);
      if (walls.stands[d][1] && to_top < state.radius[i]) visit(i, d, to_top, -1);
    }
}

/// Friction of a site that presses on the floor with `normal`: a spring to the point where it sticks, which
/// is dragged along when the spring pulls more than Coulomb allows.
double drag(double friction, double spring, double x, double normal, double stuck_at, double& trial) {
  trial = std::isnan(stuck_at) ? x : stuck_at;
  const double most = friction * normal / spring;
  trial = std::clamp(trial, x - most, x + most);
  return spring * (trial - x);
}

}  // namespace

template <int Dim>
void evaluate_walls(const System<Dim>& system, const WallLaw<Dim>& walls, Detail detail,
                    Evaluation<Dim>& out) {
  const bool friction = walls.floor_friction > 0;
  if (friction && Dim != 2)
    throw input_error("friction of the floor in 3D", "a site sticks to one number, where it is along x",
                      "give a floor without friction");
  const auto n = static_cast<std::size_t>(system.state.size());
  if (friction) out.trial_floor_contact.assign(n, unstuck);
  for_overlaps(system, walls, [&](std::int32_t i, int d, double distance, int sign) {
    const double radius = system.state.radius[i], spring = walls.repulsion.spring(2 * radius),
                 push = spring * (radius - distance);
    Vec<Dim> force{};
    force[d] = sign * push;
    if (friction && d == gradient && sign > 0) {
      const double stuck_at = system.floor_contact.size() == n ? system.floor_contact[i] : unstuck;
      const double along = walls.floor_stiffness * spring;
      force[flow] = drag(walls.floor_friction, along, system.state.position[i][flow], push, stuck_at,
                         out.trial_floor_contact[i]);
      if (detail == Detail::energies) out.energy.tangential += 0.5 * force[flow] * force[flow] / along;
    }
    out.force[i] += force;
    out.wall.push_back({i, force});
    if (detail == Detail::forces) return;
    out.energy.wall += 0.5 * spring * (radius - distance) * (radius - distance);
    out.virial[d][d] += push * distance;
  });
}

template <int Dim>
void add_wall_hessian(const System<Dim>& system, const WallLaw<Dim>& walls, HessianBlocks<Dim>& blocks) {
  for_overlaps(system, walls, [&](std::int32_t i, int d, double, int) {
    HessianBlock<Dim> block{i, i, {}};
    block.h[d][d] = walls.repulsion.spring(2 * system.state.radius[i]);
    blocks.push_back(block);
  });
}

template void evaluate_walls(const System<2>&, const WallLaw<2>&, Detail, Evaluation<2>&);
template void evaluate_walls(const System<3>&, const WallLaw<3>&, Detail, Evaluation<3>&);
template void add_wall_hessian(const System<2>&, const WallLaw<2>&, HessianBlocks<2>&);
template void add_wall_hessian(const System<3>&, const WallLaw<3>&, HessianBlocks<3>&);

}  // namespace supple
