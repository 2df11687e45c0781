/// The whole shape energy of polygons in one pass over each ring: the fast path of 2D.
#pragma once
#include "supple/force/term_block.hpp"

namespace supple {

/// Energies of enclosed area, edge lengths, corner angles and line tension [MacKeith 2025, eq. 9.1] with the
/// numbers of System::shape, which are read at each evaluation, as preferred shapes may flow. The terms of
/// energy/ (shape_terms.hpp) give the same to rounding and are the reference.
class PolygonShape final : public TermBlock<2> {
 public:
  std::string_view name() const override { return "polygon_shape"; }
  double energy(const System<2>& system) const override;
  void evaluate(const System<2>& system, Detail detail, Evaluation<2>& out) const override;
  void add_hessian(const System<2>& system, HessianBlocks<2>& blocks) const override;
  void add_sparse_hessian(const System<2>& system, HessianBlocks<2>& blocks) const override;
  void add_joining_hessian(const System<2>&, HessianBlocks<2>&) const override {}
  void add_body_hessian(const System<2>& system, int b, HessianBlocks<2>& blocks,
                        OuterProducts<2>& products) const override;
};

}  // namespace supple
