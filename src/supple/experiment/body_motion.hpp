/// Motion of bodies in time, as experiments need it: the step, velocities at the start, the table.
#pragma once
#include <optional>

#include "supple/experiment/packing_record.hpp"
#include "supple/solve/mover.hpp"
#include "supple/solve/time_step.hpp"

namespace supple {

/// Time step [time]. Without keys of [time] it is that of the run to go on from, so that the bits are the
/// same; else time.step or, where that is 0, step_factor times the share `of_limit` of the stability limit
/// (default_step).
template <int Dim>
double body_time_step(const Case& c, Packing<Dim>& packing, const InitialState* initial, double of_limit);

/// The plastic law of the case; nullopt where preferred shapes stay.
std::optional<PlasticLaw> plastic_law(const Case& c);

/// Sets velocities, time and step to 0, and forgets where sites stick to the floor.
template <int Dim>
void put_at_rest(System<Dim>& system);

/// Gaussian velocities without net momentum, with a total kinetic energy of exactly `energy` for each site
/// outside rigid bodies and 3/2 `energy` for each rigid body: every motion has as much as another, so that a
/// component of a site has 2/Dim of `energy`/2. Spheres do not spin. Input error where only one site could
/// move.
template <int Dim>
void draw_velocities(System<Dim>& system, double energy, std::int64_t seed);

/// Columns and a row of the table of a motion: time, energies, pressure, mean height.
template <int Dim>
std::vector<Column> motion_columns(const Packing<Dim>& packing);
template <int Dim>
std::vector<double> motion_row(const Packing<Dim>& packing, const Evaluation<Dim>& evaluation);

}  // namespace supple
