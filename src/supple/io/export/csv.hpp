/// A run as a table of comma-separated values.
#pragma once
#include <string>

#include "supple/core/new_file.hpp"
#include "supple/io/run/run_file.hpp"

namespace supple {

/// Writes the main table of `run` as CSV, with units in the header: "t [s]". Numbers are in SI, for
/// deformable particles in the units of the run, and the shortest that read back to the same double.
///
/// The main table is "packing" (one row per minimisation or pressure), "motion" (one row per interval),
/// "friction" (one row per place) or else, of sheared discs and particles, "stress" (one row per step).
/// Throws a file error where the run has none.
void export_csv(const RunFile& run, const std::string& path, Existing existing = Existing::refuse);

/// Writes the table "energy" likewise, a row per step. Throws an input error where the run has none.
void export_energy(const RunFile& run, const std::string& path, Existing existing = Existing::refuse);

/// Writes a row for every contact of every frame: the two sites, the state, the elongation, forces and their
/// parts, and the components of the force on the first site (two or, in 3D, three), in SI or, for deformable
/// particles, the units of the run.
void export_contacts(const RunFile& run, const std::string& path, Existing existing = Existing::refuse);

/// Writes a run of discs with one row per frame, in the columns of the published package's trajectories:
/// step, t, shear, shear_rate; x, y, vx, vy, phi, omega, fx, fy, torque, movable of each disc; eight tensors
/// if the run kept them; both shear stresses; the numbers of elementary forces
/// (StressTensors::pair_register); neighbours as i>j:state:elongation, joined by semicolons, ascending, each
/// pair from both sides. Units are micrometre, mg and s (forces 1e-12 N/m), stresses in Pa. Throws a file
/// error where the run is of three dimensions, has no table "stress" or that has no row for a frame.
void export_trajectory(const RunFile& run, const std::string& path, Existing existing = Existing::refuse);

}  // namespace supple
