#include "bench/machine.hpp"

#include <algorithm>
#include <array>
#include <ctime>
#include <fstream>
#include <vector>

namespace supple::bench {

namespace {

/// CPU seconds of the fastest of several calls.
template <class Body>
double best_seconds(Body&& body) {
  double best = 1e300;
  for (int repeat = 0; repeat < 5; ++repeat) {
    const double start = cpu_seconds();
    body();
    best = std::min(best, cpu_seconds() - start);
  }
  return best;
}

/// Keeps the compiler from dropping work whose result nobody reads.
void use(const void* data) { asm volatile("" : : "g"(data) : "memory"); }

}  // namespace

double cpu_seconds() {
  timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  return "an unnamed processor";
}

double bytes_per_nanosecond(std::size_t bytes) {
  const std::size_t half = bytes / 2 / sizeof(double);
  std::vector<double> from(half, 1.0), to(half, 0.0);
  const std::size_t copies = std::max<std::size_t>(1, 400'000'000 / bytes);
  const double seconds = best_seconds([&] {
    for (std::size_t c = 0; c < copies; ++c) {
      std::copy(from.begin(), from.end(), to.begin());
      use(to.data());
    }
  });
  return static_cast<double>(copies * 2 * half * sizeof(double)) / (1e9 * seconds);
}

double nanoseconds_of_divisions(int divisions) {
  constexpr int lanes = 64, rounds = 100'000;
  std::array<double, lanes> x, y;
  x.fill(1.5);
  y.fill(1.25);
  const double seconds = best_seconds([&] {
    for (int round = 0; round < rounds; ++round) {
      for (int k = 0; k < lanes; ++k) x[k] = y[k] / x[k];
      use(x.data());
    }
  });
  return divisions * 1e9 * seconds / (static_cast<double>(rounds) * lanes);
}

double nanoseconds_of_operations(double operations) {
  // Twelve independent chains of whole registers, to fill the pipelines.
  typedef double Register __attribute__((vector_size(64)));
  constexpr int chains = 12, rounds = 20'000;
  Register x[chains] = {};
  const double seconds = best_seconds([&] {
    for (int round = 0; round < rounds; ++round)
      for (int c = 0; c < chains; ++c) x[c] = x[c] * 0.5;
    use(x);
  });
  return operations * 1e9 * seconds / (static_cast<double>(rounds) * chains * 8);
}

}  // namespace supple::bench
