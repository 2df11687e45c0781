/// Second derivatives of the shape energy of one polygon, in closed form.
#pragma once
#include "supple/model/hessian.hpp"
#include "supple/model/outer_product.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// Adds the blocks (i, j <= i) of body b, one for each pair of its vertices: the area couples all of them.
/// `sparse` leaves out k_a (da/dx)(da/dx)^T, and with it all pairs but first and second neighbours, where
/// corners are stiff and the area resists a uniform swelling less than the edges do. Given `products`, of
/// five vertices or more that part goes there.
void add_ring_hessian(const System<2>& system, int b, HessianBlocks<2>& blocks,
                      HessianKind kind = HessianKind::exact, OuterProducts<2>* products = nullptr);

}  // namespace supple
