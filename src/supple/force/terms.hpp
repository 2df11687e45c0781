/// Everything conservative that acts inside bodies.
#pragma once
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "supple/force/term_block.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// The terms of a system. They take positions as they are, so bodies must be unwrapped.
template <int Dim>
class TermSet {
 public:
  /// Adds a term on these stencils (Term::arity sites each), with one parameter set for all of them or one
  /// for each. Input error where the numbers of stencils and sets do not match or a site is negative.
  template <ConservativeTerm<Dim> Term>
  void add(Term, std::vector<std::array<std::int32_t, Term::arity>> stencils,
           std::vector<typename Term::Param> params) {
    blocks_.push_back(std::make_shared<StencilBlock<Term, Dim>>(std::move(stencils), std::move(params)));
  }

  /// Adds anything else that acts inside bodies.
  void add(std::shared_ptr<const TermBlock<Dim>> block) { blocks_.push_back(std::move(block)); }

  bool empty() const { return blocks_.empty(); }

  /// Adds forces; with Detail::energies also energy.terms and the virial. The bits are the same for any
  /// number of threads.
  void evaluate(const System<Dim>& system, Detail detail, Evaluation<Dim>& out) const {
    for (const auto& block : blocks_) block->evaluate(system, detail, out);
  }

  void add_hessian(const System<Dim>& system, HessianBlocks<Dim>& blocks,
                   HessianKind kind = HessianKind::exact) const {
    for (const auto& block : blocks_) {
      if (kind == HessianKind::sparse) block->add_sparse_hessian(system, blocks);
      else block->add_hessian(system, blocks);
    }
  }

  /// The same in portions: the terms that may join bodies,
  void add_joining_hessian(const System<Dim>& system, HessianBlocks<Dim>& blocks) const {
    for (const auto& block : blocks_) block->add_joining_hessian(system, blocks);
  }
  /// and those of body b by itself, with the parts that couple all of its sites as outer products.
  void add_body_hessian(const System<Dim>& system, int b, HessianBlocks<Dim>& blocks,
                        OuterProducts<Dim>& products) const {
    for (const auto& block : blocks_) block->add_body_hessian(system, b, blocks, products);
  }

  /// Name and energy of each term, in the order in which they were added.
  std::vector<std::pair<std::string, double>> energies(const System<Dim>& system) const {
    std::vector<std::pair<std::string, double>> parts;
    for (const auto& block : blocks_) parts.emplace_back(block->name(), block->energy(system));
    return parts;
  }

 private:
  std::vector<std::shared_ptr<const TermBlock<Dim>>> blocks_;  // immutable: copies of a set may share them
};

}  // namespace supple
