/// Time steps that bodies of many sites need.
#pragma once
#include "supple/force/force_field.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// An upper bound of the largest angular frequency [1/time] of small motions about the present state, valid
/// also if six (3D: twelve) more neighbours and a wall come to press on a site: 6 k/m is the largest squared
/// frequency of a triangular crystal of sites, the densest packing, and 8 k/m that of a face-centred cubic
/// one, the densest of spheres. Both are 2 k/m times the sum of n n^T over the neighbours. The part of
/// present contacts and terms is the largest row sum of |mass-weighted Hessian|, sharpened by iterations of
/// Collatz (1942); for shells it is within 12 % of their largest frequency.
template <int Dim>
double frequency_bound(System<Dim>& system, ForceField<Dim>& forces);

/// Largest stable step [time] of the leapfrog for an oscillator of angular frequency omega [1/time] and
/// damping ratio z: 2/omega (sqrt(1 + 4 z^2) - 2 z). Its dashpot sees the velocity brought forward to the
/// instant of the force, (3 v(t - dt/2) - v(t - 3 dt/2))/2 without other forces, and so bears half of the
/// step that it would bear with the velocity of t - dt/2, 2/omega (sqrt(1 + z^2) - z) [O'Sullivan & Bray
/// 2004].
double leapfrog_limit(double omega, double damping_ratio);

/// Time steps as shares of the stability limit: where energy is to be conserved, and for damped motion.
constexpr double conserving_step = 0.02, damped_step = 0.3;

/// A time step [time]: `fraction` of the stability limit 2/omega of the Verlet method, omega by
/// frequency_bound(). Where contacts open and close, stiffness jumps, and the energy makes a small random
/// walk that grows with about the fourth power of the step. With the default fraction the energy changes over
/// 1e5 steps by about 5e-6 of its value (16 polygons of any family, packing fractions 0.6 and 0.8, kinetic
/// energies 1e-6 to 1e-3 per vertex; rigid ones: 6.6e-6 root mean square of 20 runs, 1.6e-5 at most), by up
/// to 3e-4 for smooth discs, whose contacts are their only forces. Input error where nothing acts.
template <int Dim>
double default_step(System<Dim>& system, ForceField<Dim>& forces, double fraction = conserving_step);

}  // namespace supple
