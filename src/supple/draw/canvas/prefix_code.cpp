#include "supple/draw/canvas/prefix_code.hpp"

#include <algorithm>
#include <numeric>

namespace supple {

namespace {

/// Depths of the leaves of a tree over these weights, which ascend: the two lightest nodes are joined until
/// one is left. Joined nodes come in ascending weight, so that the next lightest heads one of two queues.
std::vector<int> depths_of(std::span<const std::uint64_t> leaves) {
  const std::size_t n = leaves.size(), nodes = 2 * n - 1;
  std::vector<std::uint64_t> weight(leaves.begin(), leaves.end());
  std::vector<std::size_t> parent(nodes);
  std::size_t leaf = 0, joined = n;
  const auto take = [&] {
    const bool is_leaf = leaf < n && (joined == weight.size() || weight[leaf] <= weight[joined]);
    const std::size_t node = is_leaf ? leaf++ : joined++;
    parent[node] = weight.size();
    return weight[node];
  };
  while (weight.size() < nodes) {
    const std::uint64_t first = take(), second = take();
    weight.push_back(first + second);
  }
  std::vector<int> depth(nodes, 0);
  for (std::size_t node = nodes - 1; node-- > 0;) depth[node] = depth[parent[node]] + 1;
  depth.resize(n);
  return depth;
}

}  // namespace

std::vector<std::uint8_t> code_lengths(std::span<const std::uint32_t> counts, int limit) {
  std::vector<std::uint8_t> lengths(counts.size(), 0);
  std::vector<std::size_t> symbols;
  for (std::size_t s = 0; s < counts.size(); ++s)
    if (counts[s] > 0) symbols.push_back(s);
  if (symbols.size() < 2) {
    for (const std::size_t s : symbols) lengths[s] = 1;
    return lengths;
  }
  std::ranges::stable_sort(symbols, {}, [&](std::size_t s) { return counts[s]; });
  std::vector<std::uint64_t> weight;
  for (const std::size_t s : symbols) weight.push_back(counts[s]);
  std::vector<int> depth = depths_of(weight);
  while (std::ranges::max(depth) > limit) {  // flatter weights make a flatter tree
    for (std::uint64_t& w : weight) w = (w + 1) / 2;
    depth = depths_of(weight);
  }
  for (std::size_t k = 0; k < symbols.size(); ++k) lengths[symbols[k]] = static_cast<std::uint8_t>(depth[k]);
  return lengths;
}

std::vector<std::uint16_t> codes_of(std::span<const std::uint8_t> lengths) {
  constexpr int most = 15;
  std::uint16_t count[most + 2] = {}, next[most + 2] = {};
  for (const std::uint8_t length : lengths) ++count[length];
  count[0] = 0;
  for (int bits = 1; bits <= most; ++bits)
    next[bits + 1] = static_cast<std::uint16_t>((next[bits] + count[bits]) << 1);
  std::vector<std::uint16_t> codes(lengths.size(), 0);
  for (std::size_t s = 0; s < lengths.size(); ++s) {
    if (lengths[s] == 0) continue;
    const unsigned code = next[lengths[s]]++;
    for (int bit = 0; bit < lengths[s]; ++bit)
      codes[s] |= static_cast<std::uint16_t>((code >> bit & 1) << (lengths[s] - 1 - bit));
  }
  return codes;
}

}  // namespace supple
