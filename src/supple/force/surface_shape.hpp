/// The whole shape energy of triangulated surfaces in one pass over each: the fast path of 3D.
#pragma once
#include "supple/force/term_block.hpp"

namespace supple {

/// Energies of enclosed volume, triangle areas, hinge angles and surface tension [MacKeith 2025, eq. 9.2]
/// with the numbers of System::shape, which are read at each evaluation, as preferred shapes may flow. Bodies
/// are closed surfaces (add_surface), or have no triangles or no stiffness and then no energy; input error
/// otherwise. The terms of energy/ (shape_terms.hpp) give the same to rounding and are the reference.
class SurfaceShape final : public TermBlock<3> {
 public:
  std::string_view name() const override { return "surface_shape"; }
  double energy(const System<3>& system) const override;
  void evaluate(const System<3>& system, Detail detail, Evaluation<3>& out) const override;
  void add_hessian(const System<3>& system, HessianBlocks<3>& blocks) const override;
  void add_sparse_hessian(const System<3>& system, HessianBlocks<3>& blocks) const override;
  void add_joining_hessian(const System<3>&, HessianBlocks<3>&) const override {}
  void add_body_hessian(const System<3>& system, int b, HessianBlocks<3>& blocks,
                        OuterProducts<3>& products) const override;
};

}  // namespace supple
