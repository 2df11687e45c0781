/// How forces, the flow and damping change velocities: the parts of a step of Mover.
#pragma once
#include "supple/core/error.hpp"
#include "supple/model/evaluation.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// Input error where a body of many vertices is rigid in 3D: such bodies do not move in time yet.
template <int Dim>
void refuse_rigid(const System<Dim>& system) {
  if (Dim == 3 && !system.rigid.empty())
    throw input_error("rigid bodies of many vertices do not move in time in 3D",
                      "the equation of motion of their orientation is missing",
                      "take shells with stiff triangles, or spheres");
}

/// What body b moves with: by itself, or with what holds one of its sites.
template <int Dim>
Mobility mobility_of_body(const System<Dim>& system, int b);

/// The one place of constraints: sites that are not free, and rigid bodies with such a site, have the
/// velocity of what holds them. Discs may turn in any case.
template <int Dim>
void hold(System<Dim>& system);

/// Velocities and spins after forces have acted for `time`.
template <int Dim>
void kick(System<Dim>& system, const Evaluation<Dim>& evaluation, double time);

/// The accelerations that these forces make (System::acceleration); 0 of what is held.
template <int Dim>
void accelerate(System<Dim>& system, const Evaluation<Dim>& evaluation);
/// Velocities and spins after `time` of these accelerations.
template <int Dim>
void push(System<Dim>& system, double time);
/// Damps by `factor`, which is done over `time`. Returns the accelerations that this is.
template <int Dim>
Acceleration<Dim> slow_down(System<Dim>& system, double factor, double time);
template <int Dim>
void add(const Acceleration<Dim>& terms, Acceleration<Dim>& to);

/// All of accelerate, push, set_strain_rate, slow_down, push and add for discs in one loop: the same
/// operations on each, the same bits.
template <int Dim>
void change_velocities_of_discs(System<Dim>& system, const Evaluation<Dim>& evaluation, double rate,
                                double half_before, double half_after, double damping);

}  // namespace supple
