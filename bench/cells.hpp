/// What the shape of the cell and the sizes of particles cost: neither should.
#pragma once

namespace supple::bench {

/// Time of a step of as many discs in a square cell, in thin ones, and with a few large discs among them; as
/// ratios.
void print_cells();

}  // namespace supple::bench
