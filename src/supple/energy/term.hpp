/// What a conservative term is, and how it is differentiated.
#pragma once
#include <array>
#include <concepts>

#include "supple/core/jet.hpp"
#include "supple/core/vec.hpp"

namespace supple {

/// What a term is a function of: the unwrapped positions of the `arity` sites of one stencil.
template <class Term, int Dim, class S = double>
using Points = VecOf<S, Dim>[Term::arity];

/// A pure function energy(x, p) of a few points x and parameters p, written once for any scalar type, so that
/// it can be differentiated. It knows no box, neighbour or file. A rigid motion of the points must not change
/// it.
template <class Term, int Dim>
concept ConservativeTerm = requires(const Points<Term, Dim>& x, const typename Term::Param& p) {
  { Term::energy(x, p) } -> std::convertible_to<double>;
};

/// A term that also has a hand-written gradient(x, p, g), which fills g and returns the energy: worth writing
/// for terms that take a large share of the time.
template <class Term, int Dim>
concept HasGradient = requires(const Points<Term, Dim>& x, const typename Term::Param& p,
                               Points<Term, Dim>& g) {
  { Term::gradient(x, p, g) } -> std::convertible_to<double>;
};

/// A term of a whole body: a pure function energy(v, p) of a sum over the facets of its boundary, of
/// measure(facet): the area or volume that they enclose, their length or area.
template <class Term>
concept BodyTerm = requires(double sum, const typename Term::Param& p) {
  { Term::energy(sum, p) } -> std::convertible_to<double>;
};

/// Returns the energy, and fills g with its gradient with respect to every point, by automatic
/// differentiation (Jet).
template <class Term, int Dim>
double jet_gradient(const Points<Term, Dim>& x, const typename Term::Param& p, Points<Term, Dim>& g) {
  constexpr int n = Term::arity * Dim;
  Points<Term, Dim, Jet<double, n>> point;
  for (int a = 0; a < Term::arity; ++a)
    for (int d = 0; d < Dim; ++d) {
      point[a][d] = x[a][d];
      point[a][d].slope[a * Dim + d] = 1;
    }
  const Jet<double, n> energy = Term::energy(point, p);
  for (int a = 0; a < Term::arity; ++a)
    for (int d = 0; d < Dim; ++d) g[a][d] = energy.slope[a * Dim + d];
  return energy.value;
}

/// Returns the energy and fills its gradient g, by the term's own gradient() where it has one.
template <class Term, int Dim>
double term_gradient(const Points<Term, Dim>& x, const typename Term::Param& p, Points<Term, Dim>& g) {
  if constexpr (HasGradient<Term, Dim>) return Term::gradient(x, p, g);
  else return jet_gradient<Term, Dim>(x, p, g);
}

/// Second derivatives, [a * Dim + c][b * Dim + d] = d2E / dx[a][c] dx[b][d].
template <class Term, int Dim>
using TermHessian = std::array<std::array<double, Term::arity * Dim>, Term::arity * Dim>;

/// The second derivatives at x, by automatic differentiation (Jet).
template <class Term, int Dim>
TermHessian<Term, Dim> term_hessian(const Points<Term, Dim>& x, const typename Term::Param& p) {
  constexpr int n = Term::arity * Dim;
  using First = Jet<double, n>;
  Points<Term, Dim, Jet<First, n>> point;
  for (int a = 0; a < Term::arity; ++a)
    for (int d = 0; d < Dim; ++d) {
      const int k = a * Dim + d;
      point[a][d] = x[a][d];
      point[a][d].value.slope[k] = 1;
      point[a][d].slope[k] = 1.0;
    }
  const Jet<First, n> energy = Term::energy(point, p);
  TermHessian<Term, Dim> hessian;
  for (int k = 0; k < n; ++k) hessian[k] = energy.slope[k].slope;
  return hessian;
}

}  // namespace supple
