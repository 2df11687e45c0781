/// Purely repulsive plates at y = 0 and y = Ly, and walls wherever the cell is not periodic.
#pragma once
#include "supple/contact/laws/list.hpp"
#include "supple/model/evaluation.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// A free disc that overlaps a plate or wall is repelled, without friction, as by its mirror image: F(2 y, 2
/// r), y its height over the plate. Adds to force, wall and (on request) energy.wall.
void evaluate_plates(const System<2>& system, const Repulsion& repulsion, double k, Detail detail,
                     Evaluation<2>& out);

}  // namespace supple
