#include "incision/pace/commands.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "answers_in_tests.h"
#include "frames_in_tests.h"
#include "pace/things_in_tests.h"

namespace incision {
namespace {

class CommandsTest : public ::testing::Test {
 protected:
  CommandsTest() { frames_.mention("adrift"); }

  void cut(const std::string& label, const std::string& frame, Nanoseconds stamp, SteadyTime received = START) {
    commands_.add({labelled(label), frame, stamp, received});
    asked_.push_back(label);
  }
  void pose(const std::string& frame, Nanoseconds stamp) { commands_.add({ToolPose{0, {}}, frame, stamp, START}); }

  /// Each cut asked for so far has been answered just once: taken for the body, or refused.
  void expectOneAnswerEach() {
    std::vector<std::string> answered = answers_.refused_cuts;
    answered.insert(answered.end(), taken_.begin(), taken_.end());
    std::sort(answered.begin(), answered.end());
    std::sort(asked_.begin(), asked_.end());
    EXPECT_EQ(asked_, answered);
  }
  void take(Nanoseconds time) {
    for (const WaitingCut& cut : commands_.takeCuts(time)) taken_.push_back(cut.plane.label);
  }

  FramesInTests frames_;
  AnswersInTests answers_;
  Wakeup wakeup_;
  Commands commands_{{{"tool"}, true, 1}, frames_, answers_, wakeup_};
  std::vector<std::string> asked_, taken_;
};

TEST_F(CommandsTest, ACutIsTakenOrRefusedOnceWhateverItWaitsFor) {
  cut("now", "body", 0);
  cut("due", "body", 10);
  cut("far", "body", 1'000'000);
  cut("found", "knife", 20);
  cut("lost", "adrift", 20);
  cut("never", "adrift", 0, START + std::chrono::seconds(1));
  take(5);
  frames_.set("knife", 20, Pose());
  commands_.poll(START + std::chrono::seconds(1));
  EXPECT_EQ(Refusal::NO_TRANSFORM, answers_.last.kind);
  take(20);
  commands_.refuseAll({Refusal::BY_RESET, "reset"});
  take(2'000'000);
  EXPECT_EQ((std::vector<std::string>{"now", "due", "found"}), taken_);
  EXPECT_EQ((std::vector<std::string>{"lost", "never", "far"}), answers_.refused_cuts);
  expectOneAnswerEach();
}

TEST_F(CommandsTest, OfTooManyCutsEachIsAnsweredOnce) {
  const int count = static_cast<int>(MAX_WAITING_CUTS + MAX_WAITING_FOR_TRANSFORM);
  for (int i = 0; i < count; ++i) {
    cut("a" + std::to_string(i), "body", 1000 + i);
    cut("b" + std::to_string(i), "adrift", 1000 + i);
  }
  EXPECT_EQ(MAX_WAITING_CUTS, commands_.waitingForStep());
  EXPECT_EQ(MAX_WAITING_FOR_TRANSFORM, commands_.waitingForTransform());
  take(1100);
  commands_.refuseAll({Refusal::BY_RESET, "reset"});
  EXPECT_EQ(101u, taken_.size());
  expectOneAnswerEach();
}

TEST_F(CommandsTest, PosesThatAreRefusedAreToldOnceToo) {
  pose("adrift", 0);
  commands_.poll(START + std::chrono::seconds(1));
  pose("adrift", 0);
  commands_.refuseAll({Refusal::BY_RESET, "reset"});
  EXPECT_EQ(2, answers_.refused_of_tools);
  EXPECT_FALSE(commands_.waitForTransforms());
}

TEST_F(CommandsTest, TheLongestWaitSaysForWhat) {
  EXPECT_FALSE(commands_.longestWaiting(0));
  cut("far", "body", 500, START + std::chrono::seconds(2));
  EXPECT_EQ("the cut 'far'", commands_.longestWaiting(499)->what);
  EXPECT_EQ(500, commands_.longestWaiting(499)->stamp);
  EXPECT_FALSE(commands_.longestWaiting(500));  // it only waits for the next step
  commands_.add(0, 0.1, 400, START + std::chrono::seconds(1));
  EXPECT_EQ("what was asked of the tool 'tool'", commands_.longestWaiting(0)->what);
  EXPECT_EQ("", commands_.longestWaiting(0)->frame);
  pose("adrift", 0);
  EXPECT_EQ("a pose of the tool 'tool'", commands_.longestWaiting(0)->what);
  EXPECT_EQ("adrift", commands_.longestWaiting(0)->frame);
}

TEST_F(CommandsTest, WhereStampsDoNotCountNothingWaitsForOne) {
  Commands at_once({{"tool"}, false, 1}, frames_, answers_, wakeup_);
  at_once.add({labelled("far"), "body", 1'000'000, START});
  EXPECT_FALSE(at_once.longestWaiting(0));
  EXPECT_EQ(1u, at_once.takeCuts(0).size());
}

}  // namespace
}  // namespace incision
