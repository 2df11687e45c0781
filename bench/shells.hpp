/// What a force evaluation of deformable particles costs, where the time goes, and how it grows.
#pragma once
#include "supple/experiment/packing.hpp"

namespace supple::bench {

/// Shells of 20 vertices compressed to this packing fraction, moved no more than until overlaps are gone: the
/// contacts are what they will be.
Packing<2> compressed_shells(int count, double packing_fraction);

/// Time of a force evaluation per vertex, of its parts, and of an iteration of FIRE, for shells of 20
/// vertices; `slower` is how many times slower this machine is than the one of the published figures (0:
/// unknown).
void print_shells(double slower);

/// The same evaluation from 1e2 to 1e6 vertices, beside what arithmetic and memory alone would take.
void print_shell_sizes();

}  // namespace supple::bench
