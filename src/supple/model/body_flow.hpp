/// Bodies as wholes in a cell that is being sheared, so that nothing is torn: they take the flow of their
/// centre, lose their motion relative to it, and cross the boundary, each in one piece.
#pragma once
#include "supple/model/system.hpp"

namespace supple {

/// The rigid part of the motion of a body: velocity of its centre of mass, and angular velocity about it.
/// That of a body of one site is its own.
struct BodyMotion {
  Vec2 centre{}, velocity{};
  double mass = 0, inertia = 0, spin = 0;
};
BodyMotion body_motion(const System<2>& system, int body);

/// Its centre alone.
Vec2 centre_of_mass(const System<2>& system, int body);

/// What a change of the shear rate does to velocities and spins: each body takes the flow velocity of its
/// centre, v_x += (y - Ly/2) change, and the vorticity of the flow, w -= change/2, as a rigid rotation; its
/// shape is left to the forces.
void change_flow(const System<2>& system, double change, std::vector<Vec2>& velocity,
                 std::vector<double>& spin);

/// Changes the shear rate of the cell, and the motion of its bodies by change_flow().
void set_strain_rate(System<2>& system, double rate);

/// Multiplies by `factor` the velocity of each free body relative to the flow at its centre, and its rotation
/// relative to the rotation of the flow, -rate/2. How its sites move relative to each other stays.
void damp_bodies(System<2>& system, double factor);

/// Brings each body into the cell of its centre, with all its sites, their velocities, and the images of its
/// contacts and links. Returns whether any moved, of a system
/// that has bodies: its rows are about other images then. Numerics error as of wrap_site.
bool wrap_bodies(System<2>& system);

}  // namespace supple
