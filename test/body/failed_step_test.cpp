#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "support/blade.h"
#include "support/broken_plate.h"
#include "support/failing_solver.h"
#include "support/rig.h"
#include "support/sanitized.h"
#include "support/tool.h"

namespace incision::test {
namespace {

/// What a run has told.
struct Told {
  int cuts = 0, cracks = 0;
  void add(const Reports& reports) {
    cuts += static_cast<int>(reports.cuts.size());
    cracks += static_cast<int>(reports.cracks.size());
  }
  void add(const StepResult& result) { add(Reports{result.cuts, result.cracks}); }
};

class FailedStep : public ::testing::TestWithParam<Method> {};

TEST_P(FailedStep, LeavesTheBodyAsIfItHadNotBeenTried) {
  const Scene scene = everythingAtOnce(GetParam());
  for (int failed = 1; failed < 15; failed += SANITIZED ? 12 : 2) {
    Fallible failing(scene), twin(scene);
    Told told, expected;
    for (int k = 0; k <= failed; ++k) {
      if (k == failed) failing.failOnce(ALL);
      told.add(failing.body.takeReports());
      told.add(failing.body.step());
      expected.add(twin.body.step());
    }
    EXPECT_EQ(told.cuts, expected.cuts) << failed;
    EXPECT_EQ(told.cracks, expected.cracks) << failed;
    EXPECT_EQ(failing.body.stateHash(), twin.body.stateHash()) << failed;
    if (failed == 13) {
      EXPECT_GT(expected.cracks, 0);
      EXPECT_EQ(expected.cuts, 1);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, FailedStep, ::testing::Values(Method::DIRECT, Method::ITERATIVE));

/// A free body that falls, and a blade that turns as it is drawn into it against resistance.
Scene turningBlade() {
  Scene scene = plateAndBlade();
  scene.gravity = Vec3(0, 0, -0.1);
  bladeOf(&scene.tools[0]).cutting.resistance.force = 200;
  bladeOf(&scene.tools[0]).cutting.resistance.viscosity = 50;
  bladeOf(&scene.tools[0]).cutting.resistance.onset = 20;
  scene.solver.time_step = 0.02;
  return scene;
}

Pose turnedBy(double share) {
  return {Vec3(-0.02 + 0.1 * share, 0.21, 0), Eigen::Quaterniond(Eigen::AngleAxisd(1.5 * share, Vec3::UnitZ()))};
}

Vec3 inBody(const Vec3& vector, const Pose& pose) { return pose.orientation * vector; }

// The direct solve of the whole step fails, those of its halves do not.
TEST(HalvedStep, TellsTheWrenchThatTheMomentumTells) {
  Fallible one(turningBlade());
  one.body.placeTool(turnedBy(0));
  double most = 0;
  for (int k = 1; k <= 10; ++k) {
    const Pose from = *one.body.toolPose();
    one.body.guideTool({turnedBy(k / 10.0)});
    const Vec3 before = one.body.motion().momentum;
    one.failures.fail({0});
    const StepResult result = one.body.step();
    EXPECT_GT(one.failures.count, 2);
    const Vec3 weight = one.body.motion().mass * one.body.scene().gravity;
    const Vec3 gained = one.body.motion().momentum - before - 0.02 * weight;
    const Vec3 given = -0.02 * inBody(result.tools[0].force, from);
    EXPECT_LT((gained - given).norm(), 1e-9 * std::max(1.0, given.norm())) << k;
    most = std::max(most, given.norm());
  }
  EXPECT_GT(most, 0.01);
}

TEST(FailedSteps, TellOfWhatTookEffectBeforeThemOnce) {
  Scene scene = plateAndBlade();
  scene.tools.clear();
  scene.gravity = Vec3(0, 0, 1e308);
  PlaneCut plane;
  plane.label = "first";
  plane.point = Vec3(0.5, 0, 0);
  scene.cuts = {{0, plane}};
  DeformableBody body(scene, loadMesh(scene));
  EXPECT_THROW(body.step(), StepFailed);
  EXPECT_THROW(body.step(), StepFailed);
  const Reports reports = body.takeReports();
  ASSERT_EQ(reports.cuts.size(), 1u);
  EXPECT_EQ(reports.cuts[0].label, "first");
  EXPECT_EQ(reports.cuts[0].status, CutStatus::APPLIED);
  EXPECT_TRUE(body.takeReports().cuts.empty());
  EXPECT_EQ(body.steps(), 0);
}

TEST(FailedSteps, AreTakenWithThePathThatTheToolHadBefore) {
  const Scene scene = turningBlade();
  Fallible failing(scene), twin(scene);
  for (Fallible* one : {&failing, &twin}) {
    one->body.placeTool(turnedBy(0));
    one->body.guideTool({turnedBy(0.2), turnedBy(0.4)});
  }
  failing.failOnce(ALL);
  failing.body.guideTool({turnedBy(0.5)});
  twin.body.guideTool({turnedBy(0.5)});
  failing.body.step();
  twin.body.step();
  EXPECT_EQ(failing.body.toolPose()->position, turnedBy(0.5).position);
  EXPECT_EQ(failing.body.counts().parts, twin.body.counts().parts);
  EXPECT_LT(largestDifference(failing.body.positions(), twin.body.positions()), 1e-9);
}

TEST(Tools, ThatAreNotThereAreRefused) {
  Scene scene = plateAndBlade();
  scene.tools.clear();
  DeformableBody body(scene, loadMesh(scene));
  EXPECT_EQ(body.tools(), 0u);
  EXPECT_THROW(body.guideTool({Pose()}), std::out_of_range);
  EXPECT_THROW(body.placeTool(Pose()), std::out_of_range);
  EXPECT_THROW(body.liftTool(), std::out_of_range);
  EXPECT_THROW(body.activateTool(false), std::out_of_range);
  EXPECT_THROW(body.toolPose(), std::out_of_range);
  for (const int link : {-1, 0, 7}) {
    EXPECT_THROW(body.moveObstacle(link, Pose()), std::out_of_range);
    EXPECT_THROW(body.placeObstacle(link, Pose()), std::out_of_range);
  }
}

}  // namespace
}  // namespace incision::test
