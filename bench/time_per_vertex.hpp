/// How long evaluations take, compared in one run.
#pragma once
#include <algorithm>
#include <array>
#include <functional>

#include "bench/machine.hpp"

namespace supple::bench {

/// Nanoseconds of each call per vertex: the fastest of many short turns, which is what the code takes when
/// nobody disturbs it. The calls take turns, so that they meet the same disturbances.
template <std::size_t n>
std::array<double, n> time_per_vertex(int vertices, const std::array<std::function<void()>, n>& calls) {
  const int repeats = std::max(1, 40'000 / vertices), turns = vertices > 100'000 ? 10 : 500;
  std::array<double, n> best;
  best.fill(1e300);
  for (int turn = 0; turn < turns; ++turn)
    for (std::size_t c = 0; c < n; ++c) {
      const double start = cpu_seconds();
      for (int k = 0; k < repeats; ++k) calls[c]();
      best[c] = std::min(best[c], 1e9 * (cpu_seconds() - start) / (static_cast<double>(repeats) * vertices));
    }
  return best;
}

}  // namespace supple::bench
