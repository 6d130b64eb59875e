#include <gtest/gtest.h>

#include "support/hertz.h"
#include "support/mesh_folder.h"
#include "support/solid_meshes.h"

namespace incision::test {
namespace {

const Material TISSUE = {1e6, 0.3, 1e-9, 0, 0};
const std::vector<double> DEPTHS = {0.005, 0.01, 0.02};

TEST(Contact, GivesHertzForce) {
  for (const int cells : {6, 12, 24}) {
    const std::vector<double> found = hertzForces(cells, DEPTHS, TISSUE);
    for (std::size_t i = 0; i < DEPTHS.size(); ++i) {
      const double exact = hertzForce(TISSUE, DEPTHS[i]);
      std::printf("%d cells, depth %.3f m: %.1f N, %+.1f %%\n", 24 * cells * cells * cells, DEPTHS[i], found[i],
                  100 * (found[i] / exact - 1));
      if (cells == 24) {
        EXPECT_NEAR(found[i], exact, 0.1 * exact) << DEPTHS[i];
      }
    }
  }
}

// The sphere's triangles are a sixth as wide as the contact where it is narrowest.
TEST(Contact, GivesHertzForceUnderASphereOfTriangles) {
  const MeshFolder meshes("hertz");
  const std::string ball = meshes.shape("ball.stl", asBinaryStl(sphereMesh(1, 150)));
  const std::vector<double> found = hertzForces(24, DEPTHS, TISSUE, ball);
  for (std::size_t i = 0; i < DEPTHS.size(); ++i) {
    const double exact = hertzForce(TISSUE, DEPTHS[i]);
    std::printf("depth %.3f m: %.1f N, %+.1f %%\n", DEPTHS[i], found[i], 100 * (found[i] / exact - 1));
    EXPECT_NEAR(found[i], exact, 0.1 * exact) << DEPTHS[i];
  }
}

}  // namespace
}  // namespace incision::test
