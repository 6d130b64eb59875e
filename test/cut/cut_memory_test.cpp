// A memory that cannot be one of a mesh is told from one that can.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "incision/base/input_error.h"
#include "incision/cut/cut_mesh.h"
#include "incision/mesh/grid_mesh.h"

namespace incision {
namespace {

using Change = std::function<void(CutMesh::Memory*)>;

/// A bar with two cuts that cross.
CutMesh crossed() {
  CutMesh mesh(gridMesh({{3, 2, 2}, Vec3(1, 1, 1), Vec3::Zero()}));
  for (const Vec3& normal : {Vec3(1, 0.2, 0.1), Vec3(0.1, 1, 0.3)}) {
    PlaneCut plane;
    plane.point = Vec3(0.45, 0.55, 0.5);
    plane.normal = normal;
    std::vector<Vec3> x;
    for (int c = 0; c < mesh.numCopies(); ++c) x.push_back(mesh.mesh().nodes[mesh.copyNode(c)]);
    mesh.insert(planeField(plane, mesh, x));
  }
  return mesh;
}

TEST(CutMemory, TellsWhatOthersNumber) {
  const CutMesh mesh = crossed();
  const MemoryLimits limits = mesh.check(mesh.keep());
  EXPECT_EQ(limits.copies, mesh.numCopies());
  EXPECT_EQ(limits.cracks, 2);
  EXPECT_EQ(limits.parts(), static_cast<int>(mesh.parts().size()));
  EXPECT_EQ(limits.first_copies, 36);
  int pieces = 0;
  mesh.copyPieces(&pieces);
  EXPECT_EQ(limits.pieces, pieces);
  EXPECT_EQ(pieces, 4);
}

TEST(CutMemory, IsRefusedWhereOneFieldCannotBe) {
  const CutMesh mesh = crossed();
  int split = 0;  // an element of more than one part
  while (mesh.parts()[split].next < 0) ++split;
  const int detail = mesh.parts()[split].detail, last = static_cast<int>(mesh.parts().size()) - 1;
  const std::vector<Change> changes = {
      [](auto* m) { m->parts.pop_back(); },
      [](auto* m) { m->parts.resize(3); },
      [](auto* m) { m->parts[0].element = 1; },
      [](auto* m) { m->parts[0].element = -1; },
      [](auto* m) { m->parts[0].copies[2] = 1 << 20; },
      [](auto* m) { std::swap(m->parts[0].copies[0], m->parts[0].copies[1]); },
      [=](auto* m) { m->parts[split].fraction *= 1.1; },
      [](auto* m) { m->parts[0].fraction = 0; },
      [=](auto* m) { m->parts[split].next = split; },
      [=](auto* m) { m->parts[split].next = -1; },
      [=](auto* m) { m->parts[split].next = 0; },
      [=](auto* m) { m->parts[last].next = last; },
      [=](auto* m) { m->parts[last].next = last + 1; },
      [=](auto* m) { m->parts[last].detail = m->parts[split].detail; },
      [=](auto* m) { m->parts[split].detail = -1; },
      [=](auto* m) { m->parts[split].detail = 1 << 20; },
      [](auto* m) { m->details.emplace_back(); },
      [=](auto* m) { m->details[detail].polytope.corners[0][0] += 0.1; },
      [=](auto* m) { m->details[detail].polytope.corners.resize(3); },
      [=](auto* m) { m->details[detail].polytope.facets[0].corners[0] = 99; },
      [=](auto* m) { m->details[detail].polytope.facets[0].corners.resize(2); },
      [=](auto* m) { m->details[detail].polytope.facets[0].face = 4; },
      [=](auto* m) { m->details[detail].polytope.facets[0].crack = 2; },
      [=](auto* m) { m->details[detail].centroid[1] = 7; },
      [=](auto* m) {
        m->details[detail].face_sides.push_back({5, 0, 1});
      },
      [=](auto* m) {
        m->details[detail].face_sides.push_back({1, 2, 1});
      },
      [=](auto* m) {
        m->details[detail].face_sides.push_back({1, 0, 0});
      },
      [](auto* m) { m->copy_node[3] = -1; },
      [](auto* m) { m->copy_node.back() = 0; },
      [](auto* m) { m->copy_node.push_back(0); },
      [](auto* m) { m->copy_parent.back() = static_cast<int>(m->copy_parent.size()) - 1; },
      [](auto* m) { m->copy_parent[0] = 1; },
      [](auto* m) { m->own_copy[5] = 6; },
      [](auto* m) { m->own_copy.pop_back(); },
      [](auto* m) { m->num_cracks = 1; },
      [](auto* m) { m->num_cracks = -1; },
      [](auto* m) { m->num_cracks = 1 << 30; },
  };
  for (std::size_t i = 0; i < changes.size(); ++i) {
    CutMesh::Memory memory = mesh.keep();
    changes[i](&memory);
    EXPECT_THROW(mesh.check(memory), InputError) << i;
  }
}

}  // namespace
}  // namespace incision
