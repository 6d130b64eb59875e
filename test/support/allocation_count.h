#pragma once

// Counts what is taken from the heap, and refuses it where a test says so, by every thread of a program of which one
// file includes allocation_hooks.h.

#include <dlfcn.h>

#include <atomic>
#include <cstdint>
#include <cstring>
#include <limits>

namespace incision::test {

inline constexpr std::int64_t NEVER = std::numeric_limits<std::int64_t>::max();

inline std::atomic<std::int64_t> allocation_count{0};
/// Which are refused, by their numbers: from the first to before the last.
inline std::atomic<std::int64_t> first_refused{NEVER}, last_refused{NEVER};
inline std::atomic<std::int64_t> refused_count{0};

/// Whether a function is of a library that ends the process where it finds no memory, whoever calls it: that of the
/// threads of OpenMP, which CHOLMOD opens a team of for a moment, of 1.5 kB.
inline bool endsTheProcess(const void* caller) {
  Dl_info found;
  return dladdr(caller, &found) != 0 && std::strstr(found.dli_fname, "libgomp") != nullptr;
}

/// Counts one that was asked for by a function; whether it is refused.
inline bool refuses(const void* caller) {
  const std::int64_t number = allocation_count++;
  if (number < first_refused || number >= last_refused || endsTheProcess(caller)) return false;
  ++refused_count;
  return true;
}

/// Refuses some of what `f` takes from the heap: from the n-th on, counted from 1, so many of them. Returns how many
/// that were.
template <typename Function>
std::int64_t refusing(std::int64_t n, std::int64_t count, const Function& f) {
  const std::int64_t before = refused_count;
  last_refused = allocation_count + n - 1 + count;
  first_refused = allocation_count + n - 1;
  f();
  first_refused = last_refused = NEVER;
  return refused_count - before;
}

/// Within `refusing`, refuses nothing of what `f` takes.
template <typename Function>
void sparing(const Function& f) {
  const std::int64_t first = first_refused, last = last_refused;
  first_refused = last_refused = NEVER;
  f();
  last_refused = last;
  first_refused = first;
}

/// How often `f` takes memory from the heap.
template <typename Function>
std::int64_t allocationsOf(const Function& f) {
  const std::int64_t before = allocation_count;
  f();
  return allocation_count - before;
}

}  // namespace incision::test
