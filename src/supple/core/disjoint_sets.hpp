/// Which things belong together, from pairs that do.
#pragma once
#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace supple {

/// Disjoint sets of the numbers below a size, at first one for each number. The root of a set is its least
/// number.
class DisjointSets {
 public:
  explicit DisjointSets(int size) { separate(size); }
  /// Starts anew with this size.
  void separate(int size) {
    parent_.resize(static_cast<std::size_t>(size));
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  std::int32_t root(std::int32_t k) {
    while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
    return k;
  }
  /// Unites the sets of a and b. Returns whether they were two.
  bool merge(std::int32_t a, std::int32_t b) {
    a = root(a), b = root(b);
    if (a == b) return false;
    parent_[std::max(a, b)] = std::min(a, b);
    return true;
  }

 private:
  std::vector<std::int32_t> parent_;
};

}  // namespace supple
