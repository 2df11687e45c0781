/// How forces, the flow and damping change velocities: the parts of a step of Mover.
#pragma once
#include "supple/model/evaluation.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// What body b moves with: by itself, or with what holds one of its sites.
Mobility mobility_of_body(const System<2>& system, int b);

/// The one place of constraints: sites that are not free, and rigid bodies with such a site, have the
/// velocity of what holds them. Discs may turn in any case.
void hold(System<2>& system);

/// Velocities and spins after forces have acted for `time`.
void kick(System<2>& system, const Evaluation<2>& evaluation, double time);

/// The accelerations that these forces make (System::acceleration); 0 of what is held.
void accelerate(System<2>& system, const Evaluation<2>& evaluation);
/// Velocities and spins after `time` of these accelerations.
void push(System<2>& system, double time);
/// Damps by `factor`, which is done over `time`. Returns the accelerations that this is.
Acceleration<2> slow_down(System<2>& system, double factor, double time);
void add(const Acceleration<2>& terms, Acceleration<2>& to);

/// All of accelerate, push, set_strain_rate, slow_down, push and add for discs in one loop: the same
/// operations on each, the same bits.
void change_velocities_of_discs(System<2>& system, const Evaluation<2>& evaluation, double rate,
                                double half_before, double half_after, double damping);

}  // namespace supple
