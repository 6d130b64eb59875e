#pragma once

// Replaces the C library's functions that take memory from the heap by such that count or refuse it, then do the same:
// for one file of a program. The sanitizers replace them too, so under these it is only what C++ takes by `new`.

#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <new>

#include "support/allocation_count.h"

#ifdef INCISION_SANITIZE

void* operator new(std::size_t size) {
  void* const memory = incision::test::refuses(__builtin_return_address(0)) ? nullptr : std::malloc(size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return incision::test::refuses(__builtin_return_address(0)) ? nullptr : std::malloc(size);
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

#else

extern "C" {

// glibc's own, under the names it keeps for this purpose.
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

void* incision_refused() noexcept {
  errno = ENOMEM;
  return nullptr;
}

void* malloc(std::size_t size) noexcept {
  return incision::test::refuses(__builtin_return_address(0)) ? incision_refused() : __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) noexcept {
  return incision::test::refuses(__builtin_return_address(0)) ? incision_refused() : __libc_calloc(count, size);
}

void* realloc(void* old, std::size_t size) noexcept {
  return incision::test::refuses(__builtin_return_address(0)) ? incision_refused() : __libc_realloc(old, size);
}

void* memalign(std::size_t alignment, std::size_t size) noexcept {
  return incision::test::refuses(__builtin_return_address(0)) ? incision_refused() : __libc_memalign(alignment, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  return incision::test::refuses(__builtin_return_address(0)) ? incision_refused() : __libc_memalign(alignment, size);
}

int posix_memalign(void** result, std::size_t alignment, std::size_t size) noexcept {
  void* const memory = memalign(alignment, size);
  if (memory == nullptr) return ENOMEM;
  *result = memory;
  return 0;
}

}  // extern "C"

#endif
