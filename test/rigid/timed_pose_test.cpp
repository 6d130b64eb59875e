#include "incision/rigid/timed_pose.h"

#include <gtest/gtest.h>

#include "support/section.h"
#include "support/test_file.h"

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

TEST(TimedPoses, ArriveFromAFile) {
  const test::TestFile file("poses.csv", "t,x,y,z,qx,qy,qz,qw\n0.5,1,2,3,0,0,0,1\r\n\n1, 1, 2, 3, 0, 0, 1, 0\n");
  const std::vector<TimedPose> poses = readPoses(file.path());
  EXPECT_EQ(poses, parsePoses(test::section("poses", "[[0.5, 1, 2, 3, 0, 0, 0, 1], [1, 1, 2, 3, 0, 0, 1, 0]]")));
}

TEST(TimedPoses, OfAFileWithTimesOfTheClockCountFromTheFirst) {
  const test::TestFile file("poses.csv", "1700000000.25,1,2,3,0,0,0,1\n1700000001.75,1,2,3,0,0,0,1\n");
  const std::vector<TimedPose> poses = readPoses(file.path());
  ASSERT_EQ(poses.size(), 2u);
  EXPECT_EQ(poses[0].time, 0);
  EXPECT_EQ(poses[1].time, 1.5);
}

TEST(TimedPoses, BadFilesAreRefusedWithTheLine) {
  for (const auto& [text, reason] : std::vector<std::pair<std::string, std::string>>{
           {"", ":1: nothing"},
           {"t,x\n", ":1: nothing"},
           {"0,1,2,3,0,0,0,1\n1,1,2,3,0,0,0\n", ":2: qw is missing"},
           {"0,1,2,3,0,0,0,1,5\n", ":1: the line should have ended"},
           {"0,1,2,x,0,0,0,1\n", ":1: z: \"x\" is not a number"},
           {"0,1,2,3,0,0,0,2\n", ":1: a quaternion of length 2"},
           {"-1,1,2,3,0,0,0,1\n", ":1: t: -1"},
           {"1,1,2,3,0,0,0,1\n1,1,2,3,0,0,0,1\n", ":2: not later than the one before it"}}) {
    const test::TestFile file("poses.csv", text);
    try {
      readPoses(file.path());
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
    }
  }
  EXPECT_THROW(readPoses("/no/such/file.csv"), InputError);
}

TEST(TimedPoses, AreInterpolatedAndStayBeforeAndAfter) {
  const std::vector<TimedPose> poses =
      parsePoses(test::section("poses", "[[1, 0, 0, 0, 0, 0, 0, 1], [3, 4, 0, 0, 0, 0, 1, 0]]"));
  for (const auto& [time, share] : {std::pair(0.0, 0.0), {1.0, 0.0}, {1.5, 0.25}, {3.0, 1.0}, {9.0, 1.0}}) {
    const Pose pose = poseAt(poses, time);
    EXPECT_NEAR(pose.position.x(), 4 * share, 1e-15) << time;
    EXPECT_NEAR(pose.orientation.angularDistance(poses[0].pose.orientation), share * M_PI, 1e-7) << time;
  }
}

TEST(TimedPoses, BadValuesAreRefused) {
  test::expectRefused(parsePoses, "poses",
                      {{"1", ": '1' (allowed: a list)"},
                       {"[[0, 0, 0, 0, 0, 0, 1]]", ".0: a list of 7 (allowed: a list of 8)"},
                       {"[[-1, 0, 0, 0, 0, 0, 0, 1]]", ".0.0"},
                       {"[[0, 0, 0, 0, 0, 0, 0, 0]]", ".0: a quaternion of length 0"},
                       {"[[0, 0, 0, 0, 0, 0, 0, 1.02]]", ".0: a quaternion of length 1.02"},
                       {"[[0, 0, 0, 0, 0, 0, 0, 1], [0, 0, 0, 0, 0, 0, 0, 1]]", ".1: not later than the one before"}});
}

}  // namespace
}  // namespace incision
