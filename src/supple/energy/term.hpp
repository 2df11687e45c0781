/// What a conservative term is, and its derivatives.
#pragma once
#include <array>
#include <concepts>

#include "supple/core/jet.hpp"
#include "supple/core/vec.hpp"

namespace supple {

/// The points that a term sees: unwrapped positions of the `arity` sites of one stencil.
template <class Term, int Dim, class S = double>
using Points = VecOf<S, Dim>[Term::arity];

/// A pure function of a few points and its parameters: energy(x, p), written once for any scalar. It knows no
/// box, no neighbour, no file. Its energy may not change when the points move rigidly.
template <class Term, int Dim>
concept ConservativeTerm = requires(const Points<Term, Dim>& x, const typename Term::Param& p) {
  { Term::energy(x, p) } -> std::convertible_to<double>;
};

/// A term that also has a hand-written gradient(x, p, g), which returns the energy: for terms that a profile
/// shows.
template <class Term, int Dim>
concept HasGradient = requires(const Points<Term, Dim>& x, const typename Term::Param& p,
                               Points<Term, Dim>& g) {
  { Term::gradient(x, p, g) } -> std::convertible_to<double>;
};

/// A term of a whole body: a pure function energy(v, p) of the area or volume that its boundary encloses.
template <class Term>
concept BodyTerm = requires(double volume, const typename Term::Param& p) {
  { Term::energy(volume, p) } -> std::convertible_to<double>;
};

/// Energy, and its gradient g by every point, by differentiation of the energy.
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

/// Energy and gradient, by the term's own gradient where it has one.
template <class Term, int Dim>
double term_gradient(const Points<Term, Dim>& x, const typename Term::Param& p, Points<Term, Dim>& g) {
  if constexpr (HasGradient<Term, Dim>) return Term::gradient(x, p, g);
  else return jet_gradient<Term, Dim>(x, p, g);
}

/// Second derivatives, [a * Dim + c][b * Dim + d] = d2E / dx[a][c] dx[b][d].
template <class Term, int Dim>
using TermHessian = std::array<std::array<double, Term::arity * Dim>, Term::arity * Dim>;

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
