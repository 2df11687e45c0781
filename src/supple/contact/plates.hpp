/// Purely repulsive plates at y = 0 and y = Ly, and walls wherever the cell is not periodic.
#pragma once
#include "supple/contact/laws/list.hpp"
#include "supple/model/evaluation.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// A free disc that overlaps a plate or wall is repelled without friction, as by its mirror image: by the
/// force F(d, d0) of `repulsion` with d = 2 y, d0 = 2 r and stiffness k, y the distance of its centre from
/// the plate. Adds to `out.force`, `out.wall` and (with Detail::energies) energy.wall.
void evaluate_plates(const System<2>& system, const Repulsion& repulsion, double k, Detail detail,
                     Evaluation<2>& out);

}  // namespace supple
