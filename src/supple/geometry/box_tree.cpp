#include "supple/geometry/box_tree.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace supple {

void Extent::include(const Extent& other) {
  for (int d = 0; d < 3; ++d) {
    low[d] = std::min(low[d], other.low[d]);
    high[d] = std::max(high[d], other.high[d]);
  }
}

BoxTree::BoxTree(std::vector<Extent> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  if (!boxes_.empty()) build(0, static_cast<std::int32_t>(boxes_.size()));
}

/// The node of these boxes, split in halves along the direction in which their centres spread most.
std::int32_t BoxTree::build(std::int32_t begin, std::int32_t end) {
  const auto twice_centre = [&](std::int32_t i, int d) { return boxes_[i].low[d] + boxes_[i].high[d]; };
  Node node{boxes_[order_[begin]], begin, end};
  Vec3 least, most;
  for (int d = 0; d < 3; ++d) least[d] = most[d] = twice_centre(order_[begin], d);
  for (std::int32_t k = begin + 1; k < end; ++k) {
    node.extent.include(boxes_[order_[k]]);
    for (int d = 0; d < 3; ++d) {
      least[d] = std::min(least[d], twice_centre(order_[k], d));
      most[d] = std::max(most[d], twice_centre(order_[k], d));
    }
  }
  const auto index = static_cast<std::int32_t>(nodes_.size());
  nodes_.push_back(node);
  if (end - begin <= leaf_size) return index;
  const Vec3 spread = most - least;
  const int along = spread[0] >= spread[1] && spread[0] >= spread[2] ? 0 : spread[1] >= spread[2] ? 1 : 2;
  const std::int32_t middle = begin + (end - begin) / 2;
  // Equal centres are told apart by their numbers, so that every library sorts them into the same halves.
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](std::int32_t i, std::int32_t j) {
                     return std::pair(twice_centre(i, along), i) < std::pair(twice_centre(j, along), j);
                   });
  const std::int32_t first = build(begin, middle), second = build(middle, end);
  nodes_[index].first = first;
  nodes_[index].second = second;
  return index;
}

}  // namespace supple
