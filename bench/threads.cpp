#include "bench/threads.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <limits>
#include <thread>
#include <vector>

#include "bench/dense_discs.hpp"
#include "supple/core/parallel.hpp"

namespace supple::bench {
namespace {

/// One thread for each core that computes for nobody while this lives.
class Load {
 public:
  Load() {
    for (unsigned i = 0; i < std::thread::hardware_concurrency(); ++i)
      threads_.emplace_back([this] {
        while (!done_.load(std::memory_order_relaxed)) {
        }
      });
  }
  ~Load() {
    done_ = true;
    for (std::thread& t : threads_) t.join();
  }

 private:
  std::atomic<bool> done_{false};
  std::vector<std::thread> threads_;
};

double wall_seconds(System<2> system, int steps, int threads) {
  thread_count() = threads;
  Mover dynamics = dense_dynamics();
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < steps; ++i) {
    dynamics.evaluate(system, {});
    dynamics.advance(system, {}, time_step, 1);
  }
  thread_count() = 1;
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Best times of several attempts in turn, relative: two threads over one.
double two_over_one(const System<2>& start, int steps) {
  double one = std::numeric_limits<double>::infinity(), two = one;
  for (int repeat = 0; repeat < 5; ++repeat) {
    one = std::min(one, wall_seconds(start, steps, 1));
    two = std::min(two, wall_seconds(start, steps, 2));
  }
  return two / one;
}

}  // namespace

void print_threads() {
  fmt::print("\nWall time with two threads over that with one, dense discs (best of five, in turn)\n");
  fmt::print("  {:>7}  {:>8}  {:>8}   busy: one thread of another program on each of {} cores\n", "discs",
             "quiet", "busy", std::thread::hardware_concurrency());
  for (const int discs : {1500, 10000, 100000}) {
    DenseSpec spec;
    spec.discs = discs;
    const System<2> start = dense_discs(spec);
    const int steps = std::max(4'000'000 / discs, 40);
    const double quiet = two_over_one(start, steps);
    const Load load;
    fmt::print("  {:>7}  {:>8.2f}  {:>8.2f}\n", discs, quiet, two_over_one(start, steps));
  }
}

}  // namespace supple::bench
