/// Rigid bodies: how a body becomes rigid, where its sites are, and what the forces on its sites do to it.
#pragma once
#include <algorithm>

#include "supple/core/parallel.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// Makes body b rigid in its present shape, at angle 0, with the momentum and angular momentum of its sites.
/// Its shape energy is gone. Input errors: a body that does not exist, is rigid already, or has no extent (a
/// disc or a sphere moves as a site; in 3D sites on one line have no spin about it).
template <int Dim>
void make_rigid(System<Dim>& system, int b);

/// Index in System::rigid of body b; -1: it is not rigid.
template <int Dim>
int rigid_index(const System<Dim>& system, int b);

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
template <int Dim>
void place_sites(System<Dim>& system);
template <int Dim>
void place_sites(System<Dim>& system, int r);

/// In 3D, replaces rotation vectors longer than pi by the shortest of the same rotation: beyond, they are no
/// good coordinates (core/rotation.hpp).
void shorten_angles(System<3>& system);

/// What forces on the sites of a rigid body do to it.
template <int Dim>
struct RigidForceOf {
  Vec<Dim> force;       ///< on its centre of mass
  Angular<Dim> torque;  ///< about the centre of mass, counter-clockwise
};
using RigidForce = RigidForceOf<2>;
/// Net force and torque on rigid body r (an index of System::rigid), from the forces on all sites.
template <int Dim>
RigidForceOf<Dim> force_on_rigid(const System<Dim>& system, const std::vector<Vec<Dim>>& force, int r);

/// How fast the spin of rigid body r changes under this torque [1/time^2]; in 3D by Euler's equations, with
/// the spin that it has.
template <int Dim>
Angular<Dim> spin_change(const System<Dim>& system, int r, const Angular<Dim>& torque);

/// What the forces that keep rigid bodies together add to the virial at rest [energy]: the sum of -F (x -
/// centre)^T over their sites, F the forces given. The virial is then -dU/d(strain) for rigid bodies that
/// move with their centres and keep shape and angle. Bodies that are held add nothing: what holds them acts
/// on their sites.
template <int Dim>
Mat<Dim> rigid_virial(const System<Dim>& system, const std::vector<Vec<Dim>>& force);

/// Whether rigid body r cannot move: a body is held where any of its sites is not free.
template <int Dim>
bool held(const System<Dim>& system, int r);

/// Radius of gyration, sqrt(inertia/mass) [length], in 3D with the mean of the three moments of inertia. An
/// angle times this radius is a length.
template <int Dim>
double gyration_radius(const RigidBodiesOf<Dim>& rigid, int r);

}  // namespace supple
