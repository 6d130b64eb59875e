#include "incision/pace/tool_tracker.h"

#include <gtest/gtest.h>

#include "incision/pace/agenda.h"
#include "pace/things_in_tests.h"

namespace incision {
namespace {

ReceivedPose received(double x, Nanoseconds time, bool active = true) {
  return {poseAt(x), time, SteadyTime(std::chrono::nanoseconds(time)), active};
}

struct ToolTrackerTest : testing::Test {
  /// The next step, with these poses and the blade as the last of them has it.
  ToolMove follow(const std::vector<ReceivedPose>& poses, Nanoseconds now) {
    return tracker.follow({poses, poses.empty() || poses.back().active}, now, false);
  }
  /// Puts the tool at x = 0 in a step at 1 s.
  void begin() { follow({received(0, 1000 * MILLISECOND)}, 1000 * MILLISECOND); }

  ToolSettings settings;  // a jump is farther than 0.1 m, a pose stale after 0.5 s
  Edge edge = {Vec3::Zero(), Vec3(0, 0, 0.05)};
  ToolTracker tracker{settings, edge, TIME_STEP};
};

TEST_F(ToolTrackerTest, TheFirstPoseOnlyPlacesTheTool) {
  const ToolMove move = follow({received(5, 1000 * MILLISECOND)}, 1000 * MILLISECOND);
  ASSERT_TRUE(move.placed);
  EXPECT_EQ(5, move.placed->position.x());
  EXPECT_TRUE(move.path.empty());
  EXPECT_EQ(0u, tracker.jumps());
}

TEST_F(ToolTrackerTest, AllPosesOfAStepAreItsPath) {
  begin();
  const double xs[] = {0.01, 0.05, 0.03};
  std::vector<ReceivedPose> poses;
  for (const double x : xs)
    poses.push_back(received(x, 1003 * MILLISECOND + MILLISECOND * static_cast<int>(poses.size())));
  const ToolMove move = follow(poses, 1010 * MILLISECOND);
  ASSERT_EQ(3u, move.path.size());
  for (int i = 0; i < 3; ++i) EXPECT_EQ(xs[i], move.path[i].position.x());
  EXPECT_EQ(poses.back().received, move.received);
  EXPECT_TRUE(follow({}, 1020 * MILLISECOND).path.empty());
}

TEST_F(ToolTrackerTest, PosesMoreSeldomThanStepsAreFollowedEvenly) {
  begin();
  ToolMove move = follow({received(0.05, 1050 * MILLISECOND)}, 1050 * MILLISECOND);
  for (int k = 1; k <= 5; ++k) {
    ASSERT_EQ(1u, move.path.size());
    EXPECT_NEAR(0.01 * k, move.path[0].position.x(), POSE_ROUNDING);
    EXPECT_EQ(k == 1, move.received.has_value());
    move = follow({}, 1050 * MILLISECOND + k * 10 * MILLISECOND);
  }
  EXPECT_TRUE(move.path.empty());
}

TEST_F(ToolTrackerTest, APoseThatComesEarlyCutsNoCorner) {
  begin();
  follow({received(0.05, 1050 * MILLISECOND)}, 1050 * MILLISECOND);
  ReceivedPose corner = received(0, 1070 * MILLISECOND);
  corner.pose = poseAt(0.05, 0.06);
  const ToolMove move = follow({corner}, 1070 * MILLISECOND);  // half of 0.04 m there and 0.06 m on
  ASSERT_EQ(2u, move.path.size());
  EXPECT_EQ(0.05, move.path[0].position.x());
  EXPECT_NEAR(0.01, move.path[1].position.y(), POSE_ROUNDING);
  EXPECT_EQ(0.06, follow({}, 1080 * MILLISECOND).path.back().position.y());
}

TEST_F(ToolTrackerTest, AJumpPutsTheToolThereAndCounts) {
  begin();
  EXPECT_FALSE(follow({received(0.09, 1010 * MILLISECOND)}, 1010 * MILLISECOND).placed);
  const ToolMove move =
      follow({received(0.2, 1020 * MILLISECOND), received(0.21, 1021 * MILLISECOND)}, 1021 * MILLISECOND);
  ASSERT_TRUE(move.placed);
  EXPECT_EQ(0.2, move.placed->position.x());
  ASSERT_EQ(1u, move.path.size());
  EXPECT_EQ(0.21, move.path[0].position.x());
  EXPECT_EQ(1u, tracker.jumps());
  EXPECT_NEAR(0.11, move.jump.value(), POSE_ROUNDING);
}

TEST_F(ToolTrackerTest, ATurnThatCarriesAnEndOfTheEdgeFarIsAJump) {
  settings.max_step = 0.06;
  ToolTracker strict(settings, edge, TIME_STEP);
  strict.follow({{received(0, 1000 * MILLISECOND)}}, 1000 * MILLISECOND, false);
  ReceivedPose turned = received(0, 1010 * MILLISECOND);
  turned.pose.orientation = Eigen::AngleAxisd(2, Vec3::UnitX());  // 2 × 0.05 m × sin 1
  EXPECT_TRUE(strict.follow({{turned}}, 1010 * MILLISECOND, false).placed);
  EXPECT_EQ(1u, strict.jumps());
}

TEST_F(ToolTrackerTest, WhatComesBeforeAJumpIsDoneFirst) {
  begin();
  ToolMove move =
      follow({received(0.05, 1002 * MILLISECOND), received(1, 1004 * MILLISECOND), received(1.05, 1006 * MILLISECOND)},
             1010 * MILLISECOND);
  EXPECT_FALSE(move.placed);
  EXPECT_EQ(0.05, move.path.back().position.x());
  move = follow({}, 1020 * MILLISECOND);
  EXPECT_EQ(1, move.placed->position.x());
  EXPECT_EQ(1.05, move.path.back().position.x());
}

TEST_F(ToolTrackerTest, ASwitchOfTheBladeSeparatesThePosesBeforeAndAfterIt) {
  begin();
  ToolMove move =
      follow({received(0.05, 1002 * MILLISECOND, true), received(0.09, 1004 * MILLISECOND, false)}, 1010 * MILLISECOND);
  EXPECT_TRUE(move.active);
  EXPECT_EQ(0.05, move.path.back().position.x());
  move = tracker.follow({{}, false}, 1020 * MILLISECOND, false);
  EXPECT_FALSE(move.active);
  EXPECT_EQ(0.09, move.path.back().position.x());
  EXPECT_EQ(0u, tracker.jumps());
}

TEST_F(ToolTrackerTest, ASwitchOfTheBladeTakesEffectWithoutAPose) {
  begin();
  EXPECT_FALSE(tracker.follow({{}, false}, 1010 * MILLISECOND, false).active);
  EXPECT_TRUE(tracker.follow({{}, true}, 1020 * MILLISECOND, false).active);
}

TEST_F(ToolTrackerTest, OfManyStrokesInAStepTheOldestAreSkipped) {
  begin();
  std::vector<ReceivedPose> poses;
  for (int k = 1; k <= 3 * MAX_WAITING_STROKES; ++k) poses.push_back(received(k, 1001 * MILLISECOND));
  ToolMove move = follow(poses, 1010 * MILLISECOND);
  for (int k = 1; k <= MAX_WAITING_STROKES; ++k) {
    EXPECT_EQ(2 * MAX_WAITING_STROKES + k, move.placed->position.x());
    move = follow({}, 1010 * MILLISECOND + k * 10 * MILLISECOND);
  }
  EXPECT_FALSE(move.placed);
}

TEST_F(ToolTrackerTest, AStalePoseStopsTheToolWhereItIs) {
  settings.timeout = 0.02;
  ToolTracker strict(settings, edge, TIME_STEP);
  strict.follow({{received(0, 1000 * MILLISECOND)}}, 1000 * MILLISECOND, false);
  strict.follow({{received(0.05, 1050 * MILLISECOND)}}, 1050 * MILLISECOND, false);
  EXPECT_FALSE(strict.follow({}, 1070 * MILLISECOND, false).path.empty());
  EXPECT_FALSE(strict.stale());
  ToolMove move = strict.follow({}, 1080 * MILLISECOND, false);
  EXPECT_TRUE(move.path.empty());
  EXPECT_TRUE(move.went_stale);
  EXPECT_TRUE(strict.stale());
  // It stands still at 0.02, and goes on from there.
  move = strict.follow({{received(0.03, 1090 * MILLISECOND)}}, 1090 * MILLISECOND, false);
  EXPECT_TRUE(move.came_again);
  EXPECT_FALSE(strict.stale());
  EXPECT_FALSE(move.placed);
  EXPECT_NEAR(0.0225, move.path.back().position.x(), POSE_ROUNDING);  // a quarter of 0.01 m: in 40 ms
}

TEST_F(ToolTrackerTest, WithoutAPoseNothingIsStale) {
  follow({}, 1000 * MILLISECOND);
  follow({}, 9000 * MILLISECOND);
  EXPECT_FALSE(tracker.stale());
}

TEST_F(ToolTrackerTest, ASingleStepGoesThroughAllPosesAndTakesNoTime) {
  begin();
  const ToolMove move = tracker.follow({{received(0.05, 1050 * MILLISECOND)}}, 9000 * MILLISECOND, true);
  EXPECT_EQ(0.05, move.path.back().position.x());
  tracker.follow({}, 19000 * MILLISECOND, true);
  EXPECT_FALSE(tracker.stale());
}

TEST_F(ToolTrackerTest, AfterARestartAPoseOnlyPlacesTheTool) {
  begin();
  tracker.restart();
  EXPECT_TRUE(follow({received(0.01, 10 * MILLISECOND)}, 10 * MILLISECOND).placed);
  EXPECT_EQ(0u, tracker.jumps());
}

/// With stamps, the path in a step does not depend on how early the poses arrive.
TEST_F(ToolTrackerTest, AReplayDoesNotDependOnArrival) {
  std::vector<ReceivedPose> poses;
  for (int k = 1; k <= 40; ++k) poses.push_back(received(0.002 * k * k, 1000 * MILLISECOND + k * 7 * MILLISECOND));
  std::vector<double> ends[2];
  for (const int ahead : {0, 1}) {
    Agenda agenda(1);
    ToolTracker replayed(settings, edge, TIME_STEP);
    auto next = poses.begin();
    for (Nanoseconds now = 1000 * MILLISECOND; now < 1400 * MILLISECOND; now += 10 * MILLISECOND) {
      for (; next != poses.end() && (ahead == 1 || next->time <= now); ++next) agenda.add(0, *next, next->time);
      const ToolMove move = replayed.follow(agenda.takeTool(0, now), now, false);
      if (move.placed) ends[ahead].push_back(move.placed->position.x());
      for (const Pose& pose : move.path) ends[ahead].push_back(pose.position.x());
    }
  }
  EXPECT_GT(ends[0].size(), 20u);
  EXPECT_EQ(ends[0], ends[1]);
}

}  // namespace
}  // namespace incision
