/// Sparse factorisation of a symmetric matrix plus a multiple of the identity.
#pragma once
#include <memory>
#include <span>

#include "supple/solve/sparse_matrix.hpp"

namespace supple {

/// H + shift I = L D L^T for a sparse symmetric H. The order of elimination (minimum degree) is kept while
/// the pattern of H changes little.
class Factorisation {
 public:
  Factorisation();
  ~Factorisation();

  /// Takes H (lower triangle) and analyses its pattern.
  void set(const SparseMatrix& lower);
  /// Factorises H + shift I. True if it is positive definite. Rows of H may be empty when shift > 0.
  bool factorise(double shift);
  /// After factorise() returned false: a curvature z.(H + shift I)z / z.z that is not positive. The least
  /// eigenvalue of H + shift I is at most as large.
  double negative_curvature();
  /// Replaces b by (H + shift I)^-1 b.
  void solve(std::span<double> b);

  double largest_diagonal() const { return largest_diagonal_; }
  /// Numbers of multiplications in one factorisation and in one solve().
  double factorise_work() const { return factorise_work_; }
  double solve_work() const { return solve_work_; }

 private:
  struct Solver;
  void count_work();

  std::unique_ptr<Solver> solver_;  ///< what Eigen makes of it
  double largest_diagonal_ = 0, factorise_work_ = 0, solve_work_ = 0;
  double work_when_ordered_ = 0;
};

}  // namespace supple
