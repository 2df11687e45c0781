#include "supple/core/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <limits>
#include <memory>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

namespace supple {

namespace {

/// How long a thread looks for its next loop before it sleeps: about as long as waking it takes.
constexpr std::chrono::microseconds patience{20};

void relax() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#endif
}

/// Returns when `value` is no longer `old`: after looking for a while, asleep.
void wait_while(const std::atomic<int>& value, int old) {
  const auto begin = std::chrono::steady_clock::now();
  do {
    for (int i = 0; i < 16; ++i) {
      if (value.load(std::memory_order_acquire) != old) return;
      relax();
    }
  } while (std::chrono::steady_clock::now() - begin < patience);
  value.wait(old);
}

/// Part of the chunks, which one thread begins with and the others help to finish.
struct alignas(64) Share {
  std::atomic<std::int64_t> next{0};
  std::int64_t end = 0;
};

/// The threads that help one thread with its loops.
class Pool {
 public:
  ~Pool() {
    closing_ = true;
    announce();
    for (std::thread& t : helpers_) t.join();
  }

  void run(std::int64_t chunks, int threads, void (*work)(void*, std::int64_t), void* context) {
    if (busy_) {
      for (std::int64_t c = 0; c < chunks; ++c) work(context, c);
      return;
    }
    prepare(chunks, threads, work, context);
    busy_ = true;
    open_ = true;
    announce();
    take_part(0);
    open_ = false;
    for (int inside; (inside = inside_.load(std::memory_order_acquire)) != 0;) wait_while(inside_, inside);
    busy_ = false;
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
  }

 private:
  /// No helper is inside, and none gets in before the loop is open.
  void prepare(std::int64_t chunks, int threads, void (*work)(void*, std::int64_t), void* context) {
    hire(threads - 1);
    if (threads > capacity_) {
      shares_ = std::make_unique<Share[]>(static_cast<std::size_t>(threads));
      capacity_ = threads;
    }
    threads_ = threads;
    for (int i = 0; i < threads; ++i) {
      shares_[i].next.store(chunks * i / threads, std::memory_order_relaxed);
      shares_[i].end = chunks * (i + 1) / threads;
    }
    work_ = work;
    context_ = context;
    failed_chunk_ = std::numeric_limits<std::int64_t>::max();
  }

  /// Where the system refuses a thread the others do its work.
  void hire(int helpers) {
    try {
      while (static_cast<int>(helpers_.size()) < helpers)
        helpers_.emplace_back([this, id = static_cast<int>(helpers_.size()) + 1] { help(id); });
    } catch (const std::system_error&) {
    }
  }

  void announce() {
    ++epoch_;
    epoch_.notify_all();
  }

  /// A helper counts itself in before it looks whether the loop is open, and the caller closes the loop
  /// before it looks who is in: one of the two sees the other.
  void help(int id) {
    int seen = 0;
    while (!closing_) {
      wait_while(epoch_, seen);
      seen = epoch_;
      ++inside_;
      if (open_ && id < threads_) take_part(id);
      if (--inside_ == 0) inside_.notify_all();
    }
  }

  void take_part(int id) {
    for (int k = 0; k < threads_; ++k) {
      Share& share = shares_[(id + k) % threads_];
      for (std::int64_t c; (c = share.next.fetch_add(1, std::memory_order_relaxed)) < share.end;) do_chunk(c);
    }
  }

  void do_chunk(std::int64_t chunk) {
    try {
      work_(context_, chunk);
    } catch (...) {
      const std::lock_guard lock(failing_);
      if (chunk >= failed_chunk_) return;
      failed_chunk_ = chunk;
      failure_ = std::current_exception();
    }
  }

  bool busy_ = false;  ///< of the thread that this helps, which alone asks
  std::mutex failing_;
  std::atomic<int> epoch_{0}, inside_{0};
  std::atomic<bool> open_{false}, closing_{false};
  std::unique_ptr<Share[]> shares_;
  int capacity_ = 0, threads_ = 0;
  void (*work_)(void*, std::int64_t) = nullptr;
  void* context_ = nullptr;
  std::int64_t failed_chunk_ = 0;
  std::exception_ptr failure_;
  std::vector<std::thread> helpers_;
};

}  // namespace

void run_chunks(std::int64_t chunks, int threads, void (*work)(void*, std::int64_t), void* context) {
  static thread_local Pool pool;
  pool.run(chunks, threads, work, context);
}

}  // namespace supple
