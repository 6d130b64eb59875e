#include "incision/pace/clamp_tracker.h"

#include <gtest/gtest.h>

#include "pace/frames_in_tests.h"
#include "pace/things_in_tests.h"

namespace incision {
namespace {

std::vector<Clamp> clamps() {
  std::vector<Clamp> clamps(3);
  clamps[1].frame = "rib";
  clamps[2].frame = "hip";
  return clamps;
}

struct ClampTrackerTest : testing::Test {
  void publish(const std::string& frame, Nanoseconds time, double x) {
    frames.set(frame, time, {Vec3(x, 0, 0), Eigen::Quaterniond::Identity()});
  }
  FramesInTests frames;
  std::vector<std::string> complaints;
  ClampTracker tracker{
      frames, [this](const std::string& frame, const std::string& why) { complaints.push_back(frame + ": " + why); },
      clamps(), TIME_STEP};
};

TEST_F(ClampTrackerTest, TheFirstPoseTellsWhereTheFrameIsEvenIfThatIsTheBodysOrigin) {
  publish("rib", 10000 * MILLISECOND, 0);
  const std::vector<LinkMove> moves = tracker.follow(0, 0, true);
  ASSERT_EQ(moves.size(), 1u);
  EXPECT_EQ(moves[0].link, 1);
  EXPECT_TRUE(moves[0].at_once);
  EXPECT_FALSE(moves[0].jump_speed);
  publish("rib", 10010 * MILLISECOND, 0.01);
  EXPECT_FALSE(tracker.follow(0, 0, true).at(0).at_once);
}

TEST_F(ClampTrackerTest, AJumpIsAtOnceAndSaysSo) {
  publish("hip", 10000 * MILLISECOND, 0);
  tracker.follow(0, 0, true);
  publish("hip", 10010 * MILLISECOND, 1);
  const std::vector<LinkMove> moves = tracker.follow(0, 0, true);
  ASSERT_EQ(moves.size(), 1u);
  EXPECT_EQ(moves[0].link, 2);
  EXPECT_GT(moves[0].jump_speed.value(), MAX_OBSTACLE_SPEED);
}

TEST_F(ClampTrackerTest, FramesOfWhichNothingIsKnownAreSaid) {
  publish("rib", 10000 * MILLISECOND, 0);
  EXPECT_EQ(tracker.follow(20000 * MILLISECOND, 0, false).size(), 1u);
  EXPECT_EQ(complaints, std::vector<std::string>{"hip: tf has not told where it is"});
}

TEST_F(ClampTrackerTest, FramesOfWhichNothingNewComesAreSaidAndStay) {
  publish("rib", 10000 * MILLISECOND, 0);
  publish("hip", 0, 0);  // holds for all times
  for (const int t : {0, 400, 600}) {
    EXPECT_EQ(tracker.follow((20000 + t) * MILLISECOND, 0, false).size(), t == 0 ? 2u : 0u);
    EXPECT_EQ(complaints.size(), t == 600 ? 1u : 0u) << t;
  }
  EXPECT_EQ(complaints.at(0).find("rib: its last transform is older"), 0u);
  publish("rib", 10700 * MILLISECOND, 0.01);
  EXPECT_EQ(tracker.follow(20700 * MILLISECOND, 0, false).size(), 1u);
  EXPECT_EQ(complaints.size(), 1u);
}

TEST_F(ClampTrackerTest, ARestartForgetsAllFrames) {
  publish("rib", 10000 * MILLISECOND, 0.5);
  tracker.follow(0, 0, true);
  tracker.restart();
  EXPECT_TRUE(tracker.follow(0, 0, true).at(0).at_once);
}

}  // namespace
}  // namespace incision
