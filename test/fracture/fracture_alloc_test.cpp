// What fracture takes from the heap in a step in which nothing cracks, on two threads.
#include <gtest/gtest.h>

#include "support/allocation_hooks.h"
#include "support/sanitized.h"
#include "support/scenes.h"

namespace incision::test {
namespace {

std::int64_t allocationsOfSteps(const Scene& scene) {
  DeformableBody body(scene, loadMesh(scene));
  run(&body, 5);  // the threads start, every vector grows to its size
  return allocationsOf([&] { run(&body, 20); });
}

TEST(FractureAllocations, AreNoneWhereNothingCracks) {
  if (SANITIZED) GTEST_SKIP() << "nothing is counted under the sanitizers";
  Scene scene = swingingBar({16, 4, 4}, 1e6);
  scene.fracture.emplace();
  scene.fracture->tensile_strength = 1e9;
  EXPECT_EQ(allocationsOfSteps(scene), 0);
  // A cut that could grow, and cracks that could fuse, but do not.
  scene.fracture->fuse_distance = 0.1;
  scene.fracture->fuse_angle = 0.5;
  scene.cuts = {{0, rectangle(Vec3(0.51, 0.125, 0.25), Vec3::UnitX(), Vec3::UnitZ(), 0.2, 1)}};
  EXPECT_EQ(allocationsOfSteps(scene), 0);
}

}  // namespace
}  // namespace incision::test
