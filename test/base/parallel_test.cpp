#include "incision/base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <new>
#include <thread>
#include <vector>

namespace incision {
namespace {

TEST(ParallelFor, CallsEveryIndexOnceForAnyCountOfThreads) {
  for (int round = 0; round < 500; ++round) {
    std::vector<int> calls(1 + 37 * round % 1001, 0);
    parallelFor(static_cast<int>(calls.size()), 1 + round % 5, [&](int i) { ++calls[i]; });
    for (int count : calls) ASSERT_EQ(count, 1);
  }
}

TEST(ParallelSum, HasTheSameBitsForAnyCountOfThreads) {
  std::vector<double> terms;
  const auto term = [](int i) { return 1.0 / (3 + i); };
  const double serial = parallelSum(10007, 1, &terms, term);
  for (int threads = 2; threads <= 5; ++threads) EXPECT_EQ(parallelSum(10007, threads, &terms, term), serial);
}

TEST(ParallelFor, ServesSeveralCallersAtOnce) {
  const auto work = [] {
    for (int round = 0; round < 200; ++round) {
      std::vector<int> calls(300, 0);
      parallelFor(300, 2, [&](int i) { ++calls[i]; });
      for (int count : calls) ASSERT_EQ(count, 1);
    }
  };
  std::thread other(work);
  work();
  other.join();
}

TEST(ParallelFor, ThrowsWhatAnIndexThrowsWhenNobodyIsAtWorkAnyMore) {
  for (int round = 0; round < 500; ++round) {
    std::atomic<int> at_work = 0;
    std::vector<int> calls(300, 0);
    const auto call = [&](int i) {
      ++at_work;
      ++calls[i];
      --at_work;
      if (i % 100 == round % 100) throw std::bad_alloc();
    };
    EXPECT_THROW(parallelFor(300, 1 + round % 4, call), std::bad_alloc);
    EXPECT_EQ(at_work, 0);
    parallelFor(300, 1 + round % 4, [&](int i) { calls[i] = 1; });
    for (int count : calls) ASSERT_EQ(count, 1);
  }
}

}  // namespace
}  // namespace incision
