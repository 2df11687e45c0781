#include "supple/solve/factorisation.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>

#include "supple/solve/sums.hpp"

namespace supple {
namespace {

/// Four numbers that one instruction treats.
typedef double Four __attribute__((vector_size(32)));
typedef double Two __attribute__((vector_size(16)));

template <class Block>
Four load(const Block& block) {
  Four four;
  __builtin_memcpy(&four, block.e, sizeof four);
  return four;
}
template <class Block>
void store(Four four, Block& block) {
  __builtin_memcpy(block.e, &four, sizeof four);
}
Two load_two(const double* vector) {
  Two two;
  __builtin_memcpy(&two, vector, sizeof two);
  return two;
}
void store_two(Two two, double* vector) { __builtin_memcpy(vector, &two, sizeof two); }
Four twice(Two a) { return __builtin_shufflevector(a, a, 0, 1, 0, 1); }
Two first_row(Four a) { return __builtin_shufflevector(a, a, 0, 1); }
Two second_row(Four a) { return __builtin_shufflevector(a, a, 2, 3); }
Four first_row_twice(Four a) { return __builtin_shufflevector(a, a, 0, 1, 0, 1); }
Four second_row_twice(Four a) { return __builtin_shufflevector(a, a, 2, 3, 2, 3); }
Four first_column_twice(Four a) { return __builtin_shufflevector(a, a, 0, 0, 2, 2); }
Four second_column_twice(Four a) { return __builtin_shufflevector(a, a, 1, 1, 3, 3); }
Four transposed(Four a) { return __builtin_shufflevector(a, a, 0, 2, 1, 3); }
Four product(Four a, Four b) {
  return first_column_twice(a) * first_row_twice(b) + second_column_twice(a) * second_row_twice(b);
}

/// Least eigenvalue of the symmetric block {a, b, b, c}, and its unit vector.
struct LeastMode {
  double value;
  double x, y;
};
LeastMode least_mode(double a, double b, double c) {
  const double half = 0.5 * (a - c), root = std::hypot(half, b);
  const double value = 0.5 * (a + c) - root;
  // Of (A - value I) v = 0 the row whose element on the diagonal is the larger one.
  double x = -b, y = half + root;
  if (half < 0) x = root - half, y = -b;
  const double length = std::hypot(x, y);
  return length > 0 ? LeastMode{value, x / length, y / length} : LeastMode{value, 1, 0};
}

}  // namespace

/// The lower triangle of H by columns of blocks, blocks on the diagonal whole.
struct Factorisation::LowerBlocks {
  explicit LowerBlocks(const SparseMatrix& lower) : size((lower.size + 1) / 2), begin{0} {
    std::vector<std::int32_t> place(static_cast<std::size_t>(size), -1);
    for (int column = 0; column < size; ++column) {
      for (int half = 0; half < 2 && 2 * column + half < lower.size; ++half)
        for (int k = lower.begin[2 * column + half]; k < lower.begin[2 * column + half + 1]; ++k) {
          const int r = lower.row[k] / 2, within = lower.row[k] % 2;
          if (place[r] < begin.back()) {
            place[r] = static_cast<std::int32_t>(row.size());
            row.push_back(r);
            block.push_back({});
          }
          Block& b = block[static_cast<std::size_t>(place[r])];
          b.e[2 * within + half] = lower.value[k];
          if (r == column) b.e[2 * half + within] = lower.value[k];
        }
      begin.push_back(static_cast<std::int32_t>(row.size()));
    }
  }

