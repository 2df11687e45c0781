#include "supple/solve/eigenvalue_bound.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "supple/core/parallel.hpp"

namespace supple {

namespace {

constexpr int iterations = 30;

struct Element {
  std::int32_t column;
  double value;
};

/// The lower triangle row by row: columns ascend, and entries of one place are summed in their order.
class Rows {
 public:
  Rows(const std::vector<MatrixEntry>& lower, int size) : begin_(static_cast<std::size_t>(size) + 1, 0) {
    for (const MatrixEntry& e : lower) ++begin_[e.row() + 1];
    for (std::size_t k = 1; k < begin_.size(); ++k) begin_[k] += begin_[k - 1];
    elements_.resize(lower.size());
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    for (const MatrixEntry& e : lower) elements_[next[e.row()]++] = {e.col(), e.value()};
    std::size_t kept = 0;
    for (int row = 0; row < size; ++row) kept = sum_up(row, kept);
    begin_.back() = kept;
    elements_.resize(kept);
  }

  int size() const { return static_cast<int>(begin_.size()) - 1; }
  /// Replaces each value by `f(row, column, value)`.
  template <class Change>
  void change(Change&& f) {
    for (int row = 0; row < size(); ++row)
      for (std::size_t k = begin_[row]; k < begin_[row + 1]; ++k)
        elements_[k].value = f(row, elements_[k].column, elements_[k].value);
  }
  /// y += A x, of these rows, to which nothing else is connected.
  void add_product(std::span<const std::int32_t> rows, const std::vector<double>& x,
                   std::vector<double>& y) const {
    for (const std::int32_t row : rows) {
      const double x_row = x[row];
      double sum = 0;
      for (std::size_t k = begin_[row]; k < begin_[row + 1]; ++k) {
        const auto& [column, value] = elements_[k];
        sum += value * x[column];
        if (column != row) y[column] += value * x_row;
      }
      y[row] += sum;
    }
  }

 private:
  /// Moves what is left of a row to `kept`, behind the rows before it.
  std::size_t sum_up(int row, std::size_t kept) {
    const auto first = elements_.begin() + static_cast<std::ptrdiff_t>(begin_[row]),
               last = elements_.begin() + static_cast<std::ptrdiff_t>(begin_[row + 1]);
    sort_by_column(first, last);
    begin_[row] = kept;
    for (auto e = first; e != last; ++e) {
      if (kept > begin_[row] && elements_[kept - 1].column == e->column)
        elements_[kept - 1].value += e->value;
      else elements_[kept++] = *e;
    }
    return kept;
  }

  /// Those of one column stay in their order.
  template <class Iterator>
  static void sort_by_column(Iterator first, Iterator last) {
    const auto before = [](const Element& a, const Element& b) { return a.column < b.column; };
    constexpr std::ptrdiff_t few = 40;
    if (last - first > few) return std::stable_sort(first, last, before);
    for (auto e = first; e != last; ++e) std::rotate(std::upper_bound(first, e, *e, before), e, e + 1);
  }

