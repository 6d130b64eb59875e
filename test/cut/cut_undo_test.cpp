// Cuts that are undone leave no trace, and hinder none that follow.
#include <gtest/gtest.h>

#include <random>
#include <sstream>

#include "incision/base/archive.h"
#include "incision/cut/cut_mesh.h"
#include "incision/mesh/grid_mesh.h"

namespace incision {
namespace {

std::string bytesOf(const CutMesh& mesh) {
  std::ostringstream bytes;
  ArchiveWriter archive(bytes);
  archive(mesh.keep());
  return bytes.str();
}

/// Cuts at random, one in three along faces of elements, so that it severs these and splits nothing.
void cut(CutMesh* mesh, std::mt19937* random) {
  std::uniform_real_distribution<double> share(0, 1);
  PlaneCut plane;
  plane.point = Vec3(share(*random), share(*random), share(*random));
  plane.normal = Vec3(share(*random) - 0.5, share(*random) - 0.5, share(*random) - 0.5);
  if (share(*random) < 0.33) {
    plane.point = Vec3(1.0 / 3, 0.5, 0.5);
    plane.normal = Vec3::Unit((*random)() % 3);
    plane.tangent = Vec3::Unit(((*random)() % 3));
  }
  std::vector<Vec3> x;
  for (int c = 0; c < mesh->numCopies(); ++c) x.push_back(mesh->mesh().nodes[mesh->copyNode(c)]);
  mesh->insert(planeField(plane, *mesh, x));
}

TEST(UndoneCuts, LeaveNoTrace) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    CutMesh mesh(gridMesh({{3, 2, 2}, Vec3(1, 1, 1), Vec3::Zero()}));
    std::size_t most = 0;
    for (int round = 0; round < 4; ++round) {
      const std::string before = bytesOf(mesh);
      mesh.mark();
      const std::mt19937 then = random;
      for (int k = 0; k < 3; ++k) cut(&mesh, &random);
      const std::string after = bytesOf(mesh);
      mesh.undo();
      ASSERT_EQ(bytesOf(mesh), before) << seed << ", round " << round;
      random = then;
      mesh.mark();
      for (int k = 0; k < 3; ++k) cut(&mesh, &random);
      ASSERT_EQ(bytesOf(mesh), after) << seed << ", round " << round;
      most = mesh.parts().size();
    }
    EXPECT_GT(most, mesh.mesh().elements.size());
  }
}

TEST(UndoneCuts, OfAMeshThatWasExchangedLeaveThatOne) {
  CutMesh mesh(gridMesh({{3, 2, 2}, Vec3(1, 1, 1), Vec3::Zero()}));
  CutMesh::Memory whole = mesh.keep();
  std::mt19937 random(1);
  cut(&mesh, &random);
  const std::string once = bytesOf(mesh);
  mesh.exchange(&whole);
  EXPECT_EQ(mesh.parts().size(), mesh.mesh().elements.size());
  mesh.exchange(&whole);
  EXPECT_EQ(bytesOf(mesh), once);
  cut(&mesh, &random);
  mesh.undo();
  EXPECT_EQ(bytesOf(mesh), once);
}

}  // namespace
}  // namespace incision
