#pragma once

// Counts what is taken from the heap, by every thread of the program that includes this in one of its files: this
// replaces the C library's functions by such that count, then do the same. The sanitizers replace them too, so under
// these nothing is counted.

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdint>

#include "support/sanitized.h"

namespace incision::test {

inline std::atomic<std::int64_t> allocation_count{0};

/// How often `f` takes memory from the heap.
template <typename Function>
std::int64_t allocationsOf(const Function& f) {
  const std::int64_t before = allocation_count;
  f();
  return allocation_count - before;
}

}  // namespace incision::test

#ifndef INCISION_SANITIZE

extern "C" {

// glibc's own, under the names it keeps for this purpose.
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

void* malloc(std::size_t size) noexcept {
  ++incision::test::allocation_count;
  return __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) noexcept {
  ++incision::test::allocation_count;
  return __libc_calloc(count, size);
}

void* realloc(void* old, std::size_t size) noexcept {
  ++incision::test::allocation_count;
  return __libc_realloc(old, size);
}

void* memalign(std::size_t alignment, std::size_t size) noexcept {
  ++incision::test::allocation_count;
  return __libc_memalign(alignment, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  ++incision::test::allocation_count;
  return __libc_memalign(alignment, size);
}

int posix_memalign(void** result, std::size_t alignment, std::size_t size) noexcept {
  ++incision::test::allocation_count;
  void* const memory = __libc_memalign(alignment, size);
  if (memory == nullptr) return ENOMEM;
  *result = memory;
  return 0;
}

}  // extern "C"

#endif
