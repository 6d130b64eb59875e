#pragma once

#include <cstddef>
#include <vector>

namespace incision {

/// How many there are of what a memory numbers, in the body that it is of.
struct MemoryLimits {
  int nodes = 0, elements = 0, regions = 0;  ///< of the mesh as read
  int copies = 0, cracks = 0, pieces = 0;    ///< as cracks have left it
  int first_copies = 0;                      ///< those that were there at loading: the parent of another one is lower
  std::vector<int> element_of_part;

  int parts() const { return static_cast<int>(element_of_part.size()); }
};

/// Whether there is number `i` of so many.
inline bool isOneOf(int i, int count) { return 0 <= i && i < count; }

/// Throws InputError that a saved body cannot be, as what is said here does not hold.
void require(bool holds, const char* what);

// Beside the memory of each class there is `void check(const Memory& memory, const MemoryLimits& limits)`, which
// throws InputError where no body with these limits can have such a memory: where a list is too long or too short, a
// number names nothing, or a value is out of its range.

}  // namespace incision
