/// LAMMPS beside Supple: the same discs, the same law, the same number of steps.
#pragma once
#include <string>

#include "supple/contact/laws/list.hpp"
#include "supple/model/system.hpp"

namespace supple::bench {

/// What a run of LAMMPS reports.
struct LammpsRun {
  double seconds = 0;   ///< CPU time of its time loop
  long builds = 0;      ///< neighbour lists built
  double speed = 0;     ///< root mean square velocity component at the end
  double contacts = 0;  ///< per disc, at the end
};

/// Writes the discs as a data file and the input beside it.
void write_lammps_case(const std::string& folder, const System<2>& system, const DiscLaw& law,
                       double time_step);

/// Runs that case with one thread. `skin` is the distance that it adds to its neighbour list [length].
LammpsRun run_lammps(const std::string& folder, int steps, double skin);

/// Whether the command `lmp` is there.
bool lammps_found();

}  // namespace supple::bench
