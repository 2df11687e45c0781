/// Rigid bodies: how a body becomes rigid, where its sites are, and what the forces on its sites do to it.
#pragma once
#include <algorithm>

#include "supple/core/parallel.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// Makes body b rigid in its present shape, at angle 0, with the momentum and angular momentum of its sites.
/// Its shape energy is gone. Input errors: a body that does not exist, is rigid already, or has no extent (a
/// disc moves as a site).
void make_rigid(System<2>& system, int b);

/// Index in System::rigid of body b; -1: it is not rigid.
int rigid_index(const System<2>& system, int b);

/// visit(i) for each site in [begin, end) that is no part of a rigid body, ascending.
template <int Dim, class Visit>
void for_sites_apart(const System<Dim>& system, int begin, int end, const Visit& visit) {
  const std::vector<std::int32_t>& rigid = system.rigid.body;
  auto body = std::partition_point(rigid.begin(), rigid.end(),
                                   [&](std::int32_t b) { return system.topology.body_end(b) <= begin; });
  for (int i = begin; i < end;) {  // one loop over sites, that compilers make one piece with `visit`
    const int stop = body == rigid.end() ? end : std::min(end, system.topology.body_begin(*body));
    for (; i < stop; ++i) visit(i);
    if (body != rigid.end() && i < end) i = system.topology.body_end(*body++);
  }
}
/// The same for all sites, ascending; or in chunks, which threads share.
template <int Dim, class Visit>
void for_sites_apart(const System<Dim>& system, const Visit& visit) {
  for_sites_apart(system, 0, system.state.size(), visit);
}
template <int Dim, class Visit>
void share_sites_apart(const System<Dim>& system, const Visit& visit) {
  for_chunks(system.state.size(), [&](std::int64_t, std::int64_t begin, std::int64_t end) {
    for_sites_apart(system, static_cast<int>(begin), static_cast<int>(end), visit);
  });
}

/// Sets positions and velocities of the sites of all rigid bodies from their centres, angles, velocities and
/// spins. Call it after changing any of these. Where velocities lag behind (System::lag), that of a site is
/// of the straight step that it made, v = (x(t) - x(t - lag))/lag, as for all other sites: a rotation with
/// tan(w lag/2)/(lag/2) about the middles of these steps (Instant).
void place_sites(System<2>& system);
void place_sites(System<2>& system, int r);

/// What forces on the sites of a rigid body do to it.
struct RigidForce {
  Vec2 force;     ///< on its centre of mass
  double torque;  ///< about the centre of mass, counter-clockwise
};
/// Net force and torque on rigid body r (an index of System::rigid), from the forces on all sites.
RigidForce force_on_rigid(const System<2>& system, const std::vector<Vec2>& force, int r);

/// What the forces that keep rigid bodies together add to the virial at rest [energy]: the sum of -F (x -
/// centre)^T over their sites, F the forces given. The virial is then -dU/d(strain) for rigid bodies that
/// move with their centres and keep shape and angle. Bodies that are held add nothing: what holds them acts
/// on their sites.
Mat2 rigid_virial(const System<2>& system, const std::vector<Vec2>& force);

/// Whether rigid body r cannot move: a body is held where any of its sites is not free.
bool held(const System<2>& system, int r);

/// Radius of gyration, sqrt(inertia/mass) [length]. An angle times this radius is a length.
double gyration_radius(const RigidBodies& rigid, int r);

}  // namespace supple