  std::vector<std::size_t> begin_;
  std::vector<Element> elements_;
};

/// |A| as the outer parts without signs and, at the places of entries, what is missing from them.
void take_absolute(Rows& rows, const std::vector<OuterPart>& outer) {
  std::vector<std::int32_t> part(static_cast<std::size_t>(rows.size()), -1);
  std::vector<double> slope(part.size(), 0.0);
  for (std::size_t p = 0; p < outer.size(); ++p)
    for (std::size_t k = 0; k < outer[p].index.size(); ++k) {
      part[outer[p].index[k]] = static_cast<std::int32_t>(p);
      slope[outer[p].index[k]] = outer[p].slope[k];
    }
  rows.change([&](int row, std::int32_t column, double value) {
    const bool meet = part[row] >= 0 && part[row] == part[column];
    const double product = meet ? outer[part[row]].factor * slope[row] * slope[column] : 0;
    return std::abs(value + product) - std::abs(product);
  });
}

/// Numbers that entries or parts connect, however far: each connected set is a matrix of its own.
class Sets {
 public:
  Sets(const std::vector<MatrixEntry>& lower, const std::vector<OuterPart>& outer, int size)
      : parent_(static_cast<std::size_t>(size)) {
    std::iota(parent_.begin(), parent_.end(), 0);
    for (const MatrixEntry& e : lower) join(e.row(), e.col());
    for (const OuterPart& part : outer)
      for (const std::int32_t k : part.index) join(k, part.index[0]);
    std::vector<std::int32_t> set(parent_.size(), -1);  // of the root of each
    for (std::int32_t k = 0; k < size; ++k)
      if (root(k) == k) set[k] = count_++;
    begin_.assign(static_cast<std::size_t>(count_) + 1, 0);
    for (std::int32_t k = 0; k < size; ++k) ++begin_[set[root(k)] + 1];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    members_.resize(parent_.size());
    for (std::int32_t k = 0; k < size; ++k) members_[next[set[root(k)]]++] = k;
    parts_.resize(static_cast<std::size_t>(count_));
    for (const OuterPart& part : outer)
      if (!part.index.empty()) parts_[set[root(part.index[0])]].push_back(&part);
  }

  int count() const { return count_; }
  std::span<const std::int32_t> members(int set) const {
    return std::span(members_).subspan(begin_[set], begin_[set + 1] - begin_[set]);
  }
  const std::vector<const OuterPart*>& parts(int set) const { return parts_[set]; }

 private:
  std::int32_t root(std::int32_t k) {
    while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
    return k;
  }
  void join(std::int32_t a, std::int32_t b) {
    a = root(a), b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

  int count_ = 0;
  std::vector<std::int32_t> parent_, members_;
  std::vector<std::size_t> begin_;
  std::vector<std::vector<const OuterPart*>> parts_;
};

/// x and y have room for all numbers, of which these are used; x = 1.
double bound_of_set(const Rows& rows, std::span<const std::int32_t> members,
                    const std::vector<const OuterPart*>& parts, std::vector<double>& x,
                    std::vector<double>& y) {
  double bound = 0;
  for (int iteration = 0; iteration < iterations; ++iteration) {
    for (const std::int32_t k : members) y[k] = 0;
    rows.add_product(members, x, y);
    for (const OuterPart* part : parts) {
      double sum = 0;
      for (std::size_t k = 0; k < part->index.size(); ++k)
        sum += std::abs(part->slope[k]) * x[part->index[k]];
      for (std::size_t k = 0; k < part->index.size(); ++k)
        y[part->index[k]] += std::abs(part->factor * part->slope[k]) * sum;
    }
    double largest_ratio = 0, largest = 0;
    for (const std::int32_t k : members) {
      largest_ratio = std::max(largest_ratio, y[k] / x[k]);
      largest = std::max(largest, y[k]);
    }
    bound = iteration == 0 ? largest_ratio : std::min(bound, largest_ratio);
    if (largest == 0) break;
    // Numbers that hardly anything connects to the stiffest ones must not vanish.
    for (const std::int32_t k : members) x[k] = y[k] / largest + 1e-3;
  }
  return bound;
}

}  // namespace

double eigenvalue_bound(const std::vector<MatrixEntry>& lower, const std::vector<OuterPart>& outer,
                        int size) {
  Rows rows(lower, size);
  take_absolute(rows, outer);
  const Sets sets(lower, outer, size);
  std::vector<double> x(static_cast<std::size_t>(size), 1.0), y(x.size()), bound(sets.count() + 1, 0.0);
  for_chunks(sets.count(), [&](std::int64_t, std::int64_t begin, std::int64_t end) {
    for (auto s = static_cast<int>(begin); s < end; ++s)
      bound[s] = bound_of_set(rows, sets.members(s), sets.parts(s), x, y);
  });
  return *std::max_element(bound.begin(), bound.end());
}

}  // namespace supple
