#include "incision/rigid/timed_pose.h"

#include <gtest/gtest.h>

#include "support/section.h"

namespace incision {
namespace {

TEST(TimedPoses, ArriveFromTheirList) {
  const std::vector<TimedPose> poses =
      parsePoses(test::section("poses", "[[0.5, 1, 2, 3, 0, 0, 0, 1], [1, 1, 2, 3, 0, 0, 1, 0]]"));
  ASSERT_EQ(poses.size(), 2u);
  EXPECT_EQ(poses[0].time, 0.5);
  EXPECT_EQ(poses[0].pose.position, Vec3(1, 2, 3));
  EXPECT_EQ(poses[1].time, 1);
  EXPECT_EQ(poses[1].pose.orientation.z(), 1);
}

TEST(TimedPoses, QuaternionsAreMadeUnitLength) {
  const std::vector<TimedPose> poses = parsePoses(test::section("poses", "[[0, 0, 0, 0, 0, 0, 0.7071, 0.7071]]"));
  EXPECT_NEAR(poses[0].pose.orientation.norm(), 1, 1e-15);  // rounding of one division
}

TEST(TimedPoses, BadValuesAreRefused) {
  test::expectRefused(parsePoses, "poses",
                      {{"1", ": '1' (allowed: a list)"},
                       {"[[0, 0, 0, 0, 0, 0, 1]]", ".0: a list of 7 (allowed: a list of 8)"},
                       {"[[-1, 0, 0, 0, 0, 0, 0, 1]]", ".0.0"},
                       {"[[0, 0, 0, 0, 0, 0, 0, 0]]", ".0: a quaternion of length 0"},
                       {"[[0, 0, 0, 0, 0, 0, 0, 1.02]]", ".0: a quaternion of length 1.02"},
                       {"[[0, 0, 0, 0, 0, 0, 0, 1], [0, 0, 0, 0, 0, 0, 0, 1]]", ".1: not later than the pose before"}});
}

}  // namespace
}  // namespace incision
