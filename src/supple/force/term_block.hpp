/// One kind of term on many stencils: gathers points, evaluates the term, adds forces and the virial.
#pragma once
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "supple/core/error.hpp"
#include "supple/core/parallel.hpp"
#include "supple/energy/term.hpp"
#include "supple/model/evaluation.hpp"
#include "supple/model/hessian.hpp"
#include "supple/model/outer_product.hpp"
#include "supple/model/system.hpp"

namespace supple {

/// One kind of term on all of its sites, as TermSet sees it.
template <int Dim>
class TermBlock {
 public:
  virtual ~TermBlock() = default;
  virtual std::string_view name() const = 0;
  virtual double energy(const System<Dim>& system) const = 0;
  /// Adds forces and, with Detail::energies, energy.terms and the virial.
  virtual void evaluate(const System<Dim>& system, Detail detail, Evaluation<Dim>& out) const = 0;
  /// Adds the second derivatives of the energy.
  virtual void add_hessian(const System<Dim>& system, HessianBlocks<Dim>& blocks) const = 0;
  /// The same without what HessianKind::sparse leaves out.
  virtual void add_sparse_hessian(const System<Dim>& system, HessianBlocks<Dim>& blocks) const {
    add_hessian(system, blocks);
  }
  /// All second derivatives in portions: those that may join bodies,
  virtual void add_joining_hessian(const System<Dim>& system, HessianBlocks<Dim>& blocks) const {
    add_hessian(system, blocks);
  }
  /// and those of body b by itself, where parts that couple all of its sites are outer products.
  virtual void add_body_hessian(const System<Dim>& /*system*/, int /*b*/, HessianBlocks<Dim>& /*blocks*/,
                                OuterProducts<Dim>& /*products*/) const {}
};

/// A term on stencils of Term::arity sites each, with one parameter set for all of them or one for each.
template <class Term, int Dim>
class StencilBlock final : public TermBlock<Dim> {
 public:
  using Stencil = std::array<std::int32_t, Term::arity>;
  using Param = typename Term::Param;

  StencilBlock(std::vector<Stencil> stencils, std::vector<Param> params)
      : stencils_(std::move(stencils)), params_(std::move(params)) {
    if (params_.size() != stencils_.size() && params_.size() != 1)
      throw input_error(
          fmt::format("{}: {} stencils with {} parameter sets", Term::name, stencils_.size(), params_.size()),
          "they do not match", "give one parameter set for all or one for each");
    index_slots();
  }

  std::string_view name() const override { return Term::name; }

  double energy(const System<Dim>& system) const override {
    const State<Dim>& state = system.state;
    check_sites(state);
    return sum_chunks<double>(size(), [&](std::int64_t begin, std::int64_t end) {
      double sum = 0;
      for (std::int64_t k = begin; k < end; ++k) {
        Points<Term, Dim> x;
        gather(state, k, x);
        sum += Term::energy(x, param(k));
      }
      return sum;
    });
  }

  void evaluate(const System<Dim>& system, Detail detail, Evaluation<Dim>& out) const override {
    const State<Dim>& state = system.state;
    check_sites(state);
    const bool serial = runs_in_place(size());
    // Threads must not add to the same site: each fills the slots of its stencils, and each site then adds
    // its slots in order.
    std::vector<Vec<Dim>> slots(serial ? 0 : stencils_.size() * Term::arity);
    const Sum total = sum_chunks<Sum>(size(), [&](std::int64_t begin, std::int64_t end) {
      Sum sum;
      for (std::int64_t k = begin; k < end; ++k) {
        Points<Term, Dim> x, slope;
        gather(state, k, x);
        sum.energy += term_gradient<Term, Dim>(x, param(k), slope);
        // Forces on a stencil sum to zero, so that any origin gives the same virial; a near one loses no
        // digits.
        if (detail == Detail::energies)
          for (int a = 1; a < Term::arity; ++a) sum.virial.add_outer(-1, slope[a], x[a] - x[0]);
        for (int a = 0; a < Term::arity; ++a) {
          if (serial) out.force[stencils_[k][a]] -= slope[a];
          else slots[k * Term::arity + a] = slope[a];
        }
      }
      return sum;
    });
    if (detail == Detail::energies) {
      out.energy.terms += total.energy;
      out.virial += total.virial;
    }
    if (!serial) add_slots(slots, out.force);
  }

