#include "incision/fem/block_pattern.h"

#include <algorithm>
#include <numeric>

#include "incision/base/parallel.h"

namespace incision {
namespace {

/// Calls f(corner, J, column) for all that the parts round a copy couple it to; column −1 where J has no row.
template <typename Function>
void forEachSpring(const Assembly& assembly, const std::vector<int>& row_of, int copy, const Function& f) {
  for (const Corner& corner : assembly.corners()[copy]) {
    const Part& part = assembly.mesh().parts()[corner.part];
    for (int J = 0; J < 4; ++J) f(corner, J, row_of[part.copies[J]]);
  }
}

/// Calls f(column) for all that the parts round a copy couple it to, or the patches where the pressure is averaged; a
/// column may come again, and is −1 for a copy that has no row.
template <typename Function>
void forEachNeighbour(const Assembly& assembly, const std::vector<int>& row_of, int copy, const Function& f) {
  const Patches* patches = assembly.patches();
  if (!patches) return forEachSpring(assembly, row_of, copy, [&](const Corner&, int, int column) { f(column); });
  for (const Patches::Use& use : patches->uses()[copy])
    for (int other : patches->copies()[use.patch]) f(row_of[other]);
}

/// How often forEachNeighbour calls f.
int countNeighbours(const Assembly& assembly, int copy) {
  const Patches* patches = assembly.patches();
  if (!patches) return 4 * assembly.corners()[copy].size();
  int count = 0;
  for (const Patches::Use& use : patches->uses()[copy]) count += patches->numCopies(use.patch);
  return count;
}

/// A table over the rows, one for each thread, that lives on: it is filled anew, where it is read, for every row.
std::vector<int>& tableOfRows(int rows) {
  thread_local std::vector<int> table;
  if (static_cast<int>(table.size()) < rows) table.resize(rows, -1);
  return table;
}

/// Rows of the new pattern that cannot be taken from the old one: beside a touched node, or beside a copy that has
/// gained or lost its row.
std::vector<char> staleRows(const Assembly& assembly, const std::vector<int>& touched, const BlockPattern& old,
                            const std::vector<int>& order, const std::vector<int>& row_of) {
  std::vector<char> touched_node(assembly.mesh().mesh().nodes.size(), 0), stale(order.size(), 0);
  for (int node : assembly.patches() ? assembly.patches()->nodesBeside(touched) : touched) touched_node[node] = 1;
  for (std::size_t r = 0; r < order.size(); ++r) {
    const int copy = order[r];
    const bool is_new = copy >= static_cast<int>(old.row_of.size()) || old.row_of[copy] < 0;
    if (!is_new && !touched_node[assembly.mesh().copyNode(copy)]) continue;
    stale[r] = 1;
    if (is_new)
      forEachNeighbour(assembly, row_of, copy, [&](int column) {
        if (column >= 0) stale[column] = 1;
      });
  }
  for (int r = 0; r < old.rows(); ++r) {
    if (row_of[old.copies[r]] >= 0) continue;
    for (int k = old.row_start[r]; k < old.row_start[r + 1]; ++k)
      if (const int row = row_of[old.copies[old.column[k]]]; row >= 0) stale[row] = 1;
  }
  return stale;
}

/// The columns of the stale rows, one after the other: row r's stand from start[r] on.
struct Columns {
  std::vector<int> start, count, values;
};

Columns findColumns(const Assembly& assembly, const BlockPattern& pattern, const std::vector<char>& stale) {
  Columns found;
  found.start.resize(pattern.rows());
  found.count.assign(pattern.rows(), 0);
  int room = 0;
  for (int row = 0; row < pattern.rows(); ++row) {
    found.start[row] = room;
    if (stale[row]) room += countNeighbours(assembly, pattern.copies[row]);
  }
  found.values.resize(room);
  parallelFor(pattern.rows(), assembly.threads(), [&](int row) {
    if (!stale[row]) return;
    std::vector<int>& seen_by = tableOfRows(pattern.rows());
    int *const columns = found.values.data() + found.start[row], *end = columns;
    const int copy = pattern.copies[row];
    forEachNeighbour(assembly, pattern.row_of, copy, [&](int column) {
      if (column >= 0) seen_by[column] = -1;
    });
    forEachNeighbour(assembly, pattern.row_of, copy, [&](int column) {
      if (column < 0 || seen_by[column] == row) return;
      seen_by[column] = row;
      *end++ = column;
    });
    std::sort(columns, end);
    found.count[row] = static_cast<int>(end - columns);
  });
  return found;
}

void findSlots(const Assembly& assembly, int row, BlockPattern* pattern) {
  std::vector<int>& slot_of = tableOfRows(pattern->rows());
  for (int k = pattern->row_start[row]; k < pattern->row_start[row + 1]; ++k)
    slot_of[pattern->column[k]] = k - pattern->row_start[row];
  forEachSpring(assembly, pattern->row_of, pattern->copies[row], [&](const Corner& corner, int J, int column) {
    const int slot = column < 0 ? NO_SLOT : std::min<int>(slot_of[column], NO_SLOT);
    pattern->slots[16 * static_cast<std::size_t>(corner.part) + 4 * corner.node + J] = static_cast<std::uint16_t>(slot);
  });
}

void findPatchSlots(const Assembly& assembly, BlockPattern* pattern) {
  const Patches& patches = *assembly.patches();
  pattern->patch_slots.resize(patches.pairStart(patches.count()));
  parallelFor(patches.count(), assembly.threads(), [&](int a) {
    auto slot = pattern->patch_slots.begin() + static_cast<std::ptrdiff_t>(patches.pairStart(a));
    for (int i : patches.copies()[a])
      for (int j : patches.copies()[a]) {
        const int row = pattern->row_of[i], column = pattern->row_of[j];
        *slot++ = static_cast<std::uint16_t>(
            row < 0 || column < 0 ? NO_SLOT : std::min<int>(pattern->slotIn(row, column), NO_SLOT));
      }
  });
}

}  // namespace

void findPattern(const Assembly& assembly, const std::vector<int>& order, BlockPattern* pattern) {
  *pattern = BlockPattern();
  editPattern(assembly, order, {}, pattern);
}

void editPattern(const Assembly& assembly, const std::vector<int>& order, const std::vector<int>& touched,
                 BlockPattern* pattern) {
  BlockPattern old;
  std::swap(old, *pattern);
  pattern->copies = order;
  pattern->row_of.assign(assembly.mesh().numCopies(), -1);
  for (std::size_t r = 0; r < order.size(); ++r) pattern->row_of[order[r]] = static_cast<int>(r);
  const std::vector<char> stale = staleRows(assembly, touched, old, order, pattern->row_of);
  const Columns found = findColumns(assembly, *pattern, stale);

  const int rows = pattern->rows();
  pattern->row_start.resize(rows + 1);
  pattern->row_start[0] = 0;
  for (int row = 0; row < rows; ++row) {
    const int old_row = stale[row] ? -1 : old.row_of[order[row]];
    const int count = stale[row] ? found.count[row] : old.row_start[old_row + 1] - old.row_start[old_row];
    pattern->row_start[row + 1] = pattern->row_start[row] + count;
  }
  pattern->column.resize(pattern->row_start.back());
  pattern->diagonal.resize(rows);
  pattern->slots = std::move(old.slots);
  const std::size_t slots = 16 * assembly.mesh().parts().size();
  if (pattern->slots.capacity() < slots) pattern->slots.reserve(slots + slots / 4);  // room for the next cuts
  pattern->slots.resize(slots);
  parallelFor(rows, assembly.threads(), [&](int row) {
    const auto begin = pattern->column.begin() + pattern->row_start[row];
    const auto end = pattern->column.begin() + pattern->row_start[row + 1];
    if (stale[row]) {
      std::copy_n(found.values.begin() + found.start[row], found.count[row], begin);
      findSlots(assembly, row, pattern);
    } else {
      const int* old_column = &old.column[old.row_start[old.row_of[order[row]]]];
      std::transform(begin, end, begin, [&](int) { return pattern->row_of[old.copies[*old_column++]]; });
    }
    pattern->diagonal[row] = static_cast<int>(std::lower_bound(begin, end, row) - pattern->column.begin());
  });
  if (assembly.patches()) findPatchSlots(assembly, pattern);
}

}  // namespace incision
