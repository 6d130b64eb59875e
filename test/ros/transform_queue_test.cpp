#include "incision/ros/transform_queue.h"

#include <geometry_msgs/TransformStamped.h>
#include <gtest/gtest.h>

namespace incision {
namespace {

using std::chrono::seconds;

const SteadyTime START{seconds(100)};
constexpr Nanoseconds SECOND = 1'000'000'000;

/// A queue with a timeout of one second, and what came out of it.
struct TransformQueueTest : testing::Test {
  Command cut(const std::string& label, const std::string& frame, Nanoseconds stamp = 0) {
    PlaneCut plane;
    plane.label = label;
    return {plane, frame, stamp, START};
  }
  Command pose(double x, const std::string& frame, Nanoseconds stamp = 0) {
    return {Pose{Vec3(x, 0, 0), Eigen::Quaterniond::Identity()}, frame, stamp, START};
  }
  /// The frame `knife` lies one metre along y, at this time.
  void publishKnife(double time) {
    geometry_msgs::TransformStamped transform;
    transform.header.frame_id = "body";
    transform.header.stamp = ros::Time(time);
    transform.child_frame_id = "knife";
    transform.transform.translation.y = 1;
    transform.transform.rotation.w = 1;
    buffer.setTransform(transform, "test");
  }

  tf2::BufferCore buffer;
  std::vector<Command> released;
  std::vector<std::string> refused;
  TransformQueue queue{buffer, "body", 1, [this](const Command& command) { released.push_back(command); },
                       [this](const Command&, const Refused& why) { refused.push_back(why.reason); }};
};

TEST_F(TransformQueueTest, TheBodysFrameNeedsNoTransform) {
  queue.add(cut("now", "body"));
  EXPECT_EQ(1u, released.size());
  EXPECT_TRUE(queue.empty());
}

TEST_F(TransformQueueTest, ACommandIsBroughtIntoTheBodysFrame) {
  publishKnife(10);
  queue.add(cut("there", "knife", 10 * SECOND));
  ASSERT_EQ(1u, released.size());
  EXPECT_EQ("body", released[0].frame);
  EXPECT_EQ(Vec3(0, 1, 0), std::get<PlaneCut>(released[0].action).point);
}

TEST_F(TransformQueueTest, ACommandWaitsForItsTransform) {
  queue.add(cut("early", "knife", 10 * SECOND));
  EXPECT_EQ(10 * SECOND, queue.earliestStamp());
  publishKnife(10);
  queue.poll(START);
  EXPECT_EQ(1u, released.size());
  EXPECT_FALSE(queue.earliestStamp());
}

TEST_F(TransformQueueTest, ACommandIsRefusedWhenItsTimeIsUp) {
  queue.add(cut("lost", "nowhere"));
  queue.poll(START + std::chrono::milliseconds(999));
  EXPECT_TRUE(refused.empty());
  queue.poll(START + seconds(1));
  ASSERT_EQ(1u, refused.size());
  EXPECT_NE(std::string::npos, refused[0].find("nowhere"));
}

TEST_F(TransformQueueTest, AStampAtTheEndOfTimeIsRefused) {
  publishKnife(10);
  queue.add(cut("end", "knife", 4294967295 * SECOND));
  queue.poll(START + seconds(1));
  EXPECT_EQ(1u, refused.size());
}

TEST_F(TransformQueueTest, PosesOfOneFrameKeepTheirOrder) {
  publishKnife(10);
  queue.add(pose(1, "knife", 11 * SECOND));
  queue.add(pose(2, "knife", 10 * SECOND));
  EXPECT_TRUE(released.empty());
  queue.add(pose(3, "body"));
  EXPECT_EQ(1u, released.size());
  publishKnife(11);
  queue.poll(START);
  ASSERT_EQ(3u, released.size());
  EXPECT_EQ(1, std::get<Pose>(released[1].action).position.x());
  EXPECT_EQ(2, std::get<Pose>(released[2].action).position.x());
}

TEST_F(TransformQueueTest, UnknownFramesMakeRoomForKnownOnes) {
  publishKnife(10);
  queue.add(cut("good", "knife", 11 * SECOND));
  for (std::size_t i = 0; i < 2 * MAX_WAITING_FOR_TRANSFORM; ++i) queue.add(cut("bad", "nowhere"));
  EXPECT_EQ(MAX_WAITING_FOR_TRANSFORM + 1, refused.size());
  publishKnife(11);
  queue.poll(START);
  ASSERT_EQ(1u, released.size());
  EXPECT_EQ("good", std::get<PlaneCut>(released[0].action).label);
}

}  // namespace
}  // namespace incision
