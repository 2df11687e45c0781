/// Velocities of the instant of the positions, before the forces there are known.
#pragma once
#include "supple/model/evaluation.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// The velocity of what moves with a plate, or is fixed, in a cell that shears at `rate` [length/time].
template <int Dim>
Vec<Dim> plate_velocity(const Box<Dim>& box, Mobility mobility, double rate);

/// Brings velocities and spins that lag behind the positions to their instant, by System::acceleration, and
/// to a shear rate `rate` there: an extrapolation over half a step, whose error is of second order in the
/// step (the method of Adams and Bashforth for what depends on velocities). Where the shear rate jumps at
/// this instant, the mean of both sides is the rate whose impulse a leapfrog needs. Empties `out` where
/// nothing lags and the rate is that of the cell.
template <int Dim>
void present_motion(const System<Dim>& system, double rate, PresentMotion<Dim>& out);

}  // namespace supple
