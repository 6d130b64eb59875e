#include "incision/solver/aggregates.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

namespace incision {
namespace {

/// Smaller groups make the coarse matrix dear (three times the step at 20k nodes with 8), larger ones the iterations
/// many (twice with 512).
constexpr int TARGET_SIZE = 64;

/// Three copies in a line cannot tell a rotation about it; four rarely lie in one.
constexpr int MIN_SIZE = 4;

/// Numbers the leaves of a recursive bisection of copies[begin … end) across its longest side.
void bisect(const CutMesh& mesh, std::vector<int>* copies, int begin, int end, std::vector<int>* leaf, int* leaves) {
  const auto X = [&](int c) -> const Vec3& { return mesh.mesh().nodes[mesh.copyNode(c)]; };
  const int groups = (end - begin + TARGET_SIZE - 1) / TARGET_SIZE;
  if (groups <= 1) {
    for (int i = begin; i < end; ++i) (*leaf)[(*copies)[i]] = *leaves;
    ++*leaves;
    return;
  }
  Eigen::AlignedBox3d box;
  for (int i = begin; i < end; ++i) box.extend(X((*copies)[i]));
  int axis;
  box.sizes().maxCoeff(&axis);
  const int middle = begin + static_cast<int>(static_cast<long>(end - begin) * (groups / 2) / groups);
  std::nth_element(copies->begin() + begin, copies->begin() + middle, copies->begin() + end,
                   [&](int a, int b) { return X(a)[axis] != X(b)[axis] ? X(a)[axis] < X(b)[axis] : a < b; });
  bisect(mesh, copies, begin, middle, leaf, leaves);
  bisect(mesh, copies, middle, end, leaf, leaves);
}

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

/// Joins groups below MIN_SIZE to one they share a part with.
void mergeSmall(const CutMesh& mesh, const std::vector<bool>& held, UnionFind* groups) {
  std::vector<int> size(mesh.numCopies(), 0);
  for (int c = 0; c < mesh.numCopies(); ++c) ++size[groups->root(c)];
  for (const Part& part : mesh.parts())
    for (int I = 1; I < 4; ++I) {
      if (held[part.copies[0]] || held[part.copies[I]]) continue;
      const int a = groups->root(part.copies[0]), b = groups->root(part.copies[I]);
      if (a == b || (size[a] >= MIN_SIZE && size[b] >= MIN_SIZE)) continue;
      groups->join(a, b);
      size[groups->root(a)] = size[a] + size[b];
    }
}

}  // namespace

Aggregates aggregate(const CutMesh& mesh, const std::vector<bool>& held) {
  std::vector<int> copies, leaf(mesh.numCopies(), -1);
  for (int c = 0; c < mesh.numCopies(); ++c)
    if (!held[c]) copies.push_back(c);
  int leaves = 0;
  bisect(mesh, &copies, 0, static_cast<int>(copies.size()), &leaf, &leaves);

  UnionFind groups(mesh.numCopies());
  for (const Part& part : mesh.parts())
    for (int I = 0; I < 4; ++I)
      for (int J = I + 1; J < 4; ++J)
        if (!held[part.copies[I]] && leaf[part.copies[I]] == leaf[part.copies[J]])
          groups.join(part.copies[I], part.copies[J]);
  mergeSmall(mesh, held, &groups);

  // Groups in the order of their first copy in the bisection, which keeps neighbours close in memory.
  std::vector<int> number(mesh.numCopies(), -1);
  int count = 0;
  for (int c : copies)
    if (int& n = number[groups.root(c)]; n < 0) n = count++;
  Aggregates result;
  result.start.assign(count + 1, 0);
  for (int c : copies) ++result.start[number[groups.root(c)] + 1];
  std::partial_sum(result.start.begin(), result.start.end(), result.start.begin());
  result.copies.resize(copies.size());
  std::vector<int> end(result.start.begin(), result.start.end() - 1);
  for (int c : copies) result.copies[end[number[groups.root(c)]]++] = c;
  return result;
}

}  // namespace incision
