#include "benchmark/triad.h"

#include <algorithm>
#include <chrono>
#include <vector>

#include "incision/base/parallel.h"

namespace incision::bench {
namespace {

constexpr int ENTRIES = 1 << 24;  // 128 MiB an array
constexpr int CHUNKS = 64, RUNS = 10;

}  // namespace

double triadBandwidth(int threads) {
  std::vector<double> a(ENTRIES, 0), b(ENTRIES, 1), c(ENTRIES, 2);
  double best = 0;
  for (int run = 0; run < RUNS; ++run) {
    const auto start = std::chrono::steady_clock::now();
    parallelFor(CHUNKS, threads, [&](int chunk) {
      for (int i = ENTRIES / CHUNKS * chunk; i < ENTRIES / CHUNKS * (chunk + 1); ++i) a[i] = b[i] + 3 * c[i];
    });
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    best = std::max(best, 24.0 * ENTRIES / seconds);
  }
  return best;
}

}  // namespace incision::bench
