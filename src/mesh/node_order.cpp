#include "incision/mesh/node_order.h"

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
    order_.leaf_size = leaf_size;
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

void orderElements(TetMesh* mesh) {
  const std::vector<int> rank = orderNodes(*mesh, static_cast<int>(mesh->nodes.size())).rank;
  std::vector<std::pair<int, int>> by_rank;  // the lowest rank of an element's nodes, and the element
  for (std::size_t e = 0; e < mesh->elements.size(); ++e) {
    const auto& nodes = mesh->elements[e];
    by_rank.emplace_back(std::min({rank[nodes[0]], rank[nodes[1]], rank[nodes[2]], rank[nodes[3]]}),
                         static_cast<int>(e));
  }
  std::sort(by_rank.begin(), by_rank.end());
  std::vector<std::array<int, 4>> sorted;
  sorted.reserve(by_rank.size());
  for (const auto& [lowest, e] : by_rank) sorted.push_back(mesh->elements[e]);
  mesh->elements = std::move(sorted);

  std::vector<int> place_of(by_rank.size());
  for (std::size_t i = 0; i < by_rank.size(); ++i) place_of[by_rank[i].second] = static_cast<int>(i);
  for (PhysicalGroup& group : mesh->groups) {
    for (int& e : group.elements) e = place_of[e];
    std::sort(group.elements.begin(), group.elements.end());
  }
}

}  // namespace incision
