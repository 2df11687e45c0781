/// Bodies as wholes in a cell that is being sheared: each body takes the flow at its centre, is damped
/// relative to it, and crosses the boundary in one piece, so that nothing is torn.
#pragma once
#include "supple/model/system.hpp"

namespace supple {

/// The rigid part of the motion of a body: velocity of its centre of mass [length/time], and angular velocity
/// about that centre [1/time], counter-clockwise. `inertia` is about the centre, of sites as points. A body
/// of one site has all of these from its site, a rigid body from System::rigid.
struct BodyMotion {
  Vec2 centre{}, velocity{};
  double mass = 0, inertia = 0, spin = 0;
};
BodyMotion body_motion(const System<2>& system, int body);

/// The centre of mass alone [length].
Vec2 centre_of_mass(const System<2>& system, int body);

/// Sets the shear rate of the cell [1/time]. Each body takes the change of the flow velocity at its centre,
/// v_x += (y - Ly/2) change, and turns as the flow does, w -= change/2, as a rigid body; its shape follows
/// later, by the forces.
void set_strain_rate(System<2>& system, double rate);

/// Whether any site moves with a plate.
bool has_plates(const State<2>& state);
/// Sites that moved with plates are free again.
void leave_plates(System<2>& system);

/// What a drag acts on. bodies: the motion of each as a whole, so that the motion of its sites beyond this
/// rigid part stays; sites: each by itself. Discs and rigid bodies are wholes in either case.
enum class Drag { bodies, sites };

/// Multiplies by `factor` the velocity relative to the flow, of centres of bodies or of sites, and the
/// angular velocity of bodies relative to that of the flow, -rate/2. What is held keeps its velocity.
void damp(System<2>& system, double factor, Drag drag);

/// Brings each body whose centre has left the cell back into it, with all its sites, their velocities, and
/// the images of its contacts and links. Returns whether a body of a system with a topology has moved: rows
/// of the pair table may then be about other images, and the neighbour list must be made again. Throws as
/// wrap_site does.
bool wrap_bodies(System<2>& system);

}  // namespace supple
