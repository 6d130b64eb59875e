// `solver.iterations` bounds the work of every step, whatever happens in it, and what is left is counted.
#include <gtest/gtest.h>

#include "support/broken_plate.h"
#include "support/scenes.h"

namespace incision::test {
namespace {

TEST(BoundedIterations, BoundEveryStepOfABarThatIsCutAndSwingsOn) {
  Scene scene = swingingBar({16, 4, 4}, 1e6);
  scene.solver.iterations = 12;
  scene.cuts = {{0.3, slantedCut()}};
  DeformableBody body(scene, loadMesh(scene));
  int unsettled = 0;
  const double potential_at_first = body.motion().potential_energy;  // it starts at rest
  for (int k = 0; k < 200; ++k) {
    const StepResult step = body.step();
    EXPECT_LE(step.iterations, 12);
    EXPECT_EQ(step.settled, step.residual <= scene.solver.tolerance) << step.residual;
    unsettled += step.settled ? 0 : 1;
    const BodyMotion& motion = body.motion();
    EXPECT_LE(motion.kinetic_energy + motion.elastic_energy + motion.potential_energy, potential_at_first + 1e-6);
  }
  EXPECT_EQ(body.unsettledSteps(), unsettled);
  EXPECT_GT(unsettled, 0);
  EXPECT_LT(unsettled, 200);
}

TEST(BoundedIterations, BoundStepsWithContactFractureAndABlade) {
  Scene scene = everythingAtOnce(Method::ITERATIVE);
  scene.solver.iterations = 30;
  DeformableBody body(scene, loadMesh(scene));
  int unsettled = 0;
  for (int k = 0; k < 40; ++k) {
    const StepResult step = body.step();
    // A piece that would turn too far still has its step taken in parts, each of which may take as many.
    EXPECT_LE(step.iterations, step.divided ? 127 * 30 : 30) << k;
    unsettled += step.settled ? 0 : 1;
  }
  EXPECT_GT(unsettled, 0);
  EXPECT_EQ(body.unsettledSteps(), unsettled);
}

}  // namespace
}  // namespace incision::test
