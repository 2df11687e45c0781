/// What a minimiser sees: a function of n numbers. Bodies, box and strain are the objective's business.
#pragma once
#include <limits>
#include <span>

#include "supple/solve/sparse_matrix.hpp"
#include "supple/solve/sums.hpp"

namespace supple {

/// A function of n numbers with a continuous gradient and, almost everywhere, second derivatives. The numbers
/// should be of one kind, such as lengths, because the minimisers give all of them unit mass.
class Objective {
 public:
  virtual ~Objective() = default;
  virtual int size() const = 0;
  /// How many numbers stand side by side for one site: 2 or 3. Matrices are factorised in blocks of so many,
  /// counted from the first number on; numbers of another kind, behind those of the sites, fall into blocks
  /// as they stand.
  virtual int block_size() const { return 2; }
  /// Energy at x; fills the gradient `slope`.
  virtual double evaluate(std::span<const double> x, std::span<double> slope) = 0;
  /// Fills the gradient alone, where that is cheaper; by evaluate() unless overridden.
  virtual void evaluate_slope(std::span<const double> x, std::span<double> slope) { evaluate(x, slope); }
  /// Second derivatives at x (lower triangle). The pattern may change from call to call, as
  /// contacts come and go; rows may be empty.
  virtual void hessian(std::span<const double> x, SparseMatrix& lower) = 0;
  /// A matrix near the Hessian, in the same form, that is faster to factorise; the Hessian itself unless
  /// overridden.
  virtual void preconditioner(std::span<const double> x, SparseMatrix& lower) { hessian(x, lower); }
  /// What must become small: the largest |component| of the gradient unless overridden, for example by the
  /// largest net force on a site.
  virtual double residual(std::span<const double>, std::span<const double> slope) { return largest(slope); }
  /// Residual at which to stop. It may depend on the state last evaluated, such as 1e-6 of the mean contact
  /// force.
  virtual double tolerance() const = 0;
  /// Largest change of one number in one step, such as a fraction of a site's diameter.
  virtual double largest_move() const { return std::numeric_limits<double>::infinity(); }
};

}  // namespace supple
