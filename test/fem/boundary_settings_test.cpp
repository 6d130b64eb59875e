#include "incision/fem/boundary_settings.h"

#include <gtest/gtest.h>

#include "support/section.h"

namespace incision {
namespace {

TEST(BoundarySettings, ArriveFromTheirSections) {
  const Clamp clamp = parseClamp(test::section("boundary.0", "{box: [[-1, -2, -3], [1, 2, 3]], velocity: [4, 5, 6]}"));
  EXPECT_EQ(clamp.place.box.min, Vec3(-1, -2, -3));
  EXPECT_EQ(clamp.place.box.max, Vec3(1, 2, 3));
  EXPECT_EQ(clamp.velocity, Vec3(4, 5, 6));
  const Load load =
      parseLoad(test::section("loads.0", "{box: [[0, 0, 0], [1, 1, 1]], traction: [7, 8, 9], ramp: 0.5}"));
  EXPECT_EQ(load.place.box.max, Vec3(1, 1, 1));
  EXPECT_EQ(load.traction, Vec3(7, 8, 9));
  EXPECT_EQ(load.ramp, 0.5);
}

TEST(BoundarySettings, OfClampsMayHaveAFrameAndPoses) {
  const Clamp clamp =
      parseClamp(test::section("boundary.0", "{group: rib, frame: rib_link, poses: [[0, 1, 2, 3, 0, 0, 0, 1]]}"));
  EXPECT_EQ(clamp.place.group, "rib");
  EXPECT_EQ(clamp.frame, "rib_link");
  ASSERT_EQ(clamp.poses.size(), 1u);
  EXPECT_EQ(clamp.poses[0].pose.position, Vec3(1, 2, 3));
  EXPECT_TRUE(clamp.isPosed());
  EXPECT_EQ(parseClamp(test::section("boundary.0", "{group: rib, poses_file: a.csv}")).poses_file, "/folder/a.csv");
}

TEST(BoundarySettings, OfLoadsMayHaveAPressure) {
  const Load load = parseLoad(test::section("loads.0", "{group: skin, pressure: -200}"));
  EXPECT_EQ(load.pressure, -200);
  EXPECT_EQ(load.traction, Vec3::Zero());
}

TEST(BoundarySettings, ClampsMoveAlikeByOneFrameOneVelocityOrTheSamePoses) {
  const Clamp still, moving{Place(), Vec3::UnitX()}, framed{Place(), Vec3::Zero(), "rib"};
  Clamp posed{Place(), Vec3::Zero(), "", {{0, Pose()}}}, elsewhere = posed;
  elsewhere.poses[0].pose.position.x() = 1;
  const std::vector<Clamp> clamps = {still, moving, framed, posed, elsewhere};
  for (std::size_t i = 0; i < clamps.size(); ++i)
    for (std::size_t j = 0; j < clamps.size(); ++j) EXPECT_EQ(moveAlike(clamps[i], clamps[j]), i == j) << i << j;
}

TEST(BoundarySettings, BadValuesAreRefused) {
  test::expectRefused(parseClamp, "boundary.0",
                      {{"{velocity: [0, 0, 0]}", ": needs a group or a box (allowed: one of the two)"},
                       {"{box: 1}", ".box: '1' (allowed: a list of 2)"},
                       {"{group: a, frame: b, velocity: [0, 0, 0]}", ".velocity: beside a frame or poses"},
                       {"{group: a, poses_file: b, velocity: [0, 0, 0]}", ".velocity: beside a frame or poses"},
                       {"{group: a, poses: [], poses_file: b}", ".poses_file: beside poses (allowed: one of the two)"},
                       {"{group: a, frame: /b}", ".frame"},
                       {"{box: [[0, 0, 0], [1, 1]]}", ".box.1: a list of 2 (allowed: a list of 3)"},
                       {"{box: [[0, 0, 1], [1, 1, 0]]}", ".box: a lower corner above the upper"}});
  test::expectRefused(parseLoad, "loads.0",
                      {{"{box: [[0, 0, 0], [1, 1, 1]]}", ": needs a traction or a pressure"},
                       {"{box: [[0, 0, 0], [1, 1, 1]], traction: [1, 0, 0], ramp: -1}", ".ramp"}});
}

}  // namespace
}  // namespace incision
