#pragma once

#include <vector>

#include "incision/fem/assembly.h"

namespace incision {

/// Which copies are free, in the order in which the system numbers them, and which pairs of them a part couples. Every
/// row stands by itself, so a cut changes the rows beside it and shifts the others.
struct BlockPattern {
  std::vector<int> copies;     ///< copy of each row
  std::vector<int> row_of;     ///< row of each copy, −1 when it has none
  std::vector<int> row_start;  ///< blocks row_start[r] … row_start[r + 1] − 1 lie in row r
  std::vector<int> column;     ///< of each block, ascending in a row
  std::vector<int> diagonal;   ///< the block of each row on the diagonal

  /// For corners I and J of part p, slots[16 p + 4 I + J] says which block of the row of corner I couples it to corner
  /// J, counted from the row's first; −1 where corner J has no row. Without meaning where corner I has none.
  std::vector<int> slots;

  int rows() const { return static_cast<int>(copies.size()); }
};

/// Finds the pattern whose rows are the copies listed in `order`.
void findPattern(const Assembly& assembly, const std::vector<int>& order, BlockPattern* pattern);

/// The same where `pattern` is known from before the parts or copies round the nodes `touched` changed. Copies that had
/// a row and keep it must stand in `order` one after the other as before.
void editPattern(const Assembly& assembly, const std::vector<int>& order, const std::vector<int>& touched,
                 BlockPattern* pattern);

}  // namespace incision
