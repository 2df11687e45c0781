/// Sparse factorisation of a symmetric matrix plus a multiple of the identity.
#pragma once
#include <Eigen/SparseCholesky>
#include <span>

#include "supple/solve/objective.hpp"

namespace supple {

/// H + shift I = L D L^T. The order of elimination (minimum degree) is kept while the pattern changes little.
class Factorisation {
 public:
  /// Takes the matrix (lower triangle) and looks at its pattern.
  void set(const SparseMatrix& lower);
  /// True if positive definite. Rows may be empty when shift > 0.
  bool factorise(double shift);
  /// After factorise() returned false: a curvature z.(H + shift I)z / z.z that is not positive; no eigenvalue
  /// of H + shift I below it need exist, but one at most as large does.
  double negative_curvature();
  /// b becomes (H + shift I)^-1 b.
  void solve(std::span<double> b);

  double largest_diagonal() const { return largest_diagonal_; }
  /// Multiplications of one factorisation and of one solution.
  double factorise_work() const { return factorise_work_; }
  double solve_work() const { return solve_work_; }

 private:
  void order(const SparseMatrix& lower);
  void count_work();

  Eigen::SimplicialLDLT<SparseMatrix, Eigen::Upper, Eigen::NaturalOrdering<int>> solver_;
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order_;
  SparseMatrix upper_;  ///< in the order of elimination
  Eigen::VectorXd work_, pivot_;
  double largest_diagonal_ = 0, factorise_work_ = 0, solve_work_ = 0;
  double work_when_ordered_ = 0;
};

}  // namespace supple
