/// The energy of the inside of bodies: of bonds and elements.
#pragma once
#include "supple/force/term_block.hpp"

namespace supple {

/// Bonds and elements of System::solid, with the stiffnesses and rest values that stand there at each
/// evaluation. Bodies are shared among threads, so that a single one is evaluated by one.
template <int Dim>
class SolidTerms final : public TermBlock<Dim> {
 public:
  std::string_view name() const override { return "solid"; }
  double energy(const System<Dim>& system) const override;
  void evaluate(const System<Dim>& system, Detail detail, Evaluation<Dim>& out) const override;
  void add_hessian(const System<Dim>& system, HessianBlocks<Dim>& blocks) const override;
  void add_joining_hessian(const System<Dim>&, HessianBlocks<Dim>&) const override {}
  void add_body_hessian(const System<Dim>& system, int b, HessianBlocks<Dim>& blocks,
                        OuterProducts<Dim>& products) const override;
};

}  // namespace supple
