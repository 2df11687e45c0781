#include "supple/solve/eigenvalue_bound.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "supple/core/disjoint_sets.hpp"

namespace supple {

namespace {

constexpr int iterations = 30;

/// Numbers that entries or parts connect, however far, are a set: a matrix of its own. In a new order each
/// set stands together, its numbers in their old order. It begins at an even number; where the next one would
/// not, a number without entries comes between.
class Sets {
 public:
  void find(const std::vector<MatrixEntry>& lower, const std::vector<OuterPart>& outer, int size) {
    joined_.separate(size);
    for (const MatrixEntry& e : lower)
      if (e.row() != e.col()) joined_.merge(e.row(), e.col());
    for (const OuterPart& part : outer)
      for (const std::int32_t k : part.index) joined_.merge(k, part.index[0]);
    set_.resize(static_cast<std::size_t>(size));
    begin_.assign(1, 0);
    for (std::int32_t k = 0; k < size; ++k) {
      const std::int32_t root = joined_.root(k);
      if (root == k) begin_.push_back(0);
      set_[k] = root == k ? count() - 1 : set_[root];  // a root comes first
      ++begin_[set_[k] + 1];
    }
    for (int s = 0; s < count(); ++s) begin_[s + 1] = begin_[s] + (begin_[s + 1] + 1) / 2 * 2;
    next_.assign(begin_.begin(), begin_.end() - 1);
    place_.resize(set_.size());
    for (std::int32_t k = 0; k < size; ++k) place_[k] = next_[set_[k]]++;
  }

  int count() const { return static_cast<int>(begin_.size()) - 1; }
  /// New numbers of a set: begin(s) up to begin(s + 1).
  std::int32_t begin(int set) const { return begin_[set]; }
  std::int32_t size() const { return begin_.back(); }
  /// New number of each old one, and its set.
  std::int32_t place(std::int32_t old) const { return place_[old]; }
  std::int32_t set(std::int32_t old) const { return set_[old]; }

 private:
  DisjointSets joined_{0};
  std::vector<std::int32_t> set_, begin_, next_, place_;
};

/// The outer parts in the new order, one set after the other.
class Parts {
 public:
  void arrange(const std::vector<OuterPart>& outer, const Sets& sets) {
    order_.clear();
    for (const OuterPart& part : outer)
      if (!part.index.empty()) order_.push_back(&part);
    const auto set_of = [&](const OuterPart* part) { return sets.set(part->index[0]); };
    std::stable_sort(order_.begin(), order_.end(),
                     [&](const OuterPart* a, const OuterPart* b) { return set_of(a) < set_of(b); });
    first_.assign(static_cast<std::size_t>(sets.count()) + 1, 0);
    for (const OuterPart* part : order_) ++first_[set_of(part) + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    begin_.assign(1, 0);
    members_.clear();
    at_.assign(static_cast<std::size_t>(sets.size()), {});
    for (const OuterPart* part : order_) {
      for (std::size_t k = 0; k < part->index.size(); ++k) {
        const std::int32_t number = sets.place(part->index[k]);
        members_.push_back({number, std::abs(part->slope[k]), std::abs(part->factor * part->slope[k])});
        at_[number] = {part, part->slope[k]};
      }
      begin_.push_back(members_.size());
    }
  }

  /// What the parts have at a place of the matrix.
  double at(std::int32_t row, std::int32_t column) const {
    const At &r = at_[row], &c = at_[column];
    return r.part && r.part == c.part ? r.part->factor * r.slope * c.slope : 0;
  }

  /// y += A x of the parts of a set, all without signs.
  void add_product(int set, const std::vector<double>& x, std::vector<double>& y) const {
    for (std::int32_t part = first_[set]; part < first_[set + 1]; ++part) {
      double sum = 0;
      for (std::size_t k = begin_[part]; k < begin_[part + 1]; ++k)
        sum += members_[k].slope * x[members_[k].number];
      for (std::size_t k = begin_[part]; k < begin_[part + 1]; ++k)
        y[members_[k].number] += members_[k].pull * sum;
    }
  }

 private:
  struct Member {
    std::int32_t number;
    double slope, pull;  ///< |slope| and |factor slope|
  };
  struct At {
    const OuterPart* part = nullptr;
    double slope = 0;
  };
  std::vector<const OuterPart*> order_;
  std::vector<std::int32_t> first_;  ///< of each set
  std::vector<std::size_t> begin_;   ///< of each part
  std::vector<Member> members_;
  std::vector<At> at_;
};

/// The lower triangle of |A| in the new order, without what the parts without signs have: of each pair of
/// rows 2p, 2p + 1 the block on the diagonal, and other blocks by ascending columns. Entries of one place are
/// summed in their order.
class PairRows {
 public:
  void arrange(const std::vector<MatrixEntry>& lower, const Sets& sets, const Parts& parts) {
    const std::int32_t pairs = sets.size() / 2;
    next_.assign(static_cast<std::size_t>(pairs) + 1, 0);
    for (const MatrixEntry& e : lower) ++next_[sets.place(e.row()) / 2 + 1];
    std::partial_sum(next_.begin(), next_.end(), next_.begin());
    elements_.resize(lower.size());
    for (const MatrixEntry& e : lower) {
      const std::int32_t row = sets.place(e.row());
      elements_[next_[row / 2]++] = {sets.place(e.col()), row % 2, e.value()};
    }
    diagonal_.assign(static_cast<std::size_t>(pairs), {});
    blocks_.clear();
    begin_.assign(1, 0);
    auto first = elements_.begin();
    for (std::int32_t p = 0; p < pairs; ++p) {
      const auto last = elements_.begin() + static_cast<std::ptrdiff_t>(next_[p]);
      sort_by_pair(first, last);
      while (first != last) first = add_block(p, first, last, parts);
      begin_.push_back(blocks_.size());
    }
  }

