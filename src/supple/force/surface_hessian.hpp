/// Second derivatives of the shape energy of one triangulated surface, in closed form.
#pragma once
#include "supple/model/hessian.hpp"
#include "supple/model/outer_product.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// Whether body b of System::shape has triangles and some stiffness: neither a sphere nor rigid.
bool has_shape_energy(const System<3>& system, int b);

/// Adds the blocks of body b [energy/length^2], each pair of its vertices once, as the volume couples all of
/// them. HessianKind::sparse leaves out k_v (dv/dx)(dv/dx)^T, and with it all pairs but those of one hinge,
/// if the hinges are stiff and the volume resists a uniform swelling less than the triangles do; other bodies
/// have all blocks. If `products` is given, the part k_v (dv/dx)(dv/dx)^T goes there.
///
/// Pairs of one hinge have a block for each edge and, where hinges bend, one for the two outer vertices of
/// each hinge.
void add_surface_hessian(const System<3>& system, int b, HessianBlocks<3>& blocks,
                         HessianKind kind = HessianKind::exact, OuterProducts<3>* products = nullptr);

}  // namespace supple
