#include "incision/solver/aggregates.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace incision {
namespace {

/// Three copies in a line cannot tell a rotation about it; four rarely lie in one.
constexpr int MIN_SIZE = 4;

/// Up to this many nodes leaves have their least size.
constexpr double SMALL_BODY = 4000;
constexpr double LEAST_LEAF = 64;

class UnionFind {
 public:
  explicit UnionFind(int n) : link_(n) { std::iota(link_.begin(), link_.end(), 0); }
  int root(int i) {
    while (link_[i] != i) i = link_[i] = link_[link_[i]];
    return i;
  }
  void join(int a, int b) {
    if (link_[a] == link_[b]) return;
    a = root(a);
    b = root(b);
    link_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<int> link_;
};

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
void mergeSmall(const BlockPattern& pattern, UnionFind* groups) {
  std::vector<int> size(pattern.rows(), 0);
  for (int row = 0; row < pattern.rows(); ++row) ++size[groups->root(row)];
  for (int row = 0; row < pattern.rows(); ++row)
    for (int k = pattern.row_start[row]; k < pattern.row_start[row + 1] && size[groups->root(row)] < MIN_SIZE; ++k) {
      const int a = groups->root(row), b = groups->root(pattern.column[k]);
      if (a == b) continue;
      groups->join(a, b);
      size[groups->root(a)] = size[a] + size[b];
    }
}

}  // namespace

int leafSize(int nodes) { return static_cast<int>(LEAST_LEAF * std::cbrt(std::max(1.0, nodes / SMALL_BODY))); }

std::vector<int> orderCopies(const CutMesh& mesh, const NodeOrder& order, const std::vector<bool>& held) {
  // A counting sort by rank.
  std::vector<int> end(order.rank.size() + 1, 0);
  const auto rank = [&](int c) { return order.rank[mesh.copyNode(c)]; };
  for (int c = 0; c < mesh.numCopies(); ++c)
    if (!held[c]) ++end[rank(c) + 1];
  std::partial_sum(end.begin(), end.end(), end.begin());
  std::vector<int> copies(end.back());
  for (int c = 0; c < mesh.numCopies(); ++c)
    if (!held[c]) copies[end[rank(c)]++] = c;
  return copies;
}

Aggregates aggregate(const CutMesh& mesh, const NodeOrder& order, const BlockPattern& pattern) {
  const int rows = pattern.rows();
  UnionFind groups(rows);
  const std::vector<int> starts = leafStarts(mesh, order, pattern);
  for (std::size_t s = 0; s + 1 < starts.size(); ++s)
    for (int row = starts[s]; row < starts[s + 1]; ++row)
      for (int k = pattern.diagonal[row]; k < pattern.row_start[row + 1] && pattern.column[k] < starts[s + 1]; ++k)
        groups.join(row, pattern.column[k]);
  mergeSmall(pattern, &groups);

  Aggregates result;
  std::vector<int> number(rows, -1);
  result.of.resize(rows);
  result.start.assign(1, 0);
  for (int row = 0; row < rows; ++row) {
    int& n = number[groups.root(row)];
    if (n < 0) {
      n = result.count();
      result.start.push_back(0);
    }
    result.of[row] = n;
    ++result.start[n + 1];
  }
  std::partial_sum(result.start.begin(), result.start.end(), result.start.begin());
  result.rows.resize(rows);
  std::vector<int> end(result.start.begin(), result.start.end() - 1);
  for (int row = 0; row < rows; ++row) result.rows[end[result.of[row]]++] = row;
  return result;
}

}  // namespace incision
