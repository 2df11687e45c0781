/// Which of many boxes overlap.
#pragma once
#include <cstdint>
#include <vector>

#include "supple/core/vec.hpp"

namespace supple {

/// A box along the axes, its faces included [length].
struct Extent {
  Vec3 low, high;

  bool overlaps(const Extent& other) const {
    for (int d = 0; d < 3; ++d)
      if (low[d] > other.high[d] || other.low[d] > high[d]) return false;
    return true;
  }
  /// Grows so that it holds the other one.
  void include(const Extent& other);
};

/// Boxes sorted into a binary tree: pairs that overlap are found in a time that grows as n log n and with the
/// number of these pairs, however different the boxes are in size. Coordinates must be finite.
class BoxTree {
 public:
  explicit BoxTree(std::vector<Extent> boxes);

  /// visit(i, j), i < j, for each pair of boxes that overlap, once and in no particular order, which is
  /// always the same.
  template <class Visit>
  void for_pairs(const Visit& visit) const {
    if (!nodes_.empty()) for_pairs_within(0, visit);
  }
  /// visit(i, j) for each box i of this tree and box j of the other that overlap, in the same way.
  template <class Visit>
  void for_pairs_with(const BoxTree& other, const Visit& visit) const {
    if (!nodes_.empty() && !other.nodes_.empty()) for_pairs_between(0, other, 0, visit);
  }

 private:
  /// Boxes order_[begin, end), all in `extent`. They are in two nodes below this one, or in this leaf.
  struct Node {
    Extent extent;
    std::int32_t begin, end;
    std::int32_t first = -1, second = -1;
    bool is_leaf() const { return first < 0; }
  };
  static constexpr std::int32_t leaf_size = 4;

  std::int32_t build(std::int32_t begin, std::int32_t end);

  template <class Visit>
  void for_pairs_within(std::int32_t node, const Visit& visit) const {
    const Node& n = nodes_[node];
    if (!n.is_leaf()) {
      for_pairs_within(n.first, visit);
      for_pairs_within(n.second, visit);
      for_pairs_between(n.first, *this, n.second, [&](std::int32_t i, std::int32_t j) {
        if (i < j) visit(i, j);
        else visit(j, i);
      });
      return;
    }
    for (std::int32_t a = n.begin; a < n.end; ++a)
      for (std::int32_t b = a + 1; b < n.end; ++b) {
        const std::int32_t i = order_[a], j = order_[b];
        if (!boxes_[i].overlaps(boxes_[j])) continue;
        if (i < j) visit(i, j);
        else visit(j, i);
      }
  }

  template <class Visit>
  void for_pairs_between(std::int32_t node, const BoxTree& other, std::int32_t other_node,
                         const Visit& visit) const {
    const Node &a = nodes_[node], &b = other.nodes_[other_node];
    if (!a.extent.overlaps(b.extent)) return;
    if (a.is_leaf() && b.is_leaf()) {
      for (std::int32_t k = a.begin; k < a.end; ++k)
        for (std::int32_t l = b.begin; l < b.end; ++l)
          if (boxes_[order_[k]].overlaps(other.boxes_[other.order_[l]])) visit(order_[k], other.order_[l]);
    } else if (b.is_leaf() || (!a.is_leaf() && a.end - a.begin >= b.end - b.begin)) {
      for_pairs_between(a.first, other, other_node, visit);
      for_pairs_between(a.second, other, other_node, visit);
    } else {
      for_pairs_between(node, other, b.first, visit);
      for_pairs_between(node, other, b.second, visit);
    }
  }

  std::vector<Extent> boxes_;
  std::vector<std::int32_t> order_;
  std::vector<Node> nodes_;  ///< the first holds all
};

}  // namespace supple
