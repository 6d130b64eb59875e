#include "incision/fem/block_pattern.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

#include "support/fan_mesh.h"
#include "support/rig.h"

namespace incision {
namespace {

void expectSame(const BlockPattern& a, const BlockPattern& b, const CutMesh& mesh) {
  EXPECT_EQ(a.copies, b.copies);
  EXPECT_EQ(a.row_of, b.row_of);
  EXPECT_EQ(a.row_start, b.row_start);
  EXPECT_EQ(a.column, b.column);
  EXPECT_EQ(a.diagonal, b.diagonal);
  ASSERT_EQ(a.slots.size(), 16 * mesh.parts().size());
  ASSERT_EQ(b.slots.size(), a.slots.size());
  for (std::size_t p = 0; p < mesh.parts().size(); ++p)
    for (int I = 0; I < 4; ++I)
      for (int J = 0; J < 4; ++J)
        if (a.row_of[mesh.parts()[p].copies[I]] >= 0) {
          EXPECT_EQ(a.slots[16 * p + 4 * I + J], b.slots[16 * p + 4 * I + J]);
        }
  EXPECT_EQ(a.patch_slots, b.patch_slots);
}

// Copies by node, so that those of a cut stand between the others; those the test names are left out.
std::vector<int> orderWithout(const CutMesh& mesh, const std::vector<char>& out) {
  std::vector<int> order;
  for (int c = 0; c < mesh.numCopies(); ++c)
    if (c >= static_cast<int>(out.size()) || !out[c]) order.push_back(c);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return mesh.copyNode(a) < mesh.copyNode(b); });
  return order;
}

TEST(BlockPattern, EditedAfterCutsIsTheOneBuiltAnew) {
  std::mt19937 generator(8);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::bernoulli_distribution rarely(0.1);
  for (int scene = 0; scene < 40; ++scene) {
    CutMesh mesh(block({4, 3, 2}, Vec3::Ones()));
    const std::vector<Vec3> x = restPositions(mesh);
    const Materials materials(mesh.mesh(), {});
    Assembly assembly(mesh, materials, Mass::LUMPED, scene % 2 ? Pressure::AVERAGED : Pressure::ELEMENT, true, 2);
    assembly.topologyChanged(x);
    BlockPattern edited;
    std::vector<int> touched;
    for (int k = 0; k < 6; ++k) {
      std::vector<char> out(mesh.numCopies());
      for (char& o : out) o = rarely(generator);
      const std::vector<int> order = orderWithout(mesh, out);
      editPattern(assembly, order, touched, &edited);
      BlockPattern anew;
      findPattern(assembly, order, &anew);
      expectSame(edited, anew, mesh);

      const Vec3 point = 0.5 * Vec3(uniform(generator) + 1, uniform(generator) + 1, uniform(generator) + 1);
      const Vec3 normal(uniform(generator), uniform(generator), uniform(generator));
      const PlaneCut cut = k % 2 ? plane(point, normal) : rectangle(point, normal, normal.unitOrthogonal(), 0.6, 0.4);
      std::vector<Vec3> at(mesh.numCopies());
      for (int c = 0; c < mesh.numCopies(); ++c) at[c] = mesh.mesh().nodes[mesh.copyNode(c)];
      touched = mesh.insert(planeField(cut, mesh, at)).touched;
      at.resize(mesh.numCopies());
      for (int c = 0; c < mesh.numCopies(); ++c) at[c] = mesh.mesh().nodes[mesh.copyNode(c)];
      assembly.topologyChanged(at, touched);
    }
  }
}

// A fan of elements round an edge whose ends have more neighbours than a slot can tell apart.
TEST(BlockPattern, TakesRowsOfAnyWidth) {
  constexpr int RIM = 66000;
  const CutMesh mesh(fanMesh(RIM));
  const Materials materials(mesh.mesh(), {});
  Assembly assembly(mesh, materials, Mass::LUMPED, Pressure::ELEMENT, true, 1);
  assembly.topologyChanged(restPositions(mesh));
  BlockPattern pattern;
  findPattern(assembly, allCopies(mesh), &pattern);
  ASSERT_EQ(pattern.row_start[1] - pattern.row_start[0], RIM + 2);
  for (const Corner& corner : assembly.corners()[0])
    for (int J = 0; J < 4; ++J) EXPECT_EQ(slotOf(assembly, pattern, 0, corner, J), mesh.parts()[corner.part].copies[J]);
}

TEST(Assembly, EditedAfterCutsIsTheOneBuiltAnew) {
  Rig rig(block({4, 3, 2}, Vec3::Ones()), {});
  Assembly edited(rig.mesh, rig.materials, Mass::CONSISTENT, Pressure::ELEMENT, true, 2);
  edited.topologyChanged(rig.motion.x);
  for (int k = 0; k < 5; ++k) {
    const Insertion done = rig.cut(plane(Vec3(0.2 * k + 0.13, 0.4, 0.5), Vec3(1, 0.3 * k, 0.2 - 0.1 * k)));
    ASSERT_TRUE(done.changed());
    edited.topologyChanged(rig.motion.x, done.touched);
    Assembly anew(rig.mesh, rig.materials, Mass::CONSISTENT, Pressure::ELEMENT, true, 1);
    anew.topologyChanged(rig.motion.x);
    ASSERT_EQ(edited.corners().count(), anew.corners().count());
    for (int c = 0; c < anew.corners().count(); ++c) {
      ASSERT_EQ(edited.corners()[c].size(), anew.corners()[c].size());
      for (int i = 0; i < anew.corners()[c].size(); ++i) {
        EXPECT_EQ(edited.corners()[c][i].part, anew.corners()[c][i].part);
        EXPECT_EQ(edited.corners()[c][i].node, anew.corners()[c][i].node);
      }
    }
    EXPECT_EQ(edited.masses(), anew.masses());
    EXPECT_EQ(edited.massDiagonal(), anew.massDiagonal());
    EXPECT_EQ(edited.stiffnessDiagonal(), anew.stiffnessDiagonal());
    EXPECT_EQ(edited.forceRounding(), anew.forceRounding());
  }
}

}  // namespace
}  // namespace incision
