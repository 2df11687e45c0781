/// Bodies as wholes in a cell that is being sheared: each body takes the flow at its centre, is damped
/// relative to it, and crosses the boundary in one piece, so that nothing is torn.
#pragma once
#include "supple/model/system.hpp"

namespace supple {

/// The rigid part of the motion of a body: velocity of its centre of mass [length/time], and angular velocity
/// about that centre [1/time], counter-clockwise: the one that has the angular momentum of the sites. In 3D
/// sites on one line have none. `inertia` is about the centre, of sites as points. A body of one site has all
/// of these from its site, a rigid body from System::rigid.
template <int Dim>
struct BodyMotion {
  Vec<Dim> centre{}, velocity{};
  double mass = 0;
  Inertia<Dim> inertia{};
  Angular<Dim> spin{};
};
template <int Dim>
BodyMotion<Dim> body_motion(const System<Dim>& system, int body);

/// The centre of mass alone [length].
template <int Dim>
Vec<Dim> centre_of_mass(const System<Dim>& system, int body);

/// Angular velocity of a flow that shears at `rate` [1/time], half of its vorticity: -rate/2 about z.
template <int Dim>
Angular<Dim> flow_spin(double rate) {
  if constexpr (Dim == 2) return -0.5 * rate;
  else return {0, 0, -0.5 * rate};
}

/// Sets the shear rate of the cell [1/time]. Each body takes the change of the flow velocity at its centre,
/// v_x += (y - Ly/2) change, and turns as the flow does, by flow_spin(change), as a rigid body; its shape
/// follows later, by the forces.
template <int Dim>
void set_strain_rate(System<Dim>& system, double rate);

/// Whether any site moves with a plate.
template <int Dim>
bool has_plates(const State<Dim>& state);
/// Sites that moved with plates are free again.
template <int Dim>
void leave_plates(System<Dim>& system);

/// What a drag acts on. bodies: the motion of each as a whole, so that the motion of its sites beyond this
/// rigid part stays; sites: each by itself. Discs and rigid bodies are wholes in either case.
enum class Drag { bodies, sites };

/// Multiplies by `factor` the velocity relative to the flow, of centres of bodies or of sites, and the
/// angular velocity of bodies relative to that of the flow (flow_spin). What is held keeps its velocity.
template <int Dim>
void damp(System<Dim>& system, double factor, Drag drag);

/// Brings each body whose centre has left the cell back into it, with all its sites, their velocities, and
/// the images of its contacts and links. Returns whether a body of a system with a topology has moved: rows
/// of the pair table may then be about other images, and the neighbour list must be made again. Throws as
/// wrap_site does.
template <int Dim>
bool wrap_bodies(System<Dim>& system);

}  // namespace supple