  void add_hessian(const System<Dim>& system, HessianBlocks<Dim>& blocks) const override {
    check_sites(system.state);
    for (std::int64_t k = 0; k < size(); ++k) {
      Points<Term, Dim> x;
      gather(system.state, k, x);
      const TermHessian<Term, Dim> h = term_hessian<Term, Dim>(x, param(k));
      for (int a = 0; a < Term::arity; ++a)
        for (int b = 0; b <= a; ++b) {
          HessianBlock<Dim> block{stencils_[k][a], stencils_[k][b], {}};
          for (int c = 0; c < Dim; ++c)
            for (int d = 0; d < Dim; ++d) block.h[c][d] = h[a * Dim + c][b * Dim + d];
          blocks.push_back(block);
        }
    }
  }

 private:
  struct Sum {
    double energy = 0;
    Mat<Dim> virial;
    Sum& operator+=(const Sum& b) {
      energy += b.energy;
      virial += b.virial;
      return *this;
    }
  };

  std::int64_t size() const { return static_cast<std::int64_t>(stencils_.size()); }
  const Param& param(std::int64_t k) const { return params_[params_.size() == 1 ? 0 : k]; }

  void gather(const State<Dim>& state, std::int64_t k, Points<Term, Dim>& x) const {
    for (int a = 0; a < Term::arity; ++a) x[a] = state.position[stencils_[k][a]];
  }

  void check_sites(const State<Dim>& state) const {
    if (static_cast<std::size_t>(state.size()) + 1 < slot_begin_.size())
      throw input_error(fmt::format("{} acts on site {}", Term::name, slot_begin_.size() - 2),
                        fmt::format("there are {} sites", state.size()), "add a term after its sites");
  }

  /// Lists the slots (stencil * arity + place in the stencil) of each site, ascending.
  void index_slots() {
    std::int32_t last = -1;
    for (const Stencil& stencil : stencils_)
      for (const std::int32_t site : stencil) {
        if (site < 0)
          throw input_error(fmt::format("{} acts on site {}", Term::name, site), "sites count from 0");
        last = std::max(last, site);
      }
    slot_begin_.assign(static_cast<std::size_t>(last) + 2, 0);
    for (const Stencil& stencil : stencils_)
      for (const std::int32_t site : stencil) ++slot_begin_[site + 1];
    for (std::int32_t i = 0; i <= last; ++i) slot_begin_[i + 1] += slot_begin_[i];
    std::vector<std::int64_t> next(slot_begin_.begin(), slot_begin_.end());
    slot_.resize(stencils_.size() * Term::arity);
    for (std::int64_t k = 0; k < size(); ++k)
      for (int a = 0; a < Term::arity; ++a) slot_[next[stencils_[k][a]]++] = k * Term::arity + a;
  }

  void add_slots(const std::vector<Vec<Dim>>& slots, std::vector<Vec<Dim>>& force) const {
    for_chunks(static_cast<std::int64_t>(slot_begin_.size()) - 1,
               [&](std::int64_t, std::int64_t begin, std::int64_t end) {
                 for (std::int64_t i = begin; i < end; ++i)
                   for (std::int64_t s = slot_begin_[i]; s < slot_begin_[i + 1]; ++s)
                     force[i] -= slots[slot_[s]];
               });
  }

  std::vector<Stencil> stencils_;
  std::vector<Param> params_;
  std::vector<std::int64_t> slot_begin_, slot_;
};

}  // namespace supple
