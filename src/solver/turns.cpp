#include "turns.h"

/// OpenBLAS says so how it was built: 0 is without threads. Other libraries have no such function.
extern "C" __attribute__((weak)) int openblas_get_parallel();

namespace incision {
namespace {

bool isOpenBlasWithoutThreads() { return openblas_get_parallel && openblas_get_parallel() == 0; }

}  // namespace

std::unique_lock<std::mutex> turnAtBlas() {
  static const bool one_at_a_time = isOpenBlasWithoutThreads();
  static std::mutex mutex;
  return one_at_a_time ? std::unique_lock<std::mutex>(mutex) : std::unique_lock<std::mutex>();
}

std::unique_lock<std::mutex> turnAtMetis() {
  static std::mutex mutex;
  return std::unique_lock<std::mutex>(mutex);
}

}  // namespace incision
