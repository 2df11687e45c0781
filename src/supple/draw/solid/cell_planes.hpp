/// The sides of a cell.
#pragma once
#include <vector>

#include "supple/draw/solid/solid_scene.hpp"

namespace supple {

/// The plane normal * x = level, the normal of length 1 and outward.
struct CellPlane {
  Vec3 normal;
  double level;   ///< [length]
  int direction;  ///< of the lattice vector that crosses it: 0, 1 or 2
};

/// The sides of the leaning cell (cell_corners), first the near one, then the far one of each direction.
std::vector<CellPlane> cell_planes(const Box<3>& box);

}  // namespace supple
