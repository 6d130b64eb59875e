#pragma once

#include <mutex>

namespace incision {

/// Solvers of several bodies may work at once, on threads of their own, but two libraries beneath them have state of
/// the whole process. While what these return lives, no other solver is in that library.

/// For whatever calls BLAS. OpenBLAS without threads hands the same scratch memory to all who call it at once; with any
/// other BLAS nobody waits, as others keep callers apart by themselves.
std::unique_lock<std::mutex> turnAtBlas();

/// For whatever orders by METIS. It draws from rand(), which it seeds at each start: together two would draw other
/// numbers than alone, and order otherwise.
std::unique_lock<std::mutex> turnAtMetis();

}  // namespace incision
