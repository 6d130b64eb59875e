#include "incision/ros/tf_frames.h"

#include <geometry_msgs/TransformStamped.h>
#include <gtest/gtest.h>
#include <ros/time.h>

#include <cmath>

namespace incision {
namespace {

constexpr Nanoseconds SECOND = 1'000'000'000;
constexpr double OF_A_STAMP = 1e-9;  // tf interpolates between stamps in nanoseconds

struct TfFramesTest : testing::Test {
  void publish(const std::string& frame, double time, double x, const std::string& parent = "body") {
    geometry_msgs::TransformStamped transform;
    transform.header.frame_id = parent;
    transform.header.stamp = ros::Time(time);
    transform.child_frame_id = frame;
    transform.transform.translation.x = x;
    transform.transform.rotation.w = 1;
    buffer.setTransform(transform, "test");
  }
  double xAt(const std::string& frame, Nanoseconds time) {
    const auto found = frames.find(frame, time, nullptr);
    return found ? found->pose.position.x() : std::nan("");
  }

  tf2::BufferCore buffer;
  TfFrames frames{buffer, "body"};
};

TEST_F(TfFramesTest, AFrameIsFoundThroughOthersAtTheTimeAskedFor) {
  publish("camera", 10, 5);
  publish("camera", 11, 6);
  publish("arm", 10, 2, "camera");
  publish("arm", 11, 2, "camera");
  EXPECT_NEAR(7.5, xAt("arm", 10 * SECOND + SECOND / 2), OF_A_STAMP);
  EXPECT_NEAR(8, xAt("arm", 0), OF_A_STAMP);
  EXPECT_EQ(11 * SECOND, frames.find("arm", 0, nullptr)->stamp);
}

TEST_F(TfFramesTest, WhatIsNotKnownHasAReason) {
  std::string why;
  EXPECT_FALSE(frames.knows("nowhere"));
  EXPECT_FALSE(frames.find("nowhere", 0, &why));
  EXPECT_NE(std::string::npos, why.find("nowhere"));
}

TEST_F(TfFramesTest, AFrameWithoutAWayToTheBodyIsKnownButNotFound) {
  publish("arm", 10, 3, "elsewhere");
  EXPECT_TRUE(frames.knows("arm"));
  EXPECT_FALSE(frames.find("arm", 0, nullptr));
}

TEST_F(TfFramesTest, AStampAtTheEndOfTimeIsNotKnown) {
  publish("arm", 10, 1);
  std::string why;
  EXPECT_FALSE(frames.find("arm", 4294967295 * SECOND, &why));
  EXPECT_FALSE(why.empty());
}

}  // namespace
}  // namespace incision
