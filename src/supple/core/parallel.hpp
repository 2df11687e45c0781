/// Parallel loops over fixed chunks. Chunks do not depend on the number of threads, and sums add chunk after
/// chunk, so every result is the same, bit for bit, for any number of threads.
#pragma once
#include <cstdint>
#include <type_traits>
#include <vector>

namespace supple {

/// Number of threads for the loops that the calling thread runs; with 1 (the default) they run in it alone.
/// Every thread of a program has its own number, so that two may run experiments side by side.
inline int& thread_count() {
  static thread_local int count = 1;
  return count;
}

/// The calling thread has this many threads while this lives.
class WithThreads {
 public:
  explicit WithThreads(int count) : before_(thread_count()) { thread_count() = count; }
  ~WithThreads() { thread_count() = before_; }
  WithThreads(const WithThreads&) = delete;
  WithThreads& operator=(const WithThreads&) = delete;

 private:
  int before_;
};

/// Items in a chunk, and chunks of n items.
inline constexpr std::int64_t chunk_size = 256;
inline std::int64_t chunk_count(std::int64_t n) { return (n + chunk_size - 1) / chunk_size; }

/// Whether a loop over n runs its chunks in order in the calling thread, as there is too little to share.
inline bool runs_in_place(std::int64_t n) {
  return thread_count() == 1 || chunk_count(n) < 2 * thread_count();
}

/// Calls work(context, chunk) for each chunk of [0, chunks), shared with up to `threads` - 1 helper threads
/// that sleep between loops (docs/decisions/0013). The caller takes every chunk that no helper has begun, so
/// it never waits for a thread that the system has not let run. If chunks throw, the exception of the first
/// of them is thrown on after all chunks are done. A call from within a chunk runs in place. The helpers
/// belong to the calling thread and end with it.
void run_chunks(std::int64_t chunks, int threads, void (*work)(void*, std::int64_t), void* context);

/// body(part) for each of these parts, however large they are.
template <class Body>
void for_parts(std::int64_t parts, Body&& body) {
  if (thread_count() == 1 || parts < 2 * thread_count()) {
    for (std::int64_t p = 0; p < parts; ++p) body(p);
    return;
  }
  run_chunks(
      parts, thread_count(),
      [](void* b, std::int64_t p) { (*static_cast<std::remove_reference_t<Body>*>(b))(p); },
      const_cast<void*>(static_cast<const void*>(&body)));
}

/// body(chunk, begin, end) for each chunk of [0, n).
template <class Body>
void for_chunks(std::int64_t n, Body&& body) {
  for_parts(chunk_count(n), [&](std::int64_t c) {
    const std::int64_t end = (c + 1) * chunk_size;
    body(c, c * chunk_size, end < n ? end : n);
  });
}

/// body(k) for each k below thread_count(), each in a thread of its own if the system lets them run.
template <class Body>
void for_each_thread(Body&& body) {
  run_chunks(
      thread_count(), thread_count(),
      [](void* b, std::int64_t k) { (*static_cast<std::remove_reference_t<Body>*>(b))(k); },
      const_cast<void*>(static_cast<const void*>(&body)));
}

/// Sum over parts of body(part), added in the order of the parts. Sum must have +=.
template <class Sum, class Body>
Sum sum_parts(std::int64_t parts, Body&& body) {
  std::vector<Sum> sums(static_cast<std::size_t>(parts));
  for_parts(parts, [&](std::int64_t p) { sums[static_cast<std::size_t>(p)] = body(p); });
  Sum total{};
  for (const Sum& sum : sums) total += sum;
  return total;
}

/// Sum over chunks of body(begin, end), added in the order of the chunks.
template <class Sum, class Body>
Sum sum_chunks(std::int64_t n, Body&& body) {
  return sum_parts<Sum>(chunk_count(n), [&](std::int64_t c) {
    const std::int64_t end = (c + 1) * chunk_size;
    return body(c * chunk_size, end < n ? end : n);
  });
}

}  // namespace supple
