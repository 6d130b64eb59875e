#include "incision/pace/step_input.h"

#include <gtest/gtest.h>

#include "answers_in_tests.h"
#include "frames_in_tests.h"
#include "pace/things_in_tests.h"

namespace incision {
namespace {

using std::chrono::milliseconds;

Scene bar() {
  Scene scene;
  scene.body.grid = GridSettings();
  scene.body.grid->cells = {4, 1, 1};
  scene.gravity = Vec3::Zero();
  return scene;
}

PlaneCut across(double x, const std::string& label) {
  PlaneCut plane;
  plane.label = label;
  plane.point = Vec3(x, 0, 0);
  plane.normal = Vec3(1, 0, 0);
  return plane;
}

class StepInputTest : public ::testing::Test {
 protected:
  void cut(const PlaneCut& plane, Nanoseconds stamp, const std::string& frame = "body") {
    commands_.add({plane, frame, stamp, now_});
  }
  /// The clock says this, when it has been waited for; whether a step is due then.
  bool stepDueAt(Nanoseconds clock) {
    pacer_.tick(now_, clock);
    now_ += CLOCK_DELAY;
    return input_.update(now_).step;
  }
  void step() {
    input_.lead(now_);
    body_.step();
    input_.stepTaken();
  }

  SteadyTime now_ = START;
  FramesInTests frames_;
  AnswersInTests answers_;
  Wakeup wakeup_;
  DeformableBody body_{bar(), loadMesh(bar())};
  ClockPacer pacer_{0.01, 5};
  Commands commands_{{{}, true, 1}, frames_, answers_, wakeup_};
  StepInput input_{body_, pacer_, commands_, frames_, answers_};
};

TEST_F(StepInputTest, ACutTakesEffectBeforeTheFirstStepThatStartsAtOrAfterItsStamp) {
  cut(across(0.4, "at 1010"), 1010 * MILLISECOND);
  cut(across(0.6, "at 1011"), 1011 * MILLISECOND);
  ASSERT_TRUE(stepDueAt(1000 * MILLISECOND));
  EXPECT_EQ(0u, answers_.reports.size());
  step();
  ASSERT_TRUE(stepDueAt(1010 * MILLISECOND));
  ASSERT_EQ(1u, answers_.reports.size());
  EXPECT_EQ("at 1010", answers_.reports[0].label);
  step();
  EXPECT_FALSE(stepDueAt(1015 * MILLISECOND));
  EXPECT_EQ(1u, answers_.reports.size());
  ASSERT_TRUE(stepDueAt(1020 * MILLISECOND));
  EXPECT_EQ(2u, answers_.reports.size());
}

TEST_F(StepInputTest, AStepWaitsForACommandsTransformButNotForLong) {
  cut(across(0.4, "adrift"), 1000 * MILLISECOND, "nowhere");
  EXPECT_FALSE(stepDueAt(1000 * MILLISECOND));
  EXPECT_FALSE(stepDueAt(1400 * MILLISECOND));
  EXPECT_TRUE(stepDueAt(1500 * MILLISECOND));
}

TEST_F(StepInputTest, ByWallTimeNoStepWaitsForACommandsTransform) {
  WallPacer pacer(0.01);
  StepInput input(body_, pacer, commands_, frames_, answers_);
  cut(across(0.4, "adrift"), 1000 * MILLISECOND, "nowhere");
  EXPECT_TRUE(input.update(now_).step);
}

TEST_F(StepInputTest, WhilePausedCutsAreMadeWhenTheClockReachesThem) {
  ASSERT_TRUE(stepDueAt(1000 * MILLISECOND));
  input_.setPaused(true);
  cut(across(0.4, "at once"), 0);
  cut(across(0.6, "later"), 1500 * MILLISECOND);
  EXPECT_FALSE(stepDueAt(1400 * MILLISECOND));
  EXPECT_EQ(1u, answers_.reports.size());
  EXPECT_FALSE(stepDueAt(1500 * MILLISECOND));
  EXPECT_EQ(2u, answers_.reports.size());
  EXPECT_EQ(3, body_.counts().pieces);
}

TEST_F(StepInputTest, ARestartAnswersEveryCutThatWaits) {
  cut(across(0.4, "far"), 1'000'000 * MILLISECOND);
  cut(across(0.4, "adrift"), 0, "nowhere");
  input_.restart({Refusal::BY_RESET, "restored"});
  EXPECT_EQ((std::vector<std::string>{"adrift", "far"}), answers_.refused_cuts);
  EXPECT_EQ("restored", answers_.last.reason);
  EXPECT_TRUE(stepDueAt(1000 * MILLISECOND));
  EXPECT_TRUE(answers_.reports.empty());
}

}  // namespace
}  // namespace incision
