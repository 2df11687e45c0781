/// The factorisation in blocks, of one size each.
#pragma once
#include "supple/solve/block_rows.hpp"
#include "supple/solve/factorisation.hpp"

namespace supple {

/// A Factorisation in blocks of Size x Size, for the Size coordinates of a site stand side by side. L has
/// unit blocks on its diagonal, D is block diagonal. The order of elimination (minimum degree) is kept while
/// the pattern of H changes little.
template <int Size>
class BlockFactorisation final : public Factorisation {
 public:
  void set(const SparseMatrix& lower) override;
  bool factorise(double shift) override;
  double negative_curvature() override;
  void solve(std::span<double> b) override;
  double largest_diagonal() const override { return largest_diagonal_; }
  double factorise_work() const override { return factorise_work_; }
  double solve_work() const override { return solve_work_; }

 private:
  using B = Block<Size>;
  void analyse();
  B eliminate_row(int k, B pivot);
  void solve_upper();
  /// The numbers of row k of blocks in work_.
  double* numbers(std::int32_t k) { return work_.data() + static_cast<std::size_t>(B::stride) * k; }

  int size_ = 0, blocks_ = 0;  ///< rows of H; rows of blocks, the last not full where Size is no divisor
  std::vector<std::int32_t> place_;  ///< of each row of blocks in the order of elimination
  BlockRows<Size> rows_;             ///< H in that order
  // L by columns, each block transposed: those of column k are [begin[k], begin[k + 1]), the first fill[k] of
  // them made.
  std::vector<std::int32_t> begin_, fill_, below_;
  std::vector<B> factor_, pivot_, inverse_pivot_;
  std::vector<std::int32_t> parent_;  ///< the elimination tree: the first row that each column has in L
  // Of the row that is eliminated: its blocks by column, which are not 0, and marks of the columns that were
  // seen.
  std::vector<B> partial_;
  std::vector<std::int32_t> reached_, branch_, seen_;
  std::vector<double> work_;  ///< a vector in the order of elimination, B::stride places for each block

  bool singular_ = false;
  double largest_diagonal_ = 0, factorise_work_ = 0, solve_work_ = 0, work_when_ordered_ = 0;
};

}  // namespace supple
