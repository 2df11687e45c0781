/// Exponents of the force of plates on a particle against their compression.
#pragma once
#include "supple/experiment/case.hpp"
#include "supple/experiment/recorder.hpp"

namespace supple {

/// The table of the equilibria between the plates, with the columns compression, force, upper_nodes,
/// lower_nodes and branch (1: on the way down, -1: on the way up) among others.
inline constexpr const char* plate_table = "plates";

/// Fits power laws to that table: over the window of the case, as results of each branch with their standard
/// errors; and round each compression, as the table "local_exponents". Warns where no exponent can be found.
void record_exponents(const PlateCompression& plates, Recorder& recorder);

/// Vertices at the plate that fewer touch, at the largest compression.
double touching_nodes(Recorder& recorder);

}  // namespace supple
