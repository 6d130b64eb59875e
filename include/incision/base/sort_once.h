#pragma once

#include <algorithm>
#include <vector>

namespace incision {

/// Sorts the values, and leaves one of those that are equal.
template <typename T>
void sortOnce(std::vector<T>* values) {
  std::sort(values->begin(), values->end());
  values->erase(std::unique(values->begin(), values->end()), values->end());
}

}  // namespace incision
