/// Rigid bodies: how a body becomes one, where its sites are, and what forces on them amount to.
#pragma once
#include "supple/model/system.hpp"

namespace supple {

/// Makes body b rigid in its present shape, at angle 0, with the momentum and angular momentum of its sites;
/// it loses its shape energy. Input errors: a body that does not exist, is rigid already, or has no extent (a
/// disc moves as a site).
void make_rigid(System<2>& system, int b);

/// Positions and velocities of the sites of all rigid bodies, from centre, angle, velocity and spin. Call it
/// after changing those.
void place_sites(System<2>& system);

/// What forces on the sites of a rigid body do to it.
struct RigidForce {
  Vec2 force;     ///< on its centre of mass
  double torque;  ///< about it, counter-clockwise
};
/// Of rigid body r (an index of System::rigid), given forces on all sites.
RigidForce force_on_rigid(const System<2>& system, const std::vector<Vec2>& force, int r);

/// What the forces that keep the sites of rigid bodies together add to the virial under these forces on all
/// sites, at rest: sum of -F (x - centre)^T. With it the virial is -dU/d(strain) of bodies that move with
/// their centres and stay as they are. Bodies that are held add nothing: what holds them acts on their sites.
Mat2 rigid_virial(const System<2>& system, const std::vector<Vec2>& force);

/// Whether rigid body r stays where it is: where any of its sites is not free, none moves.
bool held(const System<2>& system, int r);

/// sqrt(inertia/mass), the length that makes an angle one [length].
double gyration_radius(const RigidBodies& rigid, int r);

}  // namespace supple
