#include "incision/solver/aggregates.h"

#include <algorithm>
#include <cmath>

#include "incision/base/disjoint_sets.h"

namespace incision {
namespace {

/// Three copies in a line cannot tell a rotation about it; four rarely lie in one.
constexpr int MIN_SIZE = 4;

/// Up to this many nodes leaves have their least size.
constexpr double SMALL_BODY = 4000;
constexpr double LEAST_LEAF = 64;

/// Where the ranges of rows begin that share a leaf, those of more than two leaves' worth of copies halved.
std::vector<int> leafStarts(const CutMesh& mesh, const NodeOrder& order, const BlockPattern& pattern) {
  const auto leaf = [&](int row) { return order.leaf[mesh.copyNode(pattern.copies[row])]; };
  std::vector<int> starts;
  for (int begin = 0, end = 0; begin < pattern.rows(); begin = end) {
    while (end < pattern.rows() && leaf(end) == leaf(begin)) ++end;
    const int most = 2 * order.leaf_size, shares = (end - begin + most - 1) / most;
    for (int k = 0; k < shares; ++k) starts.push_back(begin + (end - begin) * k / shares);
  }
  starts.push_back(pattern.rows());
  return starts;
}

/// Joins groups below MIN_SIZE to one that a block connects them to.
void mergeSmall(const BlockPattern& pattern, DisjointSets* groups) {
  std::vector<int> size(pattern.rows(), 0);  // of the group that has the row for its lowest
  for (int row = 0; row < pattern.rows(); ++row) ++size[groups->lowest(row)];
  for (int row = 0; row < pattern.rows(); ++row)
    for (int k = pattern.row_start[row]; k < pattern.row_start[row + 1] && size[groups->lowest(row)] < MIN_SIZE; ++k) {
      const int a = groups->lowest(row), b = groups->lowest(pattern.column[k]);
      if (groups->join(a, b)) size[std::min(a, b)] = size[a] + size[b];
    }
}

}  // namespace

int leafSize(int nodes) { return static_cast<int>(LEAST_LEAF * std::cbrt(std::max(1.0, nodes / SMALL_BODY))); }

std::vector<int> orderCopies(const CutMesh& mesh, const NodeOrder& order, const std::vector<bool>& left_out) {
  Lists<int> by_rank;
  by_rank.sort(static_cast<int>(order.rank.size()), [&](const auto& add) {
    for (int c = 0; c < mesh.numCopies(); ++c)
      if (!left_out[c]) add(order.rank[mesh.copyNode(c)], c);
  });
  return by_rank.values();
}

Aggregates aggregate(const CutMesh& mesh, const NodeOrder& order, const BlockPattern& pattern) {
  const int rows = pattern.rows();
  DisjointSets groups(rows);
  const std::vector<int> starts = leafStarts(mesh, order, pattern);
  for (std::size_t s = 0; s + 1 < starts.size(); ++s)
    for (int row = starts[s]; row < starts[s + 1]; ++row)
      for (int k = pattern.diagonal[row]; k < pattern.row_start[row + 1] && pattern.column[k] < starts[s + 1]; ++k)
        groups.join(row, pattern.column[k]);
  mergeSmall(pattern, &groups);

  Aggregates result;
  const int count = groups.enumerate(&result.of);
  result.rows = sortedByList(result.of, count);
  return result;
}

}  // namespace incision