  /// y = A x, of rows that form a set.
  void product(std::int32_t first, std::int32_t last, const std::vector<double>& x,
               std::vector<double>& y) const {
    for (std::int32_t p = first / 2; p < last / 2; ++p) {
      const double x0 = x[2 * p], x1 = x[2 * p + 1];
      double sum0 = 0, sum1 = 0;
      for (std::size_t k = begin_[p]; k < begin_[p + 1]; ++k) {
        const auto& [column, h] = blocks_[k];
        const double* from = &x[column];
        double* to = &y[column];
        sum0 = sum0 + h[0][0] * from[0] + h[0][1] * from[1];
        sum1 = sum1 + h[1][0] * from[0] + h[1][1] * from[1];
        to[0] = to[0] + h[0][0] * x0 + h[1][0] * x1;
        to[1] = to[1] + h[0][1] * x0 + h[1][1] * x1;
      }
      const auto& [d00, d10, d11] = diagonal_[p];
      y[2 * p] = sum0 + d00 * x0 + d10 * x1;
      y[2 * p + 1] = sum1 + d10 * x0 + d11 * x1;
    }
  }

 private:
  struct Element {
    std::int32_t column = 0, odd_row = 0;
    double value = 0;
    std::int32_t pair() const { return column / 2; }
  };
  struct Block {
    std::int32_t column;  ///< the first of two
    double h[2][2];
  };
  struct Diagonal {
    double h00 = 0, h10 = 0, h11 = 0;
  };

  /// Those of one pair of columns stay in their order.
  template <class Iterator>
  static void sort_by_pair(Iterator first, Iterator last) {
    const auto before = [](const Element& a, const Element& b) { return a.pair() < b.pair(); };
    constexpr std::ptrdiff_t few = 40;
    if (last - first > few) return std::stable_sort(first, last, before);
    for (auto e = first; e != last; ++e) {
      const Element moved = *e;
      auto to = e;
      for (; to != first && before(moved, *(to - 1)); --to) *to = *(to - 1);
      *to = moved;
    }
  }

