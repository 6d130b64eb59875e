#include "incision/pace/link_tracker.h"

#include <gtest/gtest.h>

#include <cmath>

#include "incision/rigid/half_space.h"
#include "incision/rigid/sphere.h"
#include "pace/frames_in_tests.h"
#include "pace/things_in_tests.h"

namespace incision {
namespace {

/// Two links, each with a sphere: `arm` at x = 1, `post` at x = 2.
Obstacles twoLinks() {
  Obstacles obstacles;
  const auto sphere = std::make_shared<Sphere>(0.5);
  for (const char* name : {"arm", "post"}) {
    const int link = static_cast<int>(obstacles.links.size());
    Pose pose;
    pose.position.x() = 1 + link;
    obstacles.links.push_back({name, pose});
    obstacles.shapes.push_back({sphere, Pose(), link});
  }
  obstacles.shapes.push_back({std::make_shared<HalfSpace>(), Pose(), GROUND_LINK});
  return obstacles;
}

struct LinkTrackerTest : testing::Test {
  void publish(const std::string& link, Nanoseconds time, double x, double turn = 0) {
    frames.set(link, time, {Vec3(x, 0, 0), Eigen::Quaterniond(Eigen::AngleAxisd(turn, Vec3::UnitZ()))});
  }
  double armAt() const { return tracker.poses()[0].position.x(); }

