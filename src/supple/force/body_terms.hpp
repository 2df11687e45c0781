/// The terms of whole bodies that a system holds as data.
#pragma once
#include "supple/force/term_block.hpp"

namespace supple {

/// Every term of System::terms, with the numbers that stand there at each evaluation. Throws an input error
/// on a name that no term has.
template <int Dim>
class BodyTermSet final : public TermBlock<Dim> {
 public:
  std::string_view name() const override { return "body_terms"; }
  double energy(const System<Dim>& system) const override;
  void evaluate(const System<Dim>& system, Detail detail, Evaluation<Dim>& out) const override;
  void add_hessian(const System<Dim>& system, HessianBlocks<Dim>& blocks) const override;
};

}  // namespace supple
