#include "supple/core/parallel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <ctime>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>

namespace supple {
namespace {

using Clock = std::chrono::steady_clock;

class Parallel : public testing::Test {
 protected:
  void TearDown() override { thread_count() = 1; }
};

TEST_F(Parallel, EveryChunkIsDoneOnceByAnyNumberOfThreadsAndLoops) {
  for (const int threads : {2, 3, 7, 2, 1}) {
    thread_count() = threads;
    for (const std::int64_t n : {1, 1000, 5000, 20001})
      for (int repeat = 0; repeat < 200; ++repeat) {
        std::vector<int> visits(static_cast<std::size_t>(n));
        for_chunks(n, [&](std::int64_t chunk, std::int64_t begin, std::int64_t end) {
          EXPECT_EQ(begin, chunk * chunk_size);
          for (std::int64_t i = begin; i < end; ++i) ++visits[i];
        });
        EXPECT_EQ(std::count(visits.begin(), visits.end(), 1), n);
      }
  }
}

TEST_F(Parallel, EachThreadHasOneTurnEvenWhereOneDoesAll) {
  for (const int threads : {1, 2, 5}) {
    thread_count() = threads;
    for (int repeat = 0; repeat < 200; ++repeat) {
      std::vector<int> turns(static_cast<std::size_t>(threads));
      for_each_thread([&](std::int64_t k) { ++turns[static_cast<std::size_t>(k)]; });
      EXPECT_EQ(turns, std::vector<int>(static_cast<std::size_t>(threads), 1));
    }
  }
}

/// Sums of numbers of very different size: another order gives other bits.
TEST_F(Parallel, SumsHaveTheSameBitsForAnyNumberOfThreads) {
  const auto sum = [](int threads) {
    thread_count() = threads;
    return sum_chunks<double>(50000, [](std::int64_t begin, std::int64_t end) {
      double s = 0;
      for (std::int64_t i = begin; i < end; ++i)
        s += std::sin(static_cast<double>(i)) * std::pow(10., i % 23);
      return s;
    });
  };
  const double one = sum(1);
  for (int repeat = 0; repeat < 50; ++repeat)
    for (const int threads : {2, 3, 5}) EXPECT_EQ(sum(threads), one);
}

TEST_F(Parallel, TheExceptionOfTheFirstChunkIsThrownAsOneThreadWould) {
  for (const int threads : {1, 2, 4}) {
    thread_count() = threads;
    std::string message;
    try {
      for_chunks(20000, [](std::int64_t chunk, std::int64_t, std::int64_t) {
        if (chunk % 7 == 3) throw std::runtime_error("chunk " + std::to_string(chunk));
      });
    } catch (const std::runtime_error& e) {
      message = e.what();
    }
    EXPECT_EQ(message, "chunk 3");
    std::atomic<int> chunks = 0;  // and the next loop runs
    for_chunks(20000, [&](std::int64_t, std::int64_t, std::int64_t) { ++chunks; });
    EXPECT_EQ(chunks, chunk_count(20000));
  }
}

TEST_F(Parallel, LoopsWithinLoopsRunInPlaceAndThoseOfOtherThreadsHaveTheirOwnHelpers) {
  thread_count() = 2;
  std::atomic<std::int64_t> visits = 0;
  const auto loops = [&] {
    const WithThreads two(2);
    for (int repeat = 0; repeat < 20; ++repeat)
      for_chunks(5000, [&](std::int64_t, std::int64_t, std::int64_t) {
        for_chunks(2000, [&](std::int64_t, std::int64_t begin, std::int64_t end) { visits += end - begin; });
      });
  };
  std::thread other(loops);
  loops();
  other.join();
  EXPECT_EQ(visits, 2 * 20 * chunk_count(5000) * 2000);
}

/// CPU time of this process [s].
double cpu_seconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

TEST_F(Parallel, ThreadsSleepBetweenLoops) {
  thread_count() = 8;
  for_chunks(10000, [](std::int64_t, std::int64_t, std::int64_t) {});
  const double before = cpu_seconds();
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  EXPECT_LT(cpu_seconds() - before, 0.02);  // 7 threads that look for work would take more
}

/// Threads that compute for nobody while this lives: two for each core.
class BusyMachine {
 public:
  BusyMachine() {
    for (unsigned i = 0; i < 2 * std::thread::hardware_concurrency(); ++i)
      hogs_.emplace_back([this] {
        while (!quiet_.load(std::memory_order_relaxed)) {
        }
      });
  }
  ~BusyMachine() {
    quiet_ = true;
    for (std::thread& hog : hogs_) hog.join();
  }

 private:
  std::atomic<bool> quiet_{false};
  std::vector<std::thread> hogs_;
};

/// Seconds of many short loops, as a time step of some thousand discs has several.
double seconds_of_loops(int threads) {
  thread_count() = threads;
  std::vector<double> x(4096, 1);
  const auto begin = Clock::now();
  for (int loop = 0; loop < 3000; ++loop)
    for_chunks(4096, [&](std::int64_t, std::int64_t first, std::int64_t end) {
      for (std::int64_t i = first; i < end; ++i) x[i] = std::sqrt(x[i] + 1e-3);
    });
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Threads that spin until all have arrived, as those of OpenMP do unless told otherwise, took 20 to 30 times
/// as long.
TEST_F(Parallel, TwoThreadsOnABusyMachineTakeAboutTheTimeOfOne) {
  const BusyMachine busy;
  double ratio = std::numeric_limits<double>::infinity();
  for (int attempt = 0; attempt < 3; ++attempt)
    ratio = std::min(ratio, seconds_of_loops(2) / seconds_of_loops(1));
  EXPECT_LT(ratio, 4);
}

}  // namespace
}  // namespace supple
