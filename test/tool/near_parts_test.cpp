#include "incision/tool/near_parts.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "incision/mesh/grid_mesh.h"
#include "incision/mesh/node_order.h"
#include "incision/tool/part_frame.h"
#include "support/deformed_mesh.h"

namespace incision {
namespace {

TetMesh bar() {
  TetMesh mesh = gridMesh({{16, 6, 6}, {1.6, 0.6, 0.6}});
  orderElements(&mesh);
  return mesh;
}

Eigen::AlignedBox3d boxAt(const Vec3& place, double size) {
  return {place.array() - size / 2, place.array() + size / 2};
}

/// How many of the parts whose boxes, larger by `room` of their sizes, meet the reach are not among those found.
int missed(const CutMesh& mesh, const std::vector<int>& found, const Eigen::AlignedBox3d& reach, double room,
           const std::vector<Vec3>& x, const std::vector<Vec3>& before) {
  int count = 0;
  for (int p = 0; p < static_cast<int>(mesh.parts().size()); ++p) {
    const Eigen::AlignedBox3d box = boxOf(mesh.parts()[p], x).merged(boxOf(mesh.parts()[p], before));
    const Vec3 more = room * box.sizes();
    if (reach.intersects(Eigen::AlignedBox3d(box.min() - more, box.max() + more)))
      count += !std::binary_search(found.begin(), found.end(), p);
  }
  return count;
}

TEST(NearParts, AreAllThatAreNearHoweverTheBodyMovesAndIsCut) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    test::Random random(seed);
    test::DeformedMesh body(bar());
    NearParts near(body.mesh, 0.1);
    for (int round = 0; round < 40; ++round) {
      const std::vector<Vec3> before = body.x;
      if (round % 5 == 4) body.cut(PlaneCut{"", random.vector(0.8) + Vec3(0.8, 0.3, 0.3), random.vector(1)});
      std::vector<Vec3> then = before;
      for (int c = static_cast<int>(then.size()); c < body.mesh.numCopies(); ++c)
        then.push_back(then[body.mesh.copyParent(c)]);
      if (round % 7 == 6) body.scatter(0.5, &random);
      body.shake(random.uniform(0, 0.04), &random);
      const Eigen::AlignedBox3d reach = boxAt(random.vector(0.8) + Vec3(0.8, 0.3, 0.3), random.uniform(0, 0.3));
      const double room = round % 2;
      EXPECT_EQ(missed(body.mesh, near.find(reach, room, body.x), reach, room, body.x, body.x), 0) << seed;
      EXPECT_EQ(missed(body.mesh, near.find(reach, room, body.x, then), reach, room, body.x, then), 0) << seed;
    }
  }
}

TEST(NearParts, AreAsFewInABodyOfMoreElements) {
  std::vector<std::size_t> found;
  for (int refined : {1, 2}) {
    TetMesh mesh = gridMesh({{16 * refined, 6 * refined, 6 * refined}, {1.6, 0.6, 0.6}});
    orderElements(&mesh);
    test::DeformedMesh body(mesh);
    NearParts near(body.mesh, 0.1 / refined);
    found.push_back(near.find(boxAt({0.8, 0.3, 0.3}, 0.02), 0, body.x).size());
    EXPECT_EQ(near.find(boxAt({5, 5, 5}, 0.02), 1, body.x).size(), 0u);
  }
  EXPECT_GT(found[0], 0u);
  EXPECT_LT(found[0], 500u);  // of 3,456
  EXPECT_LT(found[1], 500u);  // of 27,648
}

TEST(NearParts, ForgetTheMeshThatThereWas) {
  test::DeformedMesh body(bar());
  NearParts near(body.mesh, 0.1);
  near.find(boxAt({0.8, 0.3, 0.3}, 0.02), 0, body.x);
  test::DeformedMesh other(bar());
  other.cut(PlaneCut{"", {0.5, 0, 0}, Vec3::UnitX()});
  test::Random random(1);
  other.scatter(3, &random);
  body.mesh = other.mesh;
  near.forget();
  const Eigen::AlignedBox3d reach = boxAt(other.x[0], 0.1);
  EXPECT_EQ(missed(body.mesh, near.find(reach, 0, other.x), reach, 0, other.x, other.x), 0);
}

}  // namespace
}  // namespace incision
