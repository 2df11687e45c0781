#include "supple/force/solid_terms.hpp"

#include "supple/core/parallel.hpp"
#include "supple/energy/bond_stretch.hpp"
#include "supple/energy/element_strain.hpp"

namespace supple {

namespace {

template <int Dim>
typename BondStretch<Dim>::Param bond_param(const Solid<Dim>& solid, int body, std::int32_t bond) {
  return {solid.stiffness[body].bond, solid.rest_bond[bond]};
}

template <int Dim>
typename ElementStrain<Dim>::Param element_param(const Solid<Dim>& solid, int body, std::int32_t element) {
  typename ElementStrain<Dim>::Param p{solid.stiffness[body].lambda, solid.stiffness[body].mu, {}};
  for (int a = 0; a < Dim; ++a)
    for (int c = 0; c < Dim; ++c) p.inverse[a * Dim + c] = solid.rest_element[element][a][c];
  return p;
}

/// visit(Term{}, sites, param) for each bond, then each element of body b that has a stiffness.
template <int Dim, class Visit>
void for_terms(const Solid<Dim>& solid, int b, const Visit& visit) {
  const SolidStiffness& k = solid.stiffness[b];
  if (k.bond != 0)
    for (std::int32_t n = solid.bond_begin[b]; n < solid.bond_begin[b + 1]; ++n)
      visit(BondStretch<Dim>{}, solid.bond[n], bond_param(solid, b, n));
  if (k.lambda != 0 || k.mu != 0)
    for (std::int32_t n = solid.element_begin[b]; n < solid.element_begin[b + 1]; ++n)
      visit(ElementStrain<Dim>{}, solid.element[n], element_param(solid, b, n));
}

template <class Term, int Dim>
void gather(const State<Dim>& state, const std::array<std::int32_t, Term::arity>& site,
            Points<Term, Dim>& x) {
  for (int a = 0; a < Term::arity; ++a) x[a] = state.position[site[a]];
}

template <int Dim>
struct SolidSum {
  double energy = 0;
  Mat<Dim> virial;
  SolidSum& operator+=(const SolidSum& b) {
    energy += b.energy;
    virial += b.virial;
    return *this;
  }
};

template <Detail detail, int Dim>
void add_body(const System<Dim>& system, int b, Vec<Dim>* force, SolidSum<Dim>& sum) {
  for_terms(system.solid, b, [&]<class Term>(Term, const auto& site, const auto& param) {
    Points<Term, Dim> x, slope;
    gather<Term>(system.state, site, x);
    const double energy = term_gradient<Term, Dim>(x, param, slope);
    for (int a = 0; a < Term::arity; ++a) force[site[a]] -= slope[a];
    if constexpr (detail == Detail::energies) {
      sum.energy += energy;
      for (int a = 0; a + 1 < Term::arity; ++a) sum.virial.add_outer(-1, slope[a], x[a] - x[Term::arity - 1]);
    }
  });
}

template <int Dim>
void add_hessian_of(const System<Dim>& system, int b, HessianBlocks<Dim>& blocks) {
  for_terms(system.solid, b, [&]<class Term>(Term, const auto& site, const auto& param) {
    Points<Term, Dim> x;
    gather<Term>(system.state, site, x);
    const TermHessian<Term, Dim> h = term_hessian<Term, Dim>(x, param);
    for (int i = 0; i < Term::arity; ++i)
      for (int j = 0; j <= i; ++j) {
        HessianBlock<Dim> block{site[i], site[j], {}};
        for (int c = 0; c < Dim; ++c)
          for (int d = 0; d < Dim; ++d) block.h[c][d] = h[i * Dim + c][j * Dim + d];
        blocks.push_back(block);
      }
  });
}

}  // namespace

template <int Dim>
double SolidTerms<Dim>::energy(const System<Dim>& system) const {
  double sum = 0;
  for (int b = 0; b < system.solid.bodies(); ++b)
    for_terms(system.solid, b, [&]<class Term>(Term, const auto& site, const auto& param) {
      Points<Term, Dim> x;
      gather<Term>(system.state, site, x);
      sum += Term::energy(x, param);
    });
  return sum;
}

template <int Dim>
void SolidTerms<Dim>::evaluate(const System<Dim>& system, Detail detail, Evaluation<Dim>& out) const {
  const auto total = sum_parts<SolidSum<Dim>>(system.solid.bodies(), [&](std::int64_t b) {
    SolidSum<Dim> sum;
    if (detail == Detail::energies)
      add_body<Detail::energies>(system, static_cast<int>(b), out.force.data(), sum);
    else add_body<Detail::forces>(system, static_cast<int>(b), out.force.data(), sum);
    return sum;
  });
  out.energy.terms += total.energy;
  out.virial += total.virial;
}

template <int Dim>
void SolidTerms<Dim>::add_hessian(const System<Dim>& system, HessianBlocks<Dim>& blocks) const {
  for (int b = 0; b < system.solid.bodies(); ++b) add_hessian_of(system, b, blocks);
}

template <int Dim>
void SolidTerms<Dim>::add_body_hessian(const System<Dim>& system, int b, HessianBlocks<Dim>& blocks,
                                       OuterProducts<Dim>&) const {
  if (b < system.solid.bodies()) add_hessian_of(system, b, blocks);
}

template class SolidTerms<2>;
template class SolidTerms<3>;

}  // namespace supple
