/// Second derivatives of the shape energy of one polygon, in closed form.
#pragma once
#include "supple/model/hessian.hpp"
#include "supple/model/outer_product.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// Adds the blocks (i, j <= i) of body b [energy/length^2], one for each pair of its vertices, as the area
/// couples all of them. HessianKind::sparse leaves out k_a (da/dx)(da/dx)^T, and with it all pairs but first
/// and second neighbours, if the corners are stiff and the area resists a uniform swelling less than the
/// edges do; other bodies have all blocks. If `products` is given, the part k_a (da/dx)(da/dx)^T of a ring of
/// five vertices or more goes there.
void add_ring_hessian(const System<2>& system, int b, HessianBlocks<2>& blocks,
                      HessianKind kind = HessianKind::exact, OuterProducts<2>* products = nullptr);

}  // namespace supple
