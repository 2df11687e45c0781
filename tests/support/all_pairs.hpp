/// The pair table by brute force: a row for every pair of sites.
#pragma once
#include "supple/model/system.hpp"

namespace supple::testing {

template <int Dim>
void fill_all_pairs(System<Dim>& system, int history_width = 1) {
  PairTable& pairs = system.pairs;
  pairs.clear();
  pairs.width = history_width;
  pairs.version = new_version();
  const int n = system.state.size();
  for (int i = 0; i < n; ++i) {
    pairs.begin.push_back(pairs.size());
    for (int j = i + 1; j < n; ++j) {
      pairs.first.push_back(i);
      pairs.second.push_back(j);
    }
  }
  pairs.begin.push_back(pairs.size());
  pairs.state.assign(pairs.size(), ContactState::open);
  pairs.history.assign(static_cast<std::size_t>(pairs.size()) * history_width, 0.0);
}

}  // namespace supple::testing
