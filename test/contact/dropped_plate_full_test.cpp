#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "incision/base/resolve_path.h"
#include "incision/body/deformable_body.h"
#include "incision/scene/scene.h"

namespace incision::test {
namespace {

/// Where the iteration fails twenty steps go to the direct solver, each of whose solves takes ten times as long: in
/// contact among many pieces it must not do so for what a fresh residual finds.
TEST(DroppedPlate, IsNeverHandedToTheDirectSolver) {
  const std::string address = resolvePath("package://incision/config/scenes/dropped_plate.yaml", "");
  for (const char* density : {"498", "500", "502", "504"}) {
    const Scene scene =
        loadScene(address, {std::string("body.material.density=") + density, "solver.method=iterative"});
    DeformableBody body(scene, loadMesh(scene), loadDescriptions(scene));
    int coupled = 0, direct = 0;
    for (int k = 0; k < 160; ++k) {
      const StepResult step = body.step();
      coupled += step.solves > 1;
      direct += step.solves > 1 && step.iterations == 0;
      EXPECT_TRUE(step.settled) << density << ' ' << k;
    }
    EXPECT_GT(coupled, 100) << density;
    EXPECT_EQ(direct, 0) << density;
  }
}

}  // namespace
}  // namespace incision::test
