#pragma once

#include <vector>

namespace incision {

/// Calls f(i) for i = 0 … n − 1 on `threads` threads. Every index is computed alone, so results do not depend on how
/// many threads there are.
template <typename Function>
void parallelFor(int n, int threads, const Function& f) {
#pragma omp parallel for num_threads(threads) schedule(static) if (threads > 1)
  for (int i = 0; i < n; ++i) f(i);
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
