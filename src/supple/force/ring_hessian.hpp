/// Second derivatives of the shape energy of one polygon, in closed form.
#pragma once
#include "supple/model/hessian.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// Adds the blocks (i, j <= i) of body b, one for each pair of its vertices: the area couples all of them.
void add_ring_hessian(const System<2>& system, int b, HessianBlocks<2>& blocks);

}  // namespace supple
