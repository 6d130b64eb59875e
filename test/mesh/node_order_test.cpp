#include "incision/mesh/node_order.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

#include "support/rig.h"

namespace incision {
namespace {

TEST(NodeOrder, RanksEveryNodeOnceWithLeavesAscending) {
  const TetMesh mesh = block({9, 7, 5}, Vec3(2, 1, 1));
  const NodeOrder order = orderNodes(mesh, 64);
  std::vector<int> leaf_at(mesh.nodes.size(), -1);
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    EXPECT_EQ(leaf_at[order.rank[n]], -1);
    leaf_at[order.rank[n]] = order.leaf[n];
  }
  EXPECT_TRUE(std::is_sorted(leaf_at.begin(), leaf_at.end()));
  EXPECT_EQ(leaf_at.back() + 1, order.leaves);
}

TEST(NodeOrder, LeavesAreFullAndCompact) {
  const TetMesh mesh = block({15, 7, 7}, Vec3(2, 1, 1));  // 16 x 8 x 8 nodes
  const NodeOrder order = orderNodes(mesh, 64);
  EXPECT_EQ(order.leaves, 16);
  std::vector<Eigen::AlignedBox3d> boxes(order.leaves);
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) boxes[order.leaf[n]].extend(mesh.nodes[n]);
  for (const Eigen::AlignedBox3d& box : boxes) EXPECT_LT(box.diagonal().norm(), 1);  // 4 x 4 x 4 nodes span 0.72
}

// Sum over all inner faces of how far apart their elements stand in the list.
double gaps(const TetMesh& mesh) {
  const MeshTopology topology = buildTopology(mesh);
  double sum = 0;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    for (int across : topology.neighbours[e])
      if (across >= 0) sum += std::abs(across - static_cast<double>(e));
  return sum;
}

TEST(OrderElements, KeepsTheElementsAndBringsNeighboursTogether) {
  TetMesh mesh = block({8, 8, 8}, Vec3::Ones());
  std::mt19937 generator(1);
  std::shuffle(mesh.elements.begin(), mesh.elements.end(), generator);
  const TetMesh shuffled = mesh;
  orderElements(&mesh);
  const auto sorted = [](std::vector<std::array<int, 4>> elements) {
    std::sort(elements.begin(), elements.end());
    return elements;
  };
  EXPECT_EQ(sorted(mesh.elements), sorted(shuffled.elements));
  EXPECT_LT(gaps(mesh), 0.2 * gaps(shuffled));
}

}  // namespace
}  // namespace incision
