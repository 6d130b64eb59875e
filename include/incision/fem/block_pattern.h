#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "incision/fem/assembly.h"

namespace incision {

/// Which copies are free, in the order in which the system numbers them, and which pairs of them a part couples, or a
/// patch where the pressure is averaged. Every row stands by itself, so a cut changes the rows beside it and shifts the
/// others.
struct BlockPattern {
  std::vector<int> copies;     ///< copy of each row
  std::vector<int> row_of;     ///< row of each copy, −1 when it has none
  std::vector<int> row_start;  ///< blocks row_start[r] … row_start[r + 1] − 1 lie in row r
  std::vector<int> column;     ///< of each block, ascending in a row
  std::vector<int> diagonal;   ///< the block of each row on the diagonal

  /// For corners I and J of part p, slots[16 p + 4 I + J] says which block of the row of corner I couples it to corner
  /// J, counted from the row's first. NO_SLOT where corner J has no row, or where that is too far to be told; without
  /// meaning where corner I has no row.
  std::vector<std::uint16_t> slots;
  /// Of each pair of copies of a patch, as Patches counts them: which block of the first one's row couples it to the
  /// second, counted from the row's first. NO_SLOT where one of them has no row, or where that is too far to be told.
  std::vector<std::uint16_t> patch_slots;

  int rows() const { return static_cast<int>(copies.size()); }
  /// Where a column of a row stands, counted from the row's first.
  int slotIn(int row, int col) const {
    const auto begin = column.begin() + row_start[row], end = column.begin() + row_start[row + 1];
    return static_cast<int>(std::lower_bound(begin, end, col) - begin);
  }
};

inline constexpr std::uint16_t NO_SLOT = 65535;

/// Which block of a row couples it to corner J of a part, counted from the row's first; −1 where corner J has no row.
/// `corner` is the part's corner that the row is of.
inline int slotOf(const Assembly& assembly, const BlockPattern& pattern, int row, const Corner& corner, int J) {
  const std::uint16_t slot = pattern.slots[16 * static_cast<std::size_t>(corner.part) + 4 * corner.node + J];
  if (slot != NO_SLOT) return slot;
  const int column = pattern.row_of[assembly.mesh().parts()[corner.part].copies[J]];
  return column < 0 ? -1 : pattern.slotIn(row, column);
}

/// Which block of a row couples it to copy j of a patch, counted from the row's first; −1 where copy j has no row. Copy
/// i of the patch is the one that the row is of.
inline int patchSlotOf(const Patches& patches, const BlockPattern& pattern, int row, int patch, int i, int j) {
  const std::uint16_t slot = pattern.patch_slots[patches.pairStart(patch) + i * patches.numCopies(patch) + j];
  if (slot != NO_SLOT) return slot;
  const int column = pattern.row_of[patches.copies()[patch][j]];
  return column < 0 ? -1 : pattern.slotIn(row, column);
}

/// Finds the pattern whose rows are the copies listed in `order`.
void findPattern(const Assembly& assembly, const std::vector<int>& order, BlockPattern* pattern);

/// Finds the pattern whose rows are the copies listed in `order` from the one it was before the parts or copies round
/// the nodes `touched` changed. Copies that had a row and keep it must stand in `order` one after the other as before.
void editPattern(const Assembly& assembly, const std::vector<int>& order, const std::vector<int>& touched,
                 BlockPattern* pattern);

}  // namespace incision
