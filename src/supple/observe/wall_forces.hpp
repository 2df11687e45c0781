/// Forces between the walls of a box and the particles.
#pragma once
#include <span>

#include "supple/model/box.hpp"
#include "supple/model/evaluation.hpp"

namespace supple {

/// Pushes of the four walls on the particles, each at least 0, and `drag`, the friction of the floor on them
/// along the flow [force].
struct WallForces {
  double left = 0, right = 0, floor = 0, lid = 0;
  double drag = 0;
};

/// Sums Evaluation::wall. Side walls have no friction, so that a force with a part along the gradient is of
/// floor or lid.
WallForces sum_wall_forces(std::span<const SiteForce<2>> wall);

}  // namespace supple
