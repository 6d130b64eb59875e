#include "incision/mesh/tet_mesh.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <random>

#include "incision/mesh/grid_mesh.h"

namespace incision {
namespace {

/// A grid whose elements, their nodes and the nodes' numbers are shuffled: nothing may lean on the grid's order.
TetMesh shuffledGrid(unsigned seed) {
  TetMesh grid = gridMesh({{3, 2, 2}, Vec3(3, 2, 2), Vec3::Zero()});
  std::mt19937 random(seed);
  std::vector<int> number(grid.nodes.size());
  for (std::size_t n = 0; n < number.size(); ++n) number[n] = static_cast<int>(n);
  std::shuffle(number.begin(), number.end(), random);

  TetMesh mesh = grid;
  for (std::size_t n = 0; n < number.size(); ++n) mesh.nodes[number[n]] = grid.nodes[n];
  std::shuffle(mesh.elements.begin(), mesh.elements.end(), random);
  for (auto& [a, b, c, d] : mesh.elements) {
    const int turn = static_cast<int>(random() % 3);
    for (int* n : {&a, &b, &c, &d}) *n = number[*n];
    for (int i = 0; i < turn; ++i) std::tie(b, c, d) = std::make_tuple(c, d, b);
  }
  return mesh;
}

std::array<int, 3> sortedFace(const TetMesh& mesh, std::size_t e, int f) {
  std::array<int, 3> face;
  for (int i = 0; i < 3; ++i) face[i] = mesh.elements[e][FACE_NODES[f][i]];
  std::sort(face.begin(), face.end());
  return face;
}

TEST(TetMesh, FacesAreCounterClockwiseSeenFromOutside) {
  const std::array<Vec3, 4> X = {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
  EXPECT_DOUBLE_EQ(sixVolumes(X[0], X[1], X[2], X[3]), 1);
  for (int f = 0; f < 4; ++f) {
    const auto [a, b, c] = FACE_NODES[f];
    EXPECT_LT((X[b] - X[a]).cross(X[c] - X[a]).dot(X[f] - X[a]), 0);
  }
}

TEST(TetMesh, NeighboursAreWhatComparingAllFacesFinds) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const TetMesh mesh = shuffledGrid(seed);
    const MeshTopology topology = buildTopology(mesh);
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
      for (int f = 0; f < 4; ++f) {
        int across = -1;
        for (std::size_t other = 0; other < mesh.elements.size(); ++other)
          for (int g = 0; g < 4; ++g)
            if (other != e && sortedFace(mesh, e, f) == sortedFace(mesh, other, g)) across = static_cast<int>(other);
        EXPECT_EQ(topology.neighbours[e][f], across);
      }
    }
  }
}

TEST(TetMesh, StarsHoldTheElementsOfANodeInAscendingOrder) {
  TetMesh mesh = shuffledGrid(6);
  mesh.nodes.push_back(Vec3(9, 9, 9));
  const MeshTopology topology = buildTopology(mesh);
  ASSERT_EQ(topology.star.count(), static_cast<int>(mesh.nodes.size()));
  for (int n = 0; n < static_cast<int>(mesh.nodes.size()); ++n) {
    std::vector<int> expected;
    for (std::size_t e = 0; e < mesh.elements.size(); ++e)
      if (std::count(mesh.elements[e].begin(), mesh.elements[e].end(), n)) expected.push_back(static_cast<int>(e));
    EXPECT_EQ(std::vector<int>(topology.star[n].begin(), topology.star[n].end()), expected);
  }
}

TEST(TetMesh, ElementsThatShareOnlyAnEdgeAreNoNeighbours) {
  const Vec3 O = Vec3::Zero();
  const TetMesh mesh{{O, Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ(), -Vec3::UnitY(), -Vec3::UnitZ()},
                     {{0, 1, 2, 3}, {0, 1, 4, 5}}};
  const MeshTopology topology = buildTopology(mesh);
  for (const auto& neighbours : topology.neighbours) EXPECT_EQ(neighbours, (std::array<int, 4>{-1, -1, -1, -1}));
}

TEST(TetMesh, AFaceOfThreeElementsIsRefused) {
  const TetMesh mesh{{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ(), -Vec3::UnitZ(), Vec3(0.2, 0.2, 2)},
                     {{0, 1, 2, 3}, {0, 2, 1, 4}, {0, 1, 2, 5}}};
  try {
    buildTopology(mesh);
    FAIL() << "no error";
  } catch (const TopologyError& error) {
    EXPECT_FALSE(error.overlap);
    EXPECT_EQ(error.elements, (std::vector<int>{0, 1, 2}));
    EXPECT_EQ(error.face, (std::array<int, 3>{0, 1, 2}));
    EXPECT_NE(std::string(error.what()).find("elements 0 1 2 share the face of nodes 0 1 2"), std::string::npos);
  }
}

TEST(TetMesh, TwoElementsOnOneSideOfTheirFaceAreRefused) {
  const TetMesh mesh{{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ(), Vec3(0.2, 0.2, 2)},
                     {{0, 1, 2, 3}, {0, 1, 2, 4}}};
  try {
    buildTopology(mesh);
    FAIL() << "no error";
  } catch (const TopologyError& error) {
    EXPECT_TRUE(error.overlap);
    EXPECT_EQ(error.elements, (std::vector<int>{0, 1}));
    EXPECT_EQ(error.face, (std::array<int, 3>{0, 1, 2}));
  }
}

TEST(TetMesh, ShortestEdgeIsThatOfAnyElementAtTheNode) {
  // A lone node (index 3) and the far end of a needle (index 4).
  const TetMesh mesh{{Vec3::Zero(), Vec3(2, 0, 0), Vec3(0, 3, 0), Vec3(9, 9, 9), Vec3(0, 0, 10)}, {{0, 1, 2, 4}}};
  const std::vector<double> shortest = shortestEdges(mesh);
  EXPECT_DOUBLE_EQ(shortest[0], 2);
  EXPECT_DOUBLE_EQ(shortest[1], 2);
  EXPECT_DOUBLE_EQ(shortest[2], 3);
  EXPECT_EQ(shortest[3], std::numeric_limits<double>::infinity());
  EXPECT_DOUBLE_EQ(shortest[4], 10);
}

TEST(TetMesh, VolumeIsASixthOfTheDeterminant) {
  const TetMesh mesh{{Vec3(1, 1, 1), Vec3(3, 1, 1), Vec3(1, 4, 1), Vec3(1, 1, 6)}, {{0, 1, 2, 3}}};
  EXPECT_DOUBLE_EQ(elementVolume(mesh, 0), 2.0 * 3 * 5 / 6);
}

}  // namespace
}  // namespace incision
