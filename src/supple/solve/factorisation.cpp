#include "supple/solve/block_factorisation.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "supple/core/error.hpp"
#include "supple/solve/pivot.hpp"
#include "supple/solve/sums.hpp"

namespace supple {

std::unique_ptr<Factorisation> make_factorisation(int block_size) {
  if (block_size == 2) return std::make_unique<BlockFactorisation<2>>();
  if (block_size == 3) return std::make_unique<BlockFactorisation<3>>();
  throw input_error(fmt::format("a factorisation in blocks of {}", block_size),
                    "blocks hold the coordinates of a site", "take 2 or 3");
}

template <int Size>
void BlockFactorisation<Size>::set(const SparseMatrix& lower) {
  const BlockColumns<Size> columns(lower);
  // An order made for other contacts stays good for a while, and costs as much as a factorisation to make.
  if (size_ != lower.size || factorise_work_ > 1.3 * work_when_ordered_) {
    place_ = elimination_places(columns);
    work_when_ordered_ = 0;
  }
  size_ = lower.size;
  blocks_ = columns.size;
  rows_.sort(columns, place_);
  analyse();
  largest_diagonal_ = 0;
  for (const B& d : rows_.diagonal)
    for (int r = 0; r < Size; ++r) largest_diagonal_ = std::max(largest_diagonal_, std::abs(d.at(r, r)));
}

/// The elimination tree and the number of blocks in each column of L (Liu 1990).
template <int Size>
void BlockFactorisation<Size>::analyse() {
  const auto n = static_cast<std::size_t>(blocks_);
  parent_.assign(n, -1);
  seen_.assign(n, -1);
  begin_.assign(n + 1, 0);
  for (int k = 0; k < blocks_; ++k) {
    seen_[k] = k;
    for (std::int32_t p = rows_.begin[k]; p < rows_.begin[k + 1]; ++p)
      for (std::int32_t i = rows_.column[p]; seen_[i] != k; i = parent_[i]) {
        if (parent_[i] < 0) parent_[i] = k;
        ++begin_[i + 1];
        seen_[i] = k;
      }
  }
  factorise_work_ = solve_work_ = 0;
  for (int k = 0; k < blocks_; ++k) {
    // A column of m blocks takes m products for L, m for the next pivots and m (m - 1)/2 for its rows.
    const double below = begin_[k + 1];
    factorise_work_ += 0.5 * Size * Size * Size * below * (below + 3);
    solve_work_ += 2 * Size * Size * below;
    begin_[k + 1] += begin_[k];
  }
  if (work_when_ordered_ == 0) work_when_ordered_ = factorise_work_;
  below_.resize(static_cast<std::size_t>(begin_.back()));
  factor_.resize(below_.size());
  partial_.assign(n, {});
  reached_.resize(n);
  branch_.resize(n);
  work_.assign(B::stride * n, 0.0);
}

template <int Size>
bool BlockFactorisation<Size>::factorise(double shift) {
  const auto n = static_cast<std::size_t>(blocks_);
  pivot_.resize(n);
  inverse_pivot_.resize(n);
  fill_.assign(n, 0);
  seen_.assign(n, -1);
  bool positive = true;
  singular_ = false;
  const int filled = size_ % Size;  // rows of H in the last block, where it is not full
  const std::int32_t partly = filled ? place_[n - 1] : -1;
  for (int k = 0; k < blocks_; ++k) {
    B d = rows_.diagonal[k];
    for (int r = 0; r < Size; ++r) d.at(r, r) = k == partly && r >= filled ? 1 : d.at(r, r) + shift;
    d = pivot_[k] = eliminate_row(k, d);
    const PivotSign sign = invert(d, inverse_pivot_[k]);
    if (sign == PivotSign::singular) {
      singular_ = true;
      return false;
    }
    if (sign == PivotSign::indefinite) positive = false;
  }
  return positive;
}

/// Row k of L from those above it; what is left of its pivot.
template <int Size>
Block<Size> BlockFactorisation<Size>::eliminate_row(int k, B pivot) {
  using P = Packed<Size>;
  // The columns that row k has in L are the branches of the elimination tree from those that it has in H.
  int first = blocks_;
  seen_[k] = k;
  for (std::int32_t p = rows_.begin[k]; p < rows_.begin[k + 1]; ++p) {
    std::int32_t i = rows_.column[p];
    partial_[i] = rows_.block[p];
    int length = 0;
    for (; seen_[i] != k; i = parent_[i]) {
      branch_[length++] = i;
      seen_[i] = k;
    }
    while (length > 0) reached_[--first] = branch_[--length];
  }
  B* const factor = factor_.data();
  std::int32_t* const below = below_.data();
  B* const partial = partial_.data();
  P d(pivot);
  for (int s = first; s < blocks_; ++s) {
    const std::int32_t i = reached_[s];
    const LeftFactor<Size> y{P(partial[i])};
    partial[i] = {};
    const std::int32_t begin = begin_[i], end = begin + fill_[i]++;
    for (std::int32_t p = begin; p < end; ++p) {
      B& to = partial[below[p]];
      y.subtract_product(P(factor[p]), P(to)).store(to);
    }
    const P l = y.times(P(inverse_pivot_[i])).transposed();
    d -= y.times(l);
    below[end] = k;
    l.store(factor[end]);
  }
  d.store(pivot);
  for (int r = 0; r < Size; ++r)
    for (int c = 0; c < r; ++c) pivot.at(r, c) = pivot.at(c, r) = 0.5 * (pivot.at(c, r) + pivot.at(r, c));
  return pivot;
}

/// Replaces work by L^-T work.
template <int Size>
void BlockFactorisation<Size>::solve_upper() {
  const B* const factor = factor_.data();
  const std::int32_t* const below = below_.data();
  for (int k = blocks_; k-- > 0;) {
    // Two sums, as each addition waits for the one before it.
    Packed<Size> sum, other;
    const auto part = [&](std::int32_t p) {
      return Packed<Size>(factor[p]).each_row_times(load_vector<Size>(numbers(below[p])));
    };
    std::int32_t p = begin_[k];
    for (; p + 1 < begin_[k + 1]; p += 2) {
      sum += part(p);
      other += part(p + 1);
    }
    if (p < begin_[k + 1]) sum += part(p);
    sum += other;
    sum.subtract_row_sums(numbers(k));
  }
}

template <int Size>
double BlockFactorisation<Size>::negative_curvature() {
  if (singular_) return 0;
  int at = 0;
  LeastMode<Size> least{0, {1}};
  for (int k = 0; k < blocks_; ++k) {
    const LeastMode<Size> mode = least_mode(pivot_[k]);
    if (k == 0 || mode.value < least.value) least = mode, at = k;
  }
  std::fill(work_.begin(), work_.end(), 0.0);
  std::copy(least.x, least.x + Size, numbers(at));
  solve_upper();  // z with L^T z = v, so that z.Az = v.Dv
  return least.value / dot(work_, work_);
}

template <int Size>
void BlockFactorisation<Size>::solve(std::span<double> b) {
  const auto each = [&](auto&& visit) {
    for (int k = 0; k < size_; ++k) visit(b[k], numbers(place_[k / Size])[k % Size]);
  };
  for (int r = size_ % Size; r > 0 && r < Size; ++r) numbers(place_[blocks_ - 1])[r] = 0;
  each([](double from, double& to) { to = from; });
  const B* const factor = factor_.data();
  const std::int32_t* const below = below_.data();
  for (int k = 0; k < blocks_; ++k) {
    double x[Size];
    std::copy(numbers(k), numbers(k) + Size, x);
    for (std::int32_t p = begin_[k]; p < begin_[k + 1]; ++p) {
      double* const to = numbers(below[p]);
      store_vector(Packed<Size>(factor[p]).minus_rows(load_vector<Size>(to), x), to);
    }
  }
  for (int k = 0; k < blocks_; ++k) {
    double x[Size];
    std::copy(numbers(k), numbers(k) + Size, x);
    for (int r = 0; r < Size; ++r) {
      double sum = inverse_pivot_[k].at(r, 0) * x[0];
      for (int c = 1; c < Size; ++c) sum += inverse_pivot_[k].at(r, c) * x[c];
      numbers(k)[r] = sum;
    }
  }
  solve_upper();
  each([](double& to, double from) { to = from; });
}

template class BlockFactorisation<2>;
template class BlockFactorisation<3>;

}  // namespace supple
