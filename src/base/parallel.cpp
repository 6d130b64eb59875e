#include "incision/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace incision {
namespace detail {
namespace {

/// Ranges for each thread: more even out threads that started late, fewer cost less to hand out.
constexpr int RANGES_PER_THREAD = 4;

/// How long a thread without work looks for more before it sleeps: the serial stretches within a step are shorter.
constexpr std::chrono::microseconds PATIENCE(100);

/// Looks between two glances at the clock.
constexpr int LOOKS = 64;

void relax() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#elif defined(__aarch64__)
  __asm__ volatile("yield");
#endif
}

/// Threads that take ranges of one job at a time. What is left to take stands in one word, `ticket_`: the job's number,
/// how many ranges it has, and the next to take. A range is taken by raising that word from the value that was read, so
/// a thread that slept through a job cannot take a range of it, and whoever took one finds the job's data unchanged
/// until it is counted as finished.
class Pool {
 public:
  ~Pool() {
    {
      const std::lock_guard<std::mutex> lock(sleep_);
      stop_ = true;
    }
    wake_.notify_all();
    for (std::thread& worker : workers_) worker.join();
  }

  void run(int n, int threads, void (*f)(const void*, int, int), const void* context) {
    const std::unique_lock<std::mutex> only(one_job_, std::try_to_lock);
    if (threads <= 1 || n < 2 || !only) return f(context, 0, n);
    hire(threads - 1);
    const int ranges = std::min(n, RANGES_PER_THREAD * threads);
    f_ = f;
    context_ = context;
    n_ = n;
    error_ = nullptr;
    finished_.store(0, std::memory_order_relaxed);
    ++job_;
    ticket_.store(ticket(job_, ranges, 0), std::memory_order_seq_cst);
    if (sleeping_.load(std::memory_order_seq_cst) > 0) {
      { const std::lock_guard<std::mutex> lock(sleep_); }
      wake_.notify_all();
    }
    while (takeRange()) {
    }
    for (int look = 1; finished_.load(std::memory_order_acquire) < ranges; ++look) {
      relax();
      if (look % LOOKS == 0) std::this_thread::yield();
    }
    if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
  }

 private:
  static constexpr int BITS = 16;
  static constexpr std::uint64_t MASK = (1u << BITS) - 1;

  static std::uint64_t ticket(std::uint64_t job, int ranges, int next) {
    return job << 2 * BITS | static_cast<std::uint64_t>(ranges) << BITS | static_cast<std::uint64_t>(next);
  }

  /// Where the system has no thread to give, those that there are do the work.
  void hire(int workers) {
    try {
      while (static_cast<int>(workers_.size()) < workers) workers_.emplace_back([this] { work(); });
    } catch (const std::exception&) {
    }
  }

  /// What a range throws reaches the caller, once nobody uses its data any more.
  void runRange(int begin, int end) {
    try {
      f_(context_, begin, end);
    } catch (...) {
      const std::lock_guard<std::mutex> lock(errors_);
      if (!error_) error_ = std::current_exception();
    }
  }

  bool takeRange() {
    std::uint64_t seen = ticket_.load(std::memory_order_acquire);
    for (;;) {
      const int ranges = static_cast<int>(seen >> BITS & MASK), next = static_cast<int>(seen & MASK);
      if (next >= ranges) return false;
      if (!ticket_.compare_exchange_weak(seen, seen + 1, std::memory_order_acq_rel, std::memory_order_acquire))
        continue;
      const auto bound = [&](int k) { return static_cast<int>(static_cast<std::int64_t>(n_) * k / ranges); };
      runRange(bound(next), bound(next + 1));
      finished_.fetch_add(1, std::memory_order_release);
      return true;
    }
  }

  bool workToTake() const {
    const std::uint64_t seen = ticket_.load(std::memory_order_seq_cst);
    return (seen & MASK) < (seen >> BITS & MASK);
  }

  void work() {
    while (!stop_.load(std::memory_order_relaxed)) {
      while (takeRange()) {
      }
      const auto until = std::chrono::steady_clock::now() + PATIENCE;
      while (!workToTake() && std::chrono::steady_clock::now() < until)
        for (int look = 0; look < LOOKS && !workToTake(); ++look) relax();
      if (workToTake()) continue;
      std::unique_lock<std::mutex> lock(sleep_);
      sleeping_.fetch_add(1, std::memory_order_seq_cst);
      wake_.wait(lock, [this] { return stop_.load(std::memory_order_relaxed) || workToTake(); });
      sleeping_.fetch_sub(1, std::memory_order_relaxed);
    }
  }

  std::mutex one_job_;
  std::vector<std::thread> workers_;
  void (*f_)(const void*, int, int) = nullptr;
  const void* context_ = nullptr;
  int n_ = 0;
  std::uint64_t job_ = 0;
  std::atomic<std::uint64_t> ticket_{0};
  std::atomic<int> finished_{0}, sleeping_{0};
  std::atomic<bool> stop_{false};
  std::mutex errors_;
  std::exception_ptr error_;  // the first of the job
  std::mutex sleep_;
  std::condition_variable wake_;
};

}  // namespace

void runRanges(int n, int threads, void (*run)(const void*, int, int), const void* context) {
  static Pool pool;
  pool.run(n, threads, run, context);
}

}  // namespace detail
}  // namespace incision
