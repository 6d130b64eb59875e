#include "incision/cut/copies.h"

#include <gtest/gtest.h>

#include <numeric>

#include "support/cut_laws.h"
#include "support/deformed_mesh.h"
#include "support/scenes.h"

namespace incision {
namespace {

using test::DeformedMesh;
using test::plane;
using test::rectangle;

TetMesh oneElement() {
  TetMesh mesh;
  mesh.nodes = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
  mesh.elements = {{0, 1, 2, 3}};
  return mesh;
}

TEST(Copies, ElementsThatMeetOnlyAtANodeAreSeparatePieces) {
  TetMesh mesh = oneElement();
  mesh.nodes.insert(mesh.nodes.end(), {Vec3(-1, 0, 0), Vec3(0, -1, 0), Vec3(0, 0, -1)});
  mesh.elements.push_back({0, 5, 4, 6});
  const DeformedMesh body(mesh);
  EXPECT_EQ(body.mesh.numCopies(), 8);
  EXPECT_EQ(body.pieces(), 2);
  test::expectSoundCutMesh(body.mesh);
}

TEST(Copies, ElementsThatMeetOnlyAtAnEdgeAreSeparatePieces) {
  TetMesh mesh = oneElement();
  mesh.nodes.insert(mesh.nodes.end(), {Vec3(0, -1, 0), Vec3(0, 0, -1)});
  mesh.elements.push_back({0, 1, 4, 5});
  const DeformedMesh body(mesh);
  EXPECT_EQ(body.mesh.numCopies(), 8);
  EXPECT_EQ(body.pieces(), 2);
  test::expectSoundCutMesh(body.mesh);
}

TEST(Copies, ANodeNoElementUsesHasNone) {
  TetMesh mesh = oneElement();
  mesh.nodes.insert(mesh.nodes.begin(), Vec3(5, 5, 5));
  mesh.elements[0] = {1, 2, 3, 4};
  const CutMesh cut(mesh);
  EXPECT_EQ(cut.numCopies(), 4);
  EXPECT_EQ(cut.ownCopy(0), -1);
}

TEST(Copies, EveryPartOfALoneElementHasItsOwn) {
  test::Random random(6);
  DeformedMesh body(oneElement());
  for (int k = 0; k < 6; ++k) {
    PlaneCut cut = plane(Vec3::Constant(0.25) + random.vector(0.05), random.direction());
    body.cut(cut);
    EXPECT_EQ(body.mesh.numCopies(), 4 * static_cast<int>(body.mesh.parts().size()));
    EXPECT_EQ(body.pieces(), static_cast<int>(body.mesh.parts().size()));
  }
}

// Most copies that a node has.
int mostCopiesAt(const CutMesh& mesh) {
  std::map<int, int> count;
  int most = 0;
  for (int c = 0; c < mesh.numCopies(); ++c) most = std::max(most, ++count[mesh.copyNode(c)]);
  return most;
}

int mostPartsInAnElement(const CutMesh& mesh) {
  int most = 0;
  for (int e = 0; e < static_cast<int>(mesh.mesh().elements.size()); ++e) {
    int count = 0;
    for (int p = e; p >= 0; p = mesh.parts()[p].next) ++count;
    most = std::max(most, count);
  }
  return most;
}

const GridSettings BLOCK = {{5, 5, 5}, Vec3::Ones(), Vec3::Zero()};
const Vec3 CENTRE(0.43, 0.48, 0.51);
// Normals of planes through a common line, for a body that they cut from end to end.
const Vec3 FIRST(1, 0.12, 0), SECOND(-0.15, 1, 0), SLANTED(0.9, 1, 0);

TEST(Crossing, AnXMakesFourZones) {
  DeformedMesh block(gridMesh(BLOCK));
  EXPECT_EQ(block.cut(plane(CENTRE, FIRST)).crack, 0);
  EXPECT_EQ(block.cut(plane(CENTRE, SECOND)).crack, 1);
  EXPECT_EQ(block.pieces(), 4);
  EXPECT_EQ(mostPartsInAnElement(block.mesh), 4);
  EXPECT_EQ(mostCopiesAt(block.mesh), 4);
  test::expectSoundCutMesh(block.mesh);
}

// A later crack on one side of an earlier one: perpendicular it makes a T, slanted a Y.
class StoppedCrack : public ::testing::TestWithParam<Vec3> {};

TEST_P(StoppedCrack, MakesThreeZones) {
  DeformedMesh block(gridMesh(BLOCK));
  block.cut(plane(CENTRE, FIRST));
  // Centres of parts tell on which side of the first crack they lie.
  std::vector<int> positive;
  for (int p = 0; p < static_cast<int>(block.mesh.parts().size()); ++p) {
    Vec3 centre = Vec3::Zero();
    for (int I = 0; I < 4; ++I)
      centre += block.mesh.centroid(p)[I] *
                block.mesh.mesh().nodes[block.mesh.mesh().elements[block.mesh.parts()[p].element][I]];
    if (FIRST.dot(centre - CENTRE) > 0) positive.push_back(p);
  }
  CrackField field = planeField(plane(CENTRE, GetParam()), block.mesh, block.x);
  field.parts = positive;
  EXPECT_TRUE(block.mesh.insert(field).changed());
  EXPECT_EQ(block.pieces(), 3);
  EXPECT_EQ(mostPartsInAnElement(block.mesh), 3);
  EXPECT_EQ(mostCopiesAt(block.mesh), 3);
  test::expectSoundCutMesh(block.mesh);
}

INSTANTIATE_TEST_SUITE_P(AsTAndY, StoppedCrack, ::testing::Values(SECOND, SLANTED));

TEST(Crossing, ARectangleThatEndsAtAnotherCrackPartsTheBlockInThree) {
  // Ends half a cell beyond the crack, where its last sections on the other side are too far out to be in its bounds.
  DeformedMesh block(gridMesh({{4, 4, 4}, Vec3::Ones(), Vec3::Zero()}));
  block.cut(plane(Vec3(0.5, 0, 0), Vec3::UnitX()));
  block.cut(rectangle(Vec3(0.75, 0.5, 0.55), Vec3::UnitZ(), Vec3::UnitX(), 0.5001, 2));
  EXPECT_EQ(block.pieces(), 3);
  test::expectSoundCutMesh(block.mesh);
}

TEST(Copies, StayOneWhereACrackEndsInTheMaterial) {
  DeformedMesh block(gridMesh(BLOCK));
  const Insertion done = block.cut(rectangle(CENTRE, FIRST, Vec3::UnitY(), 0.5, 0.5));
  EXPECT_GT(done.parts_split, 0);
  EXPECT_EQ(block.pieces(), 1);
  // Round every edge of the fringe an element is whole, so its nodes keep one copy.
  const CrackField field = planeField(rectangle(CENTRE, FIRST, Vec3::UnitY(), 0.5, 0.5), block.mesh, block.x);
  std::vector<int> count(block.mesh.mesh().nodes.size(), 0);
  for (int c = 0; c < block.mesh.numCopies(); ++c) ++count[block.mesh.copyNode(c)];
  for (int e = 0; e < static_cast<int>(block.mesh.mesh().elements.size()); ++e) {
    if (block.mesh.parts()[e].next >= 0) continue;
    const auto& nodes = block.mesh.mesh().elements[e];
    for (const auto& [I, J] : EDGE_NODES)
      if (field.phi[nodes[I]] * field.phi[nodes[J]] < 0) {
        EXPECT_EQ(count[nodes[I]], 1);
        EXPECT_EQ(count[nodes[J]], 1);
      }
  }
}

TEST(Copies, NewOnesKnowTheirNodeAndParent) {
  test::Random random(7);
  DeformedMesh block(test::jitteredGrid(BLOCK, 0.2, &random));
  for (int k = 0; k < 4; ++k) {
    const int before = block.mesh.numCopies();
    const std::vector<Part> parts_before = block.mesh.parts();
    const Insertion done = block.cut(random.plane(BLOCK));
    EXPECT_EQ(block.mesh.numCopies(), before + done.copies_added);
    for (int c = before; c < block.mesh.numCopies(); ++c) {
      EXPECT_LT(block.mesh.copyParent(c), before);
      EXPECT_EQ(block.mesh.copyNode(c), block.mesh.copyNode(block.mesh.copyParent(c)));
    }
    for (int c = 0; c < static_cast<int>(block.mesh.mesh().nodes.size()); ++c)
      EXPECT_EQ(block.mesh.ownCopy(c), c) << "own copies keep their number";
    // A part that a crack left whole uses its old copies or ones made from them.
    for (std::size_t p = 0; p < parts_before.size(); ++p)
      for (int I = 0; I < 4; ++I) {
        const int now = block.mesh.parts()[p].copies[I], old = parts_before[p].copies[I];
        EXPECT_TRUE(now == old || block.mesh.copyParent(now) == old);
      }
  }
}

TEST(ComponentFinder, CountsTheCopiesOfEveryNode) {
  test::Random random(8);
  DeformedMesh block(test::jitteredGrid(BLOCK, 0.2, &random));
  for (int k = 0; k < 5; ++k) block.cut(random.rectangle(BLOCK, 0.3, 1));
  std::vector<int> count(block.mesh.mesh().nodes.size(), 0);
  for (int c = 0; c < block.mesh.numCopies(); ++c) ++count[block.mesh.copyNode(c)];
  std::vector<int> nodes(count.size());
  std::iota(nodes.begin(), nodes.end(), 0);
  ComponentFinder finder(block.mesh, nodes);
  for (std::size_t n = 0; n < count.size(); ++n) EXPECT_EQ(finder.find(static_cast<int>(n)).count, count[n]);
}

}  // namespace
}  // namespace incision
