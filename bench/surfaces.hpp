/// What the shape energy of triangulated surfaces costs.
#pragma once

namespace supple::bench {

/// Time of the one pass (SurfaceShape) per vertex, with and without energies, beside that of the terms that
/// it stands for and what its arithmetic alone would take, at 64 bodies of 42 vertices and as many vertices
/// in smaller and larger bodies; with and without bending.
void print_surfaces();

}  // namespace supple::bench
