/// Sparse factorisation of a symmetric matrix plus a multiple of the identity.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "supple/solve/sparse_matrix.hpp"

namespace supple {

/// H + shift I = L D L^T for a sparse symmetric H, in blocks of 2 x 2: x and y of a site stand side by side.
/// L has unit blocks on its diagonal, D is block diagonal. The order of elimination (minimum degree) is kept
/// while the pattern of H changes little.
class Factorisation {
 public:
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
  /// A matrix of 2 x 2, row after row.
  struct Block {
    double e[4];
  };
  struct LowerBlocks;
  void find_order(const LowerBlocks& blocks);
  void sort_rows(const LowerBlocks& blocks);
  void analyse();
  Block eliminate_row(int k, Block pivot);
  void solve_upper();

  int size_ = 0, blocks_ = 0;        ///< rows of H; rows of blocks, the last half empty where the size is odd
  std::vector<std::int32_t> place_;  ///< of each row of blocks in the order of elimination
  // H in that order: the blocks of row k left of its diagonal are [row_begin[k], row_begin[k + 1]).
  std::vector<std::int32_t> row_begin_, row_column_;
  std::vector<Block> row_block_, diagonal_;
  // L by columns, each block transposed: those of column k are [begin[k], begin[k + 1]), the first fill[k] of
  // them made.
  std::vector<std::int32_t> begin_, fill_, below_;
  std::vector<Block> factor_, pivot_, inverse_pivot_;
  std::vector<std::int32_t> parent_;  ///< the elimination tree: the first row that each column has in L
  // Of the row that is eliminated: its blocks by column, which are not 0, and marks of the columns that were
  // seen.
  std::vector<Block> partial_;
  std::vector<std::int32_t> reached_, branch_, seen_;
  std::vector<double> work_;  ///< a vector in the order of elimination

  bool singular_ = false;
  double largest_diagonal_ = 0, factorise_work_ = 0, solve_work_ = 0, work_when_ordered_ = 0;
};

}  // namespace supple
