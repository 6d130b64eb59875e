#include "incision/ros/obstacle_tracker.h"

#include <geometry_msgs/TransformStamped.h>
#include <gtest/gtest.h>

#include <cmath>

#include "incision/rigid/half_space.h"
#include "incision/rigid/sphere.h"

namespace incision {
namespace {

constexpr double TIME_STEP = 0.01;
constexpr Nanoseconds SECOND = 1'000'000'000;
constexpr double ROUNDING = 1e-14;  // of coordinates below 10

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

struct ObstacleTrackerTest : testing::Test {
  ObstacleTrackerTest() { ros::Time::init(); }  // warnings go by it

  void publish(const std::string& link, double time, double x, const std::string& parent = "body", double turn = 0) {
    geometry_msgs::TransformStamped transform;
    transform.header.frame_id = parent;
    transform.header.stamp = ros::Time(time);
    transform.child_frame_id = link;
    transform.transform.translation.x = x;
    transform.transform.rotation.z = std::sin(turn / 2);
    transform.transform.rotation.w = std::cos(turn / 2);
    buffer.setTransform(transform, "test");
  }
  double armAt() const { return tracker.poses()[0].position.x(); }

  tf2::BufferCore buffer;
  ObstacleTracker tracker{buffer, "body", twoLinks(), TIME_STEP};
};

TEST_F(ObstacleTrackerTest, LinksThatTfDoesNotKnowStayAsDescribed) {
  EXPECT_TRUE(tracker.follow(0).empty());
  EXPECT_EQ(1, armAt());
  EXPECT_EQ(0u, tracker.ignored());
}

TEST_F(ObstacleTrackerTest, TheFirstTransformPutsALinkAndSweepsNothing) {
  publish("arm", 10, 1.01);
  const std::vector<LinkMove> moves = tracker.follow(0);
  ASSERT_EQ(1u, moves.size());
  EXPECT_EQ(0, moves[0].link);
  EXPECT_TRUE(moves[0].at_once);
  EXPECT_EQ(1.01, moves[0].pose.position.x());
  EXPECT_EQ(2, tracker.poses()[1].position.x());
}

TEST_F(ObstacleTrackerTest, AFirstTransformToTheDescribedPlaceMovesNothing) {
  publish("arm", 10, 1);
  EXPECT_TRUE(tracker.follow(0).empty());
  publish("arm", 10.01, 1.01);
  EXPECT_FALSE(tracker.follow(0).at(0).at_once);
}

TEST_F(ObstacleTrackerTest, WhatStandsStillIsNotMoved) {
  publish("arm", 10, 1.01);
  tracker.follow(0);
  publish("arm", 11, 1.01);
  EXPECT_TRUE(tracker.follow(0).empty());
}

TEST_F(ObstacleTrackerTest, AStepFollowsTheTransformsAtItsEnd) {
  for (const double t : {10.0, 11.0}) publish("arm", t, t - 8.5);  // at 1 m/s
  for (int k = 0; k < 50; ++k) {
    const Nanoseconds end = 10 * SECOND + k * SECOND / 100;
    const std::vector<LinkMove> moves = tracker.follow(end);
    ASSERT_EQ(1u, moves.size());
    EXPECT_EQ(k == 0, moves[0].at_once);
    EXPECT_NEAR(1.5 + 0.01 * k, moves[0].pose.position.x(), 1e-9);  // of a stamp in nanoseconds
  }
}

TEST_F(ObstacleTrackerTest, WhereTheEndIsNotKnownYetTheLatestIsFollowed) {
  publish("arm", 10, 1.01);
  EXPECT_EQ(1u, tracker.follow(12 * SECOND).size());
  EXPECT_EQ(1.01, armAt());
}

TEST_F(ObstacleTrackerTest, TransformsMoreSeldomThanStepsAreFollowedEvenly) {
  publish("arm", 10, 1.01);
  tracker.follow(0);
  publish("arm", 10.05, 1.06);
  for (int k = 1; k <= 5; ++k) {
    const std::vector<LinkMove> moves = tracker.follow(0);
    ASSERT_EQ(1u, moves.size());
    EXPECT_FALSE(moves[0].at_once);
    EXPECT_NEAR(1.01 + 0.01 * k, armAt(), ROUNDING);
  }
  EXPECT_TRUE(tracker.follow(0).empty());
}

TEST_F(ObstacleTrackerTest, AfterAPauseOfThePublisherALinkIsNotFollowedLate) {
  publish("arm", 10, 1.01);
  tracker.follow(0);
  publish("arm", 15, 1.06);
  for (int k = 0; k < static_cast<int>(std::lround(MAX_POSE_PERIOD / TIME_STEP)); ++k) tracker.follow(0);
  EXPECT_NEAR(1.06, armAt(), ROUNDING);
}

TEST_F(ObstacleTrackerTest, AJumpSweepsNothing) {
  publish("arm", 10, 1.01);
  tracker.follow(0);
  for (const auto& [time, x, turn] : {std::tuple(10.01, 1.2, 0.0), std::tuple(10.02, 1.2, 1.0)}) {
    publish("arm", time, x, "body", turn);
    const std::vector<LinkMove> moves = tracker.follow(0);
    ASSERT_EQ(1u, moves.size());
    EXPECT_TRUE(moves[0].at_once);
    EXPECT_TRUE(tracker.follow(0).empty());
  }
  publish("arm", 10.03, 1.2 + 0.9 * MAX_OBSTACLE_SPEED * TIME_STEP, "body", 1.0);
  EXPECT_FALSE(tracker.follow(0).at(0).at_once);
}

TEST_F(ObstacleTrackerTest, FollowsThroughOtherFrames) {
  publish("camera", 10, 5);
  publish("arm", 10, 2, "camera");
  tracker.follow(0);
  EXPECT_NEAR(7, armAt(), ROUNDING);
}

TEST_F(ObstacleTrackerTest, ALinkWithoutAWayToTheBodyStaysAndIsCounted) {
  publish("arm", 10, 3, "elsewhere");
  EXPECT_TRUE(tracker.follow(0).empty());
  EXPECT_EQ(1, armAt());
  EXPECT_EQ(1u, tracker.ignored());
}

TEST_F(ObstacleTrackerTest, ATransformOutOfRangeChangesNothingAndIsCounted) {
  publish("arm", 10, 1.01);
  tracker.follow(0);
  publish("arm", 10.01, 1e10);
  EXPECT_TRUE(tracker.follow(0).empty());
  publish("far", 10.02, 1e308);
  publish("arm", 10.02, 1e308, "far");  // infinite in the body's frame
  EXPECT_TRUE(tracker.follow(0).empty());
  EXPECT_EQ(1.01, armAt());
  EXPECT_EQ(2u, tracker.ignored());
}

TEST_F(ObstacleTrackerTest, ARestartPutsLinksWhereTfHasThem) {
  publish("arm", 10, 1.01);
  tracker.follow(0);
  tracker.restart();
  EXPECT_EQ(1, armAt());
  EXPECT_TRUE(tracker.follow(0).at(0).at_once);
  EXPECT_EQ(1.01, armAt());
}

}  // namespace
}  // namespace incision
