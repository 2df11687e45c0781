/// Packings of deformable particles: how long jamming takes.
#pragma once
#include "supple/experiment/case.hpp"

namespace supple::bench {

/// Shells as the published tasks have them: all energies relative, large particles with more vertices.
Case shell_case(int count, int vertices);

/// Jamming tasks A, B, C and E, three seeds each, beside the published times; `slower` is how many times
/// slower this machine is than the one of those (0: unknown).
void print_jamming(double slower);

}  // namespace supple::bench
