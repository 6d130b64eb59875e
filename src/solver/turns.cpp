#include "turns.h"

#include <cstdlib>
#include <memory>
#include <new>

/// OpenBLAS says so how it was built: 0 is without threads. Other libraries have no such function.
extern "C" __attribute__((weak)) int openblas_get_parallel();
extern "C" __attribute__((weak)) void dpotrf_(const char* triangle, const int* rows, double* matrix, const int* stride,
                                              int* info);

namespace incision {
namespace {

bool isOpenBlasWithoutThreads() { return openblas_get_parallel && openblas_get_parallel() == 0; }

/// OpenBLAS takes scratch memory at its first call, keeps it, and where there is none asks again and again, forever: so
/// that call is made where it is known that there is some. Throws std::bad_alloc otherwise.
bool takeScratch() {
  constexpr std::size_t SCRATCH = std::size_t{136} << 20;  // 128 MiB on x86-64, by OpenBLAS 0.3.21, and some more
  if (!openblas_get_parallel || !dpotrf_) return false;
  if (!std::unique_ptr<void, decltype(&std::free)>(std::malloc(SCRATCH), &std::free)) throw std::bad_alloc();
  const int one = 1;
  double matrix = 1;
  int info = 0;
  dpotrf_("L", &one, &matrix, &one, &info);
  return true;
}

}  // namespace

std::unique_lock<std::mutex> turnAtBlas() {
  [[maybe_unused]] static const bool took_scratch = takeScratch();
  static const bool one_at_a_time = isOpenBlasWithoutThreads();
  static std::mutex mutex;
  return one_at_a_time ? std::unique_lock<std::mutex>(mutex) : std::unique_lock<std::mutex>();
}

std::unique_lock<std::mutex> turnAtMetis() {
  static std::mutex mutex;
  return std::unique_lock<std::mutex>(mutex);
}

}  // namespace incision
