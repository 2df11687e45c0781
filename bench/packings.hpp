/// Packings of deformable particles: what an evaluation costs, and how long jamming takes.
#pragma once

namespace supple::bench {

/// Time of a force evaluation per vertex, and of its parts, for these shells of 20 vertices.
void print_shells();

/// Jamming tasks A, B, C and E, three seeds each, beside the published times; `slower` is how many times slower this machine is than
/// the one of those (0: unknown).
void print_jamming(double slower);

}  // namespace supple::bench