  int size;
  std::vector<std::int32_t> begin, row;
  std::vector<Block> block;
};

void Factorisation::set(const SparseMatrix& lower) {
  const LowerBlocks blocks(lower);
  // An order made for other contacts stays good for a while, and costs as much as a factorisation to make.
  if (size_ != lower.size || factorise_work_ > 1.3 * work_when_ordered_) {
    find_order(blocks);
    work_when_ordered_ = 0;
  }
  size_ = lower.size;
  blocks_ = blocks.size;
  sort_rows(blocks);
  analyse();
  largest_diagonal_ = 0;
  for (const Block& d : diagonal_)
    largest_diagonal_ = std::max({largest_diagonal_, std::abs(d.e[0]), std::abs(d.e[3])});
}

void Factorisation::find_order(const LowerBlocks& blocks) {
  const std::vector<double> ones(blocks.row.size(), 1.0);
  const Eigen::Map<const Eigen::SparseMatrix<double>> lower(
      blocks.size, blocks.size, static_cast<Eigen::Index>(ones.size()), blocks.begin.data(),
      blocks.row.data(), ones.data());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> eliminated;
  Eigen::AMDOrdering<int>()(lower.selfadjointView<Eigen::Lower>(), eliminated);
  place_.resize(static_cast<std::size_t>(blocks.size));
  for (int k = 0; k < blocks.size; ++k) place_[eliminated.indices()[k]] = k;
}

void Factorisation::sort_rows(const LowerBlocks& blocks) {
  diagonal_.assign(static_cast<std::size_t>(blocks_), {});
  row_begin_.assign(static_cast<std::size_t>(blocks_) + 1, 0);
  const auto later = [&](int a, int b) { return std::max(place_[a], place_[b]); };
  for (int c = 0; c < blocks_; ++c)
    for (std::int32_t k = blocks.begin[c]; k < blocks.begin[c + 1]; ++k)
      if (blocks.row[k] != c) ++row_begin_[later(blocks.row[k], c) + 1];
  for (int k = 0; k < blocks_; ++k) row_begin_[k + 1] += row_begin_[k];
  row_column_.resize(static_cast<std::size_t>(row_begin_.back()));
  row_block_.resize(row_column_.size());
  std::vector<std::int32_t> next(row_begin_.begin(), row_begin_.end() - 1);
  for (int c = 0; c < blocks_; ++c)
    for (std::int32_t k = blocks.begin[c]; k < blocks.begin[c + 1]; ++k) {
      const std::int32_t r = blocks.row[k], row = place_[r], column = place_[c];
      if (r == c) {
        diagonal_[row] = blocks.block[k];
        continue;
      }
      const std::int32_t at = next[std::max(row, column)]++;
      row_column_[at] = std::min(row, column);
      const Four block = load(blocks.block[k]);
      store(row > column ? block : transposed(block), row_block_[at]);
    }
}

/// The elimination tree and the number of blocks in each column of L (Liu 1990).
void Factorisation::analyse() {
  const auto n = static_cast<std::size_t>(blocks_);
  parent_.assign(n, -1);
  seen_.assign(n, -1);
  begin_.assign(n + 1, 0);
  for (int k = 0; k < blocks_; ++k) {
    seen_[k] = k;
    for (std::int32_t p = row_begin_[k]; p < row_begin_[k + 1]; ++p)
      for (std::int32_t i = row_column_[p]; seen_[i] != k; i = parent_[i]) {
        if (parent_[i] < 0) parent_[i] = k;
        ++begin_[i + 1];
        seen_[i] = k;
      }
  }
  factorise_work_ = solve_work_ = 0;
  for (int k = 0; k < blocks_; ++k) {
    const double below = begin_[k + 1];
    factorise_work_ += 4 * below * (below + 3);
    solve_work_ += 8 * below;
    begin_[k + 1] += begin_[k];
  }
  if (work_when_ordered_ == 0) work_when_ordered_ = factorise_work_;
  below_.resize(static_cast<std::size_t>(begin_.back()));
  factor_.resize(below_.size());
  partial_.assign(n, {});
  reached_.resize(n);
  branch_.resize(n);
  work_.resize(2 * n);
}

bool Factorisation::factorise(double shift) {
  const auto n = static_cast<std::size_t>(blocks_);
  pivot_.resize(n);
  inverse_pivot_.resize(n);
  fill_.assign(n, 0);
  seen_.assign(n, -1);
  bool positive = true;
  singular_ = false;
  const std::int32_t odd = size_ % 2 ? place_[n - 1] : -1;  // its second row is none of H
  for (int k = 0; k < blocks_; ++k) {
    Block d = diagonal_[k];
    d.e[0] += shift;
    d.e[3] += shift;
    if (k == odd) d.e[3] = 1;
    d = eliminate_row(k, d);
    const double a = d.e[0], b = d.e[1], c = d.e[3], determinant = a * c - b * b;
    pivot_[k] = d;
    inverse_pivot_[k] = {{c / determinant, -b / determinant, -b / determinant, a / determinant}};
    if (!(a > 0 && c - b * (b / a) > 0)) positive = false;
    if (!(std::abs(determinant) > 0)) {
      singular_ = true;
      return false;
    }
  }
  return positive;
}

/// Row k of L from those above it; what is left of its pivot.
Factorisation::Block Factorisation::eliminate_row(int k, Block pivot) {
  // The columns that row k has in L are the branches of the elimination tree from those that it has in H.
  int first = blocks_;
  seen_[k] = k;
  for (std::int32_t p = row_begin_[k]; p < row_begin_[k + 1]; ++p) {
    std::int32_t i = row_column_[p];
    partial_[i] = row_block_[p];
    int length = 0;
    for (; seen_[i] != k; i = parent_[i]) {
      branch_[length++] = i;
      seen_[i] = k;
    }
    while (length > 0) reached_[--first] = branch_[--length];
  }
  Block* const factor = factor_.data();
  std::int32_t* const below = below_.data();
  Block* const partial = partial_.data();
  Four d = load(pivot);
  for (int s = first; s < blocks_; ++s) {
    const std::int32_t i = reached_[s];
    const Four y = load(partial_[i]);
    partial_[i] = {};
    const Four left = first_column_twice(y), right = second_column_twice(y);
    const std::int32_t begin = begin_[i], end = begin + fill_[i]++;
    for (std::int32_t p = begin; p < end; ++p) {
      const Four l = load(factor[p]);
      Block& to = partial[below[p]];
      store(load(to) - left * first_row_twice(l) - right * second_row_twice(l), to);
    }
    const Four l = transposed(product(y, load(inverse_pivot_[i])));
    d -= left * first_row_twice(l) + right * second_row_twice(l);
    below[end] = k;
    store(l, factor[end]);
  }
  store(d, pivot);
  pivot.e[1] = pivot.e[2] = 0.5 * (pivot.e[1] + pivot.e[2]);
  return pivot;
}

/// Replaces work by L^-T work.
void Factorisation::solve_upper() {
  const Block* const factor = factor_.data();
  const std::int32_t* const below = below_.data();
  const double* const x = work_.data();
  for (int k = blocks_; k-- > 0;) {
    // Two sums, as each addition waits for the one before it.
    Four sum = {0, 0, 0, 0}, other = sum;
    const auto part = [&](std::int32_t p) { return load(factor[p]) * twice(load_two(x + 2 * below[p])); };
    std::int32_t p = begin_[k];
    for (; p + 1 < begin_[k + 1]; p += 2) {
      sum += part(p);
      other += part(p + 1);
    }
    if (p < begin_[k + 1]) sum += part(p);
    sum += other;
    work_[2 * k] -= sum[0] + sum[1];
    work_[2 * k + 1] -= sum[2] + sum[3];
  }
}

double Factorisation::negative_curvature() {
  if (singular_) return 0;
  int at = 0;
  LeastMode least{0, 1, 0};
  for (int k = 0; k < blocks_; ++k) {
    const LeastMode mode = least_mode(pivot_[k].e[0], pivot_[k].e[1], pivot_[k].e[3]);
    if (k == 0 || mode.value < least.value) least = mode, at = k;
  }
  std::fill(work_.begin(), work_.end(), 0.0);
  work_[2 * at] = least.x;
  work_[2 * at + 1] = least.y;
  solve_upper();  // z with L^T z = v, so that z.Az = v.Dv
  return least.value / dot(work_, work_);
}

void Factorisation::solve(std::span<double> b) {
  const auto each = [&](auto&& visit) {
    for (int k = 0; k < size_; ++k) visit(b[k], work_[2 * place_[k / 2] + k % 2]);
  };
  if (size_ % 2) work_[2 * place_[blocks_ - 1] + 1] = 0;
  each([](double from, double& to) { to = from; });
  const Block* const factor = factor_.data();
  const std::int32_t* const below = below_.data();
  double* const work = work_.data();
  for (int k = 0; k < blocks_; ++k) {
    const double x = work_[2 * k], y = work_[2 * k + 1];
    for (std::int32_t p = begin_[k]; p < begin_[k + 1]; ++p) {
      double* const to = work + 2 * below[p];
      const Four l = load(factor[p]);
      store_two(load_two(to) - x * first_row(l) - y * second_row(l), to);
    }
  }
  for (int k = 0; k < blocks_; ++k) {
    const double x = work_[2 * k], y = work_[2 * k + 1];
    const double* d = inverse_pivot_[k].e;
    work_[2 * k] = d[0] * x + d[1] * y;
    work_[2 * k + 1] = d[2] * x + d[3] * y;
  }
  solve_upper();
  each([](double& to, double from) { to = from; });
}

}  // namespace supple
