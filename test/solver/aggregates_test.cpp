#include "incision/solver/aggregates.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/rig.h"

namespace incision {
namespace {

struct Body {
  const char* name;
  std::array<int, 3> cells;
  std::vector<PlaneCut> cuts;
};

const PlaneCut SLANTED = plane(Vec3(0.48, 0.5, 0.5), Vec3(1, 0.2, 0.1));
const PlaneCut CORNER = plane(Vec3(0.01, 0, 0), Vec3::Ones());

std::vector<PlaneCut> slices(int count) {
  std::vector<PlaneCut> cuts;
  for (int k = 1; k < count; ++k)
    cuts.push_back(plane(Vec3(k / static_cast<double>(count), 0, 0), Vec3(1, 0.05, 0.02)));
  return cuts;
}

class Grouping : public ::testing::TestWithParam<Body> {
 protected:
  Grouping() : mesh(block(GetParam().cells, Vec3::Ones())) {
    for (const PlaneCut& cut : GetParam().cuts)
      EXPECT_TRUE(mesh.insert(planeField(cut, mesh, restPositions(mesh))).changed());
    for (int c = 0; c < mesh.numCopies(); ++c) held.push_back(mesh.mesh().nodes[mesh.copyNode(c)].z() == 0);
    const Materials materials(mesh.mesh(), {});
    Assembly assembly(mesh, materials, Mass::LUMPED, Pressure::ELEMENT, true, 1);
    assembly.topologyChanged(restPositions(mesh));
    order = orderNodes(mesh.mesh(), leafSize(static_cast<int>(mesh.mesh().nodes.size())));
    findPattern(assembly, orderCopies(mesh, order, held), &pattern);
    groups = aggregate(mesh, order, pattern);
  }
  CutMesh mesh;
  std::vector<bool> held;
  NodeOrder order;
  BlockPattern pattern;
  Aggregates groups;
};

TEST_P(Grouping, CoversEveryFreeCopyOnce) {
  std::vector<int> found, expected;
  for (int row : groups.rows.values()) found.push_back(pattern.copies[row]);
  for (int c = 0; c < mesh.numCopies(); ++c)
    if (!held[c]) expected.push_back(c);
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, expected);
  for (int a = 0; a < groups.count(); ++a) {
    EXPECT_GT(groups.rows[a].size(), 0);
    for (int row : groups.rows[a]) EXPECT_EQ(groups.of[row], a);
  }
}

TEST_P(Grouping, SpansNoTwoPieces) {
  int pieces = 0;
  const std::vector<int> piece = mesh.copyPieces(&pieces);
  for (int a = 0; a < groups.count(); ++a)
    for (int row : groups.rows[a]) EXPECT_EQ(piece[pattern.copies[row]], piece[pattern.copies[groups.rows[a][0]]]);
}

TEST_P(Grouping, MakesGroupsOfAUsefulSize) {
  EXPECT_GE(groups.count(), pattern.rows() / 128);
  for (int a = 0; a < groups.count(); ++a) EXPECT_LE(groups.rows[a].size(), 128);
}

TEST_P(Grouping, IsTheSameAgain) {
  const Aggregates again = aggregate(mesh, order, pattern);
  EXPECT_EQ(again.rows.values(), groups.rows.values());
  EXPECT_EQ(again.of, groups.of);
}

std::string bodyName(const ::testing::TestParamInfo<Body>& test) { return test.param.name; }

INSTANTIATE_TEST_SUITE_P(Aggregates, Grouping,
                         ::testing::Values(Body{"Element", {1, 1, 1}, {}}, Body{"Block", {8, 8, 8}, {}},
                                           Body{"Halves", {6, 6, 6}, {SLANTED}},
                                           Body{"Fragment", {6, 6, 6}, {SLANTED, CORNER}},
                                           Body{"SlicesInOneCell", {1, 4, 4}, slices(6)}),
                         bodyName);

}  // namespace
}  // namespace incision
