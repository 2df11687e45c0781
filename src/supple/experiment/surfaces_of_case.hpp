/// The particles in 3D that a case describes.
#pragma once
#include <functional>
#include <vector>

#include "supple/experiment/case.hpp"
#include "supple/experiment/random_surfaces.hpp"

namespace supple {

/// Its species (species_of) as surfaces and spheres, in the same order.
std::vector<SurfaceKind> surface_kinds(const Case& c);

/// The cubic periodic cell that they are for, and what they cover there.
struct LooseSurfaces {
  double volume = 0;  ///< that all particles cover when apart [length^3]
  Box<3> cell;
};
/// Of each kind one particle is measured. Input error where the largest does not fit into the cell.
LooseSurfaces loose_surfaces(const Case& c, double packing_fraction);

/// The particles in a cubic array, far apart.
System<3> surfaces_apart(const Case& c);

/// The particles at random positions in that cell, moved apart as far as can be. Input error where there is
/// no room; `interrupted` where asked to stop.
System<3> random_surface_packing(const Case& c, double packing_fraction,
                                 const std::function<bool()>& stop_requested = {});

}  // namespace supple
