#pragma once

#include <vector>

namespace incision {

namespace detail {
/// Calls run(context, begin, end) for consecutive ranges that cover 0 … n − 1, on up to `threads` threads.
void runRanges(int n, int threads, void (*run)(const void* context, int begin, int end), const void* context);
}  // namespace detail

/// Calls f(i) for i = 0 … n − 1 on up to `threads` threads. Every index is computed alone, so results do not depend on
/// how many threads there are. The caller works too and never waits for a thread that has not begun: where other
/// programs keep the processors busy this is no slower than one thread. f must not call parallelFor. Of what f throws
/// one exception is thrown on, after all other indices or the rest of their ranges.
template <typename Function>
void parallelFor(int n, int threads, const Function& f) {
  detail::runRanges(
      n, threads,
      [](const void* context, int begin, int end) {
        const Function& function = *static_cast<const Function*>(context);
        for (int i = begin; i < end; ++i) function(i);
      },
      &f);
}

/// Σ f(i), added up in the order of i whatever the count of threads. `terms` is scratch that keeps its memory.
template <typename Function>
double parallelSum(int n, int threads, std::vector<double>* terms, const Function& f) {
  terms->resize(n);
  parallelFor(n, threads, [&](int i) { (*terms)[i] = f(i); });
  double sum = 0;
  for (double term : *terms) sum += term;
  return sum;
}

}  // namespace incision
