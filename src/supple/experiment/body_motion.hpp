/// Steps of bodies in time, as experiments need them.
#pragma once
#include <optional>

#include "supple/experiment/packing_record.hpp"
#include "supple/solve/body_dynamics.hpp"

namespace supple {

/// Step of the case, or that of the run to go on from, so that the bits are the same; else `of_limit` of the
/// stability limit times step_factor.
double body_time_step(const Case& c, Packing& packing, const InitialState* initial, double of_limit);

/// How preferred shapes flow, where the case says that they do.
std::optional<PlasticLaw> plastic_law(const Case& c);

/// As if nothing had moved before: no velocities, time and step 0, no memory of the floor.
void put_at_rest(System<2>& system);

/// Gaussian velocities without net momentum of exactly this kinetic energy per site, and of 3/2 of it per
/// rigid body. Input error where only one site could move.
void draw_velocities(System<2>& system, double energy, std::int64_t seed);

/// Columns of a table of a motion: time, energies, momentum, pressure.
std::vector<Column> motion_columns(const Packing& packing);
std::vector<double> motion_row(const Packing& packing, const Evaluation<2>& evaluation);

}  // namespace supple