  /// Adds the block of the columns of the first element. Returns the first one of other columns.
  template <class Iterator>
  Iterator add_block(std::int32_t pair, Iterator e, Iterator last, const Parts& parts) {
    const std::int32_t of = e->pair();
    double h[2][2] = {};
    for (; e != last && e->pair() == of; ++e) h[e->odd_row][e->column % 2] += e->value;
    for (int r = 0; r < 2; ++r)
      for (int c = 0; c < 2; ++c) {
        const double product = parts.at(2 * pair + r, 2 * of + c);
        h[r][c] = std::abs(h[r][c] + product) - std::abs(product);
      }
    if (of == pair) diagonal_[pair] = {h[0][0], h[1][0], h[1][1]};
    else if (h[0][0] != 0 || h[0][1] != 0 || h[1][0] != 0 || h[1][1] != 0)
      blocks_.push_back({2 * of, {{h[0][0], h[0][1]}, {h[1][0], h[1][1]}}});
    return e;
  }

  std::vector<std::size_t> next_, begin_;
  std::vector<Element> elements_;
  std::vector<Block> blocks_;
  std::vector<Diagonal> diagonal_;
};

struct Largest {
  double value = 0, ratio = 0;
};

/// The largest y_k and y_k/x_k of k in [first, last), none of which is below zero. In lanes: a maximum is the
/// same in any order.
Largest largest_of(const std::vector<double>& x, const std::vector<double>& y, std::int32_t first,
                   std::int32_t last) {
  const auto larger = [](double a, double b) { return a < b ? b : a; };
  constexpr int lanes = 8;
  double value[lanes] = {}, ratio[lanes] = {};
  std::int32_t k = first;
  for (; k + lanes <= last; k += lanes)
    for (int lane = 0; lane < lanes; ++lane) {
      value[lane] = larger(value[lane], y[k + lane]);
      ratio[lane] = larger(ratio[lane], y[k + lane] / x[k + lane]);
    }
  Largest all;
  for (; k < last; ++k) all = {larger(all.value, y[k]), larger(all.ratio, y[k] / x[k])};
  for (int lane = 0; lane < lanes; ++lane)
    all = {larger(all.value, value[lane]), larger(all.ratio, ratio[lane])};
  return all;
}

/// x and y have room for all numbers, of which those of the set are used; x = 1. A bound of `least` or less
/// is not sharpened further.
double bound_of_set(const Sets& sets, const Parts& parts, const PairRows& rows, int set, double least,
                    std::vector<double>& x, std::vector<double>& y) {
  const std::int32_t first = sets.begin(set), last = sets.begin(set + 1);
  double bound = 0;
  for (int iteration = 0; iteration < iterations; ++iteration) {
    rows.product(first, last, x, y);
    parts.add_product(set, x, y);
    const Largest largest = largest_of(x, y, first, last);
    bound = iteration == 0 ? largest.ratio : std::min(bound, largest.ratio);
    if (largest.value == 0 || bound <= least) break;
    // Numbers that hardly anything connects to the stiffest ones must not vanish.
    for (std::int32_t k = first; k < last; ++k) x[k] = y[k] / largest.value + 1e-3;
  }
  return bound;
}

}  // namespace

struct EigenvalueBound::Memory {
  Sets sets;
  Parts parts;
  PairRows rows;
  std::vector<double> x, y;
};

EigenvalueBound::EigenvalueBound() : memory_(std::make_unique<Memory>()) {}
EigenvalueBound::~EigenvalueBound() = default;

double EigenvalueBound::of(const std::vector<MatrixEntry>& lower, const std::vector<OuterPart>& outer,
                           int size, double least) {
  auto& [sets, parts, rows, x, y] = *memory_;
  sets.find(lower, outer, size);
  parts.arrange(outer, sets);
  rows.arrange(lower, sets, parts);
  x.assign(static_cast<std::size_t>(sets.size()), 1.0);
  y.resize(x.size());
  for (int s = 0; s < sets.count(); ++s)
    least = std::max(least, bound_of_set(sets, parts, rows, s, least, x, y));
  return least;
}

}  // namespace supple
