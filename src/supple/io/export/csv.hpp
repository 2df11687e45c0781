/// A run as a table of comma-separated values.
#pragma once
#include <string>

#include "supple/core/new_file.hpp"
#include "supple/io/run/run_file.hpp"

namespace supple {

/// Writes the main table of `run` as CSV, with units in the header: "t [s]". Numbers are the shortest that
/// read back to the same double, in SI; those of deformable particles in the units of the run.
///
/// Deformable particles: the table "packing", one row per minimisation or pressure, or "motion", one row per
/// interval. Discs: the table "stress", one row per step. Throws a file error where the run has no such
/// table.
void export_csv(const RunFile& run, const std::string& path, Existing existing = Existing::refuse);

/// The table "energy" alike: a row per step. Throws an input error where the run has none.
void export_energy(const RunFile& run, const std::string& path, Existing existing = Existing::refuse);

/// Every contact of every frame, a row each: who touches whom, in which state, forces and their parts, in SI
/// or the units of the run.
void export_contacts(const RunFile& run, const std::string& path, Existing existing = Existing::refuse);

/// Runs of discs: one row per frame in the columns of the published package's trajectories, in micrometre, mg
/// and s (forces 1e-12 N/m), stresses in Pa: step, t, shear, shear_rate; x, y, vx, vy, phi, omega, fx, fy,
/// torque, movable of each disc; eight tensors where the run kept them; both shear stresses; the counts of
/// elementary forces; neighbours as i>j:state:elongation joined by semicolons, in ascending order, each pair
/// from both sides. Throws a file error where the run has no table of stress or a frame no row.
void export_trajectory(const RunFile& run, const std::string& path, Existing existing = Existing::refuse);

}  // namespace supple
