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
double body_time_step(const Case& c, Packing<2>& packing, const InitialState* initial, double of_limit);

/// The plastic law of the case; nullopt where preferred shapes stay.
std::optional<PlasticLaw> plastic_law(const Case& c);

/// Sets velocities, time and step to 0, and forgets where sites stick to the floor.
void put_at_rest(System<2>& system);

/// Gaussian velocities without net momentum, with a total kinetic energy of exactly `energy` for each site
/// outside rigid bodies and 3/2 `energy` for each rigid body. Input error where only one site could move.
void draw_velocities(System<2>& system, double energy, std::int64_t seed);

/// Columns and a row of the table of a motion: time, energies, pressure, mean height.
std::vector<Column> motion_columns(const Packing<2>& packing);
std::vector<double> motion_row(const Packing<2>& packing, const Evaluation<2>& evaluation);

}  // namespace supple
