#include "incision/solver/node_order.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

namespace incision {
namespace {

/// Groups this small are left in the order they come: they share cache lines anyway.
constexpr int SMALLEST = 4;

class Bisection {
 public:
  Bisection(const TetMesh& mesh, int leaf_size) : mesh_(mesh), leaf_size_(leaf_size), nodes_(mesh.nodes.size()) {
    std::iota(nodes_.begin(), nodes_.end(), 0);
    order_.rank.resize(nodes_.size());
    order_.leaf.resize(nodes_.size());
    const int count = static_cast<int>(nodes_.size());
    halve(0, count, false);
    for (int i = 0; i < count; ++i) order_.rank[nodes_[i]] = i;
  }
  const NodeOrder& order() const { return order_; }

 private:
  /// Halves nodes_[begin … end) across its longest side, and so on; above the leaves into whole leaves.
  void halve(int begin, int end, bool in_leaf) {
    const int count = end - begin;
    if (!in_leaf && count <= leaf_size_) {
      for (int i = begin; i < end; ++i) order_.leaf[nodes_[i]] = order_.leaves;
      ++order_.leaves;
      in_leaf = true;
    }
    if (in_leaf && count <= SMALLEST) return;
    Eigen::AlignedBox3d box;
    for (int i = begin; i < end; ++i) box.extend(mesh_.nodes[nodes_[i]]);
    int axis;
    box.sizes().maxCoeff(&axis);
    const int leaves = (count + leaf_size_ - 1) / leaf_size_;
    const int first = in_leaf ? count / 2 : static_cast<int>(static_cast<long>(count) * (leaves / 2) / leaves);
    std::nth_element(nodes_.begin() + begin, nodes_.begin() + begin + first, nodes_.begin() + end, [&](int a, int b) {
      const double x = mesh_.nodes[a][axis], y = mesh_.nodes[b][axis];
      return x != y ? x < y : a < b;
    });
    halve(begin, begin + first, in_leaf);
    halve(begin + first, end, in_leaf);
  }

  const TetMesh& mesh_;
  const int leaf_size_;
  std::vector<int> nodes_;
  NodeOrder order_;
};

}  // namespace

NodeOrder orderNodes(const TetMesh& mesh, int leaf_size) { return Bisection(mesh, leaf_size).order(); }

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

}  // namespace incision