  FramesInTests frames;
  std::vector<std::string> complaints;
  LinkTracker tracker{
      LinkLookup(frames, [this](const std::string& link, const std::string&) { complaints.push_back(link); }),
      linksOf(twoLinks()), TIME_STEP};
};

TEST_F(LinkTrackerTest, LinksOfWhichNobodyHasHeardStayAsDescribed) {
  EXPECT_TRUE(tracker.follow(0, 0).empty());
  EXPECT_EQ(1, armAt());
  EXPECT_EQ(0u, tracker.ignored());
}

TEST_F(LinkTrackerTest, TheFirstPosePutsALinkAndSweepsNothing) {
  publish("arm", 10000 * MILLISECOND, 1.01);
  const std::vector<LinkMove> moves = tracker.follow(0, 0);
  ASSERT_EQ(1u, moves.size());
  EXPECT_EQ(0, moves[0].link);
  EXPECT_TRUE(moves[0].at_once);
  EXPECT_EQ(1.01, moves[0].pose.position.x());
  EXPECT_EQ(2, tracker.poses()[1].position.x());
}

TEST_F(LinkTrackerTest, AFirstPoseAtTheDescribedPlaceMovesNothing) {
  publish("arm", 10000 * MILLISECOND, 1);
  EXPECT_TRUE(tracker.follow(0, 0).empty());
  publish("arm", 10010 * MILLISECOND, 1.01);
  EXPECT_FALSE(tracker.follow(0, 0).at(0).at_once);
}

TEST_F(LinkTrackerTest, WhatStandsStillIsNotMoved) {
  publish("arm", 10000 * MILLISECOND, 1.01);
  tracker.follow(0, 0);
  publish("arm", 11000 * MILLISECOND, 1.01);
  EXPECT_TRUE(tracker.follow(0, 0).empty());
}

TEST_F(LinkTrackerTest, AStepFollowsThePosesAtItsEnd) {
  for (int k = 0; k < 50; ++k) publish("arm", 10 * SECOND + k * 10 * MILLISECOND, 1.5 + 0.01 * k);
  for (int k = 0; k < 50; ++k) {
    const std::vector<LinkMove> moves = tracker.follow(0, 10 * SECOND + k * 10 * MILLISECOND);
    ASSERT_EQ(1u, moves.size());
    EXPECT_EQ(k == 0, moves[0].at_once);
    EXPECT_EQ(1.5 + 0.01 * k, moves[0].pose.position.x());
  }
}

TEST_F(LinkTrackerTest, WhereTheEndIsNotKnownYetTheLatestIsFollowed) {
  publish("arm", 10000 * MILLISECOND, 1.01);
  EXPECT_EQ(1u, tracker.follow(0, 12 * SECOND).size());
  EXPECT_EQ(1.01, armAt());
}

TEST_F(LinkTrackerTest, PosesMoreSeldomThanStepsAreFollowedEvenly) {
  publish("arm", 10000 * MILLISECOND, 1.01);
  tracker.follow(0, 0);
  publish("arm", 10050 * MILLISECOND, 1.06);
  for (int k = 1; k <= 5; ++k) {
    const std::vector<LinkMove> moves = tracker.follow(0, 0);
    ASSERT_EQ(1u, moves.size());
    EXPECT_FALSE(moves[0].at_once);
    EXPECT_NEAR(1.01 + 0.01 * k, armAt(), POSE_ROUNDING);
  }
  EXPECT_TRUE(tracker.follow(0, 0).empty());
}

TEST_F(LinkTrackerTest, AfterAPauseOfThePublisherALinkIsNotFollowedLate) {
  publish("arm", 10000 * MILLISECOND, 1.01);
  tracker.follow(0, 0);
  publish("arm", 15000 * MILLISECOND, 1.06);
  for (int k = 0; k < static_cast<int>(std::lround(MAX_POSE_PERIOD / TIME_STEP)); ++k) tracker.follow(0, 0);
  EXPECT_NEAR(1.06, armAt(), POSE_ROUNDING);
}

TEST_F(LinkTrackerTest, AJumpSweepsNothing) {
  publish("arm", 10000 * MILLISECOND, 1.01);
  tracker.follow(0, 0);
  for (const auto& [time, x, turn] :
       {std::tuple(10'010 * MILLISECOND, 1.2, 0.0), std::tuple(10'020 * MILLISECOND, 1.2, 1.0)}) {
    publish("arm", time, x, turn);
    const std::vector<LinkMove> moves = tracker.follow(0, 0);
    ASSERT_EQ(1u, moves.size());
    EXPECT_TRUE(moves[0].at_once);
    EXPECT_GT(moves[0].jump_speed.value(), MAX_OBSTACLE_SPEED);
    EXPECT_TRUE(tracker.follow(0, 0).empty());
  }
  publish("arm", 10'030 * MILLISECOND, 1.2 + 0.9 * MAX_OBSTACLE_SPEED * TIME_STEP, 1.0);
  EXPECT_FALSE(tracker.follow(0, 0).at(0).at_once);
}

TEST_F(LinkTrackerTest, ALinkWithoutAWayToTheBodyStaysAndIsCounted) {
  frames.mention("arm");
  EXPECT_TRUE(tracker.follow(0, 0).empty());
  EXPECT_EQ(1, armAt());
  EXPECT_EQ(1u, tracker.ignored());
  EXPECT_EQ(std::vector<std::string>{"arm"}, complaints);
}

TEST_F(LinkTrackerTest, APoseOutOfRangeChangesNothingAndIsCounted) {
  publish("arm", 10'000 * MILLISECOND, 1.01);
  tracker.follow(0, 0);
  publish("arm", 10'010 * MILLISECOND, 1e10);
  EXPECT_TRUE(tracker.follow(0, 0).empty());
  publish("arm", 10'020 * MILLISECOND, HUGE_VAL);
  EXPECT_TRUE(tracker.follow(0, 0).empty());
  EXPECT_EQ(1.01, armAt());
  EXPECT_EQ(2u, tracker.ignored());
}

TEST_F(LinkTrackerTest, ARestartPutsLinksWhereTheyWereSeen) {
  publish("arm", 10000 * MILLISECOND, 1.01);
  tracker.follow(0, 0);
  tracker.restart();
  EXPECT_EQ(1, armAt());
  EXPECT_TRUE(tracker.follow(0, 0).at(0).at_once);
  EXPECT_EQ(1.01, armAt());
}

}  // namespace
}  // namespace incision
