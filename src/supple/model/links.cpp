#include "supple/model/links.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "supple/core/disjoint_sets.hpp"
#include "supple/core/error.hpp"
#include "supple/model/row_separation.hpp"

namespace supple {
namespace {

void set_without_history(PairTable& pairs, std::int32_t row, ContactState state) {
  pairs.state[row] = state;
  std::fill_n(pairs.history.begin() + static_cast<std::ptrdiff_t>(row) * pairs.width, pairs.width, 0.0);
}

}  // namespace

std::vector<TouchingPair> touching_pairs(const System<2>& system) {
  const auto& radius = system.state.radius;
  const PairTable& pairs = system.pairs;
  if (static_cast<int>(pairs.begin.size()) != system.state.size() + 1)
    throw input_error("the pair table does not belong to these discs",
                      "it was never built, or discs were added", "update the neighbour list first");
  std::vector<TouchingPair> touching;
  for (std::int32_t row = 0; row < pairs.size(); ++row) {
    const std::int32_t i = pairs.first[row], j = pairs.second[row];
    const auto [r, up, crosses] = row_separation(system, row);
    if (norm(r) < radius[i] + radius[j]) touching.push_back({row, i, j, r, crosses});
  }
  return touching;
}

void link(PairTable& pairs, std::int32_t row) { set_without_history(pairs, row, ContactState::permanent); }
void cut(PairTable& pairs, std::int32_t row) { set_without_history(pairs, row, ContactState::slip); }

std::vector<std::int32_t> link_rows(const System<2>& system, LinkKind kind) {
  const PairTable& pairs = system.pairs;
  std::vector<std::int32_t> rows;
  for (std::int32_t row = 0; row < pairs.size(); ++row) {
    if (pairs.state[row] != ContactState::permanent) continue;
    if (kind == LinkKind::all || !row_separation(system, row).crosses) rows.push_back(row);
  }
  return rows;
}

std::vector<std::int32_t> connected_particles(const System<2>& system, LinkKind kind) {
  const int n = system.state.size();
  DisjointSets sets(n);
  for (const std::int32_t row : link_rows(system, kind))
    sets.merge(system.pairs.first[row], system.pairs.second[row]);

  std::vector<std::int32_t> particle(n, -1), number_of_root(n, -1);
  std::int32_t count = 0;
  for (std::int32_t i = 0; i < n; ++i) {
    std::int32_t& number = number_of_root[sets.root(i)];
    if (number < 0) number = count++;
    particle[i] = number;
  }
  return particle;
}

std::vector<double> particle_heights(const State<2>& state, std::span<const std::int32_t> particle) {
  const std::size_t count = particle.empty() ? 0 : *std::max_element(particle.begin(), particle.end()) + 1;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> top(count, -infinity), bottom(count, infinity), height(count);
  for (int i = 0; i < state.size(); ++i) {
    const double y = state.position[i][gradient], r = state.radius[i];
    top[particle[i]] = std::max(top[particle[i]], y + r);
    bottom[particle[i]] = std::min(bottom[particle[i]], y - r);
  }
  for (std::size_t p = 0; p < count; ++p) height[p] = top[p] - bottom[p];
  return height;
}

}  // namespace supple
