/// What the inside of elastic solids costs.
#pragma once

namespace supple::bench {

/// Time of SolidTerms per spring of a disc and of a ball, and per triangle and tetrahedron, with and without
/// energies, beside what the arithmetic and the memory alone would take.
void print_solids();

}  // namespace supple::bench
