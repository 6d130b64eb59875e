#include "incision/pace/transform_queue.h"

#include <gtest/gtest.h>

#include "pace/frames_in_tests.h"
#include "pace/things_in_tests.h"

namespace incision {
namespace {

using std::chrono::seconds;

/// A queue with a timeout of one second, and what came out of it.
struct TransformQueueTest : testing::Test {
  Command cut(const std::string& label, const std::string& frame, Nanoseconds stamp = 0) {
    PlaneCut plane;
    plane.label = label;
    return {plane, frame, stamp, START};
  }
  Command pose(double x, const std::string& frame, Nanoseconds stamp = 0, int tool = 0) {
    return {ToolPose{tool, {Vec3(x, 0, 0), Eigen::Quaterniond::Identity()}}, frame, stamp, START};
  }
  double xOf(const Command& command) { return std::get<ToolPose>(command.action).pose.position.x(); }
  /// The frame `knife` lies one metre along y, at this time.
  void publishKnife(Nanoseconds time) { frames.set("knife", time, {Vec3::UnitY(), Eigen::Quaterniond::Identity()}); }

  FramesInTests frames;
  std::vector<Command> released;
  std::vector<std::string> refused;
  TransformQueue queue{frames, 1, [this](const Command& command) { released.push_back(command); },
                       [this](const Command&, const Refused& why) { refused.push_back(why.reason); }};
};

TEST_F(TransformQueueTest, TheBodysFrameNeedsNoTransform) {
  queue.add(cut("now", "body"));
  EXPECT_EQ(1u, released.size());
  EXPECT_TRUE(queue.empty());
}

TEST_F(TransformQueueTest, ACommandIsBroughtIntoTheBodysFrame) {
  publishKnife(10 * SECOND);
  queue.add(cut("there", "knife", 10 * SECOND));
  ASSERT_EQ(1u, released.size());
  EXPECT_EQ("body", released[0].frame);
  EXPECT_EQ(Vec3(0, 1, 0), std::get<PlaneCut>(released[0].action).point);
}

TEST_F(TransformQueueTest, ACommandWaitsForItsTransform) {
  queue.add(cut("early", "knife", 10 * SECOND));
  EXPECT_EQ(10 * SECOND, queue.earliestStamp());
  publishKnife(10 * SECOND);
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

TEST_F(TransformQueueTest, PosesOfOneFrameKeepTheirOrder) {
  publishKnife(10 * SECOND);
  queue.add(pose(1, "knife", 11 * SECOND));
  queue.add(pose(2, "knife", 10 * SECOND));
  EXPECT_TRUE(released.empty());
  queue.add(pose(3, "body"));
  EXPECT_EQ(1u, released.size());
  publishKnife(11 * SECOND);
  queue.poll(START);
  ASSERT_EQ(3u, released.size());
  EXPECT_EQ(1, xOf(released[1]));
  EXPECT_EQ(2, xOf(released[2]));
}

TEST_F(TransformQueueTest, PosesOfOneToolWaitForNoOther) {
  publishKnife(10 * SECOND);
  queue.add(pose(1, "knife", 11 * SECOND, 0));
  queue.add(pose(2, "knife", 10 * SECOND, 1));
  ASSERT_EQ(1u, released.size());
  EXPECT_EQ(2, xOf(released[0]));
}

TEST_F(TransformQueueTest, UnknownFramesMakeRoomForKnownOnes) {
  publishKnife(10 * SECOND);
  queue.add(cut("good", "knife", 11 * SECOND));
  for (std::size_t i = 0; i < 2 * MAX_WAITING_FOR_TRANSFORM; ++i) queue.add(cut("bad", "nowhere"));
  EXPECT_EQ(MAX_WAITING_FOR_TRANSFORM + 1, refused.size());
  publishKnife(11 * SECOND);
  queue.poll(START);
  ASSERT_EQ(1u, released.size());
  EXPECT_EQ("good", std::get<PlaneCut>(released[0].action).label);
}

}  // namespace
}  // namespace incision
