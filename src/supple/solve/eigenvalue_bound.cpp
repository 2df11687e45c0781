#include "supple/solve/eigenvalue_bound.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "supple/core/parallel.hpp"

namespace supple {

namespace {

constexpr int iterations = 30;

struct Element {
  std::int32_t column;
  double value;
};

/// Numbers that entries or parts connect, however far, are a set: a matrix of its own. In a new order each
/// set stands together, its numbers in their old order.
class Sets {
 public:
  Sets(const std::vector<MatrixEntry>& lower, const std::vector<OuterPart>& outer, int size)
      : parent_(static_cast<std::size_t>(size)), place_(parent_.size()) {
    std::iota(parent_.begin(), parent_.end(), 0);
    for (const MatrixEntry& e : lower) join(e.row(), e.col());
    for (const OuterPart& part : outer)
      for (const std::int32_t k : part.index) join(k, part.index[0]);
    std::vector<std::int32_t> set(parent_.size());
    int count = 0;
    for (std::int32_t k = 0; k < size; ++k)
      set[k] = root(k) == k ? count++ : set[root(k)];  // a root is first
    begin_.assign(static_cast<std::size_t>(count) + 1, 0);
    for (const std::int32_t s : set) ++begin_[s + 1];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    std::vector<std::int32_t> next(begin_.begin(), begin_.end() - 1);
    for (std::int32_t k = 0; k < size; ++k) place_[k] = next[set[k]]++;
    parts_.resize(static_cast<std::size_t>(count));
    for (const OuterPart& part : outer)
      if (!part.index.empty()) parts_[set[part.index[0]]].push_back(moved(part));
  }

  int count() const { return static_cast<int>(parts_.size()); }
  /// New numbers of a set: begin(s) up to begin(s + 1).
  std::int32_t begin(int set) const { return begin_[set]; }
  /// New number of each old one.
  std::int32_t place(std::int32_t old) const { return place_[old]; }
  const std::vector<OuterPart>& parts(int set) const { return parts_[set]; }

 private:
  std::int32_t root(std::int32_t k) {
    while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
    return k;
  }
  void join(std::int32_t a, std::int32_t b) {
    a = root(a), b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }
  OuterPart moved(OuterPart part) const {
    for (std::int32_t& k : part.index) k = place_[k];
    return part;
  }

  std::vector<std::int32_t> parent_, place_, begin_;
  std::vector<std::vector<OuterPart>> parts_;
};

/// The lower triangle in the new order, row by row: columns ascend, and entries of one place are summed in
/// their order.
class Rows {
 public:
  Rows(const std::vector<MatrixEntry>& lower, const Sets& sets, int size)
      : begin_(static_cast<std::size_t>(size) + 1, 0) {
    for (const MatrixEntry& e : lower) ++begin_[sets.place(e.row()) + 1];
    for (std::size_t k = 1; k < begin_.size(); ++k) begin_[k] += begin_[k - 1];
    elements_.resize(lower.size());
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    for (const MatrixEntry& e : lower)
      elements_[next[sets.place(e.row())]++] = {sets.place(e.col()), e.value()};
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
  /// y += A x, of rows that form a set.
  void add_product(std::int32_t first, std::int32_t last, const std::vector<double>& x,
                   std::vector<double>& y) const {
    for (std::int32_t row = first; row < last; ++row) {
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
    for (auto e = first; e != last; ++e) {
      const Element moved = *e;
      auto to = e;
      for (; to != first && before(moved, *(to - 1)); --to) *to = *(to - 1);
      *to = moved;
    }
  }

  std::vector<std::size_t> begin_;
  std::vector<Element> elements_;
};

/// |A| as the outer parts without signs and, at the places of entries, what is missing from them.
void take_absolute(Rows& rows, const Sets& sets) {
  std::vector<const OuterPart*> part(static_cast<std::size_t>(rows.size()), nullptr);
  std::vector<double> slope(part.size(), 0.0);
  for (int s = 0; s < sets.count(); ++s)
    for (const OuterPart& p : sets.parts(s))
      for (std::size_t k = 0; k < p.index.size(); ++k) {
        part[p.index[k]] = &p;
        slope[p.index[k]] = p.slope[k];
      }
  rows.change([&](int row, std::int32_t column, double value) {
    const bool meet = part[row] && part[row] == part[column];
    const double product = meet ? part[row]->factor * slope[row] * slope[column] : 0;
    return std::abs(value + product) - std::abs(product);
  });
}

/// x and y have room for all numbers, of which those of the set are used; x = 1. A bound of `least` or less
/// is not sharpened further.
double bound_of_set(const Rows& rows, const Sets& sets, int set, double least, std::vector<double>& x,
                    std::vector<double>& y) {
  const std::int32_t first = sets.begin(set), last = sets.begin(set + 1);
  double bound = 0;
  for (int iteration = 0; iteration < iterations; ++iteration) {
    std::fill(y.begin() + first, y.begin() + last, 0.0);
    rows.add_product(first, last, x, y);
    for (const OuterPart& part : sets.parts(set)) {
      double sum = 0;
      for (std::size_t k = 0; k < part.index.size(); ++k) sum += std::abs(part.slope[k]) * x[part.index[k]];
      for (std::size_t k = 0; k < part.index.size(); ++k)
        y[part.index[k]] += std::abs(part.factor * part.slope[k]) * sum;
    }
    double largest_ratio = 0, largest = 0;
    for (std::int32_t k = first; k < last; ++k) {
      largest_ratio = std::max(largest_ratio, y[k] / x[k]);
      largest = std::max(largest, y[k]);
    }
    bound = iteration == 0 ? largest_ratio : std::min(bound, largest_ratio);
    if (largest == 0 || bound <= least) break;
    // Numbers that hardly anything connects to the stiffest ones must not vanish.
    for (std::int32_t k = first; k < last; ++k) x[k] = y[k] / largest + 1e-3;
  }
  return bound;
}

}  // namespace

double eigenvalue_bound(const std::vector<MatrixEntry>& lower, const std::vector<OuterPart>& outer,
                        int size) {
  const Sets sets(lower, outer, size);
  Rows rows(lower, sets, size);
  take_absolute(rows, sets);
  std::vector<double> x(static_cast<std::size_t>(size), 1.0), y(x.size()), bound(x.size() + 1, 0.0);
  for_chunks(sets.count(), [&](std::int64_t, std::int64_t begin, std::int64_t end) {
    double largest = 0;  // only the largest of all bounds counts: sets below one that is known need no more
    for (auto s = static_cast<int>(begin); s < end; ++s) {
      bound[s] = bound_of_set(rows, sets, s, largest, x, y);
      largest = std::max(largest, bound[s]);
    }
  });
  return *std::max_element(bound.begin(), bound.end());
}

}  // namespace supple
