// After a body has become another, what leads it follows without memory from the heap, of which there may be none.
#include <gtest/gtest.h>

#include <utility>

#include "frames_in_tests.h"
#include "incision/pace/step_input.h"
#include "support/allocation_hooks.h"
#include "things_in_tests.h"

namespace incision {
namespace {

const Refused REFUSED = {Refusal::BY_RESET, "the body has become another before it took effect"};

/// Counts the cuts that are refused.
class CountingAnswers : public Answers {
 public:
  void report(const CutResult&) override {}
  void refuseCut(const std::string&, const Refused&) override { ++refused_cuts; }
  void refuseTool(int, const Refused&) override {}
  void warn(const std::string&, const std::string&) override {}
  void inform(const std::string&) override {}

  int refused_cuts = 0;
};

Scene barWithTools() {
  Scene scene;
  scene.body.grid = GridSettings();
  scene.body.grid->cells = {4, 1, 1};
  scene.solver.time_step = TIME_STEP;
  for (const char* name : {"first", "second"}) {
    ToolSettings tool;
    tool.name = name;
    tool.kind = BladeSettings{Edge{Vec3::Zero(), Vec3(0, 0, 0.05)}};
    scene.tools.push_back(tool);
  }
  return scene;
}

Pose at(double x) { return {Vec3(x, 0, 0.5), Eigen::Quaterniond::Identity()}; }

class LeadsWithoutMemory : public ::testing::Test {
 protected:
  void pose(int tool, double x, const char* frame = "body") { commands_.add({ToolPose{tool, at(x)}, frame, 0, now_}); }

  /// Steps in which one tool is on its way, off and with strokes that wait; the other stands.
  void lead() {
    pose(1, 0.2);
    for (int i = 0; i < 5; ++i) {
      pose(0, 0.01 * i);
      pose(0, 0.7 + 0.01 * i);  // a jump
      commands_.activate(0, i % 2 == 0);
      input_.lead(now_ += std::chrono::milliseconds(10));
      body_.step();
    }
  }

  /// What waits when the body becomes another.
  void leaveWaiting() {
    for (const char* label : {"a label that no string holds without memory", "b", "c"}) {
      commands_.add({labelled(label), "body", 1'000'000'000'000, now_});
      commands_.add({labelled(label), "a frame that nobody knows", 0, now_});
    }
    pose(0, 0.4);
    pose(1, 0.4, "a frame that nobody knows");
    commands_.add(0, 0.1, 0, now_);
  }

  SteadyTime now_{std::chrono::seconds(100)};
  FramesInTests frames_;
  CountingAnswers answers_;
  Wakeup wakeup_;
  DeformableBody body_{barWithTools(), loadMesh(barWithTools())};
  WallPacer pacer_{TIME_STEP};
  Commands commands_{{{"first", "second"}, true, 1}, frames_, answers_, wakeup_};
  StepInput input_{body_, pacer_, commands_, frames_, answers_};
};

TEST_F(LeadsWithoutMemory, AreRecalledAndAnswerEachCutThatWaits) {
  lead();
  ASSERT_GT(test::allocationsOf([&] { input_.keep(); }), 0);  // they are counted
  const LeadsMemory kept = input_.keep();
  ASSERT_FALSE(kept.tools[0].tracker.waiting.empty());
  std::optional<LeadsMemory> memory = kept;
  leaveWaiting();
  EXPECT_EQ(0, test::allocationsOf([&] { input_.recall(std::move(memory), REFUSED); }));
  EXPECT_EQ(6, answers_.refused_cuts);
  EXPECT_EQ(0u, commands_.waitingForStep() + commands_.waitingForTransform());
  EXPECT_EQ(toBytes(kept), toBytes(input_.keep()));
  EXPECT_EQ(kept.tools[0].active, commands_.takeTool(0, 0).active);
}

TEST_F(LeadsWithoutMemory, TakeOverABodyThatNobodyLed) {
  lead();
  leaveWaiting();
  EXPECT_EQ(0, test::allocationsOf([&] { input_.recall(std::nullopt, REFUSED); }));
  EXPECT_EQ(6, answers_.refused_cuts);
  EXPECT_TRUE(input_.keep().tools[0].tracker.last == body_.toolPose(0));
}

TEST_F(LeadsWithoutMemory, StartAnewAfterAReset) {
  lead();
  leaveWaiting();
  body_.reset();
  EXPECT_EQ(0, test::allocationsOf([&] { input_.restart(REFUSED); }));
  EXPECT_EQ(6, answers_.refused_cuts);
  EXPECT_FALSE(input_.keep().tools[0].tracker.last);
}

}  // namespace
}  // namespace incision
