#include "incision/ros/demo/tool_path.h"

#include <gtest/gtest.h>

#include <cmath>

namespace incision {
namespace {

constexpr double SPEED = 0.5;  // [m/s]
constexpr double EPS = 1e-14;  // some ε of the numbers of order one here

Pose poseAt(double x, double y, double yaw = 0) {
  return {{x, y, 0}, Eigen::Quaterniond(Eigen::AngleAxisd(yaw, Vec3::UnitZ()))};
}

double yawOf(const Pose& pose) { return 2 * std::atan2(pose.orientation.z(), pose.orientation.w()); }

TEST(ToolPath, SpeedIsEvenAlongLegsOfUnevenLength) {
  const ToolPath path({poseAt(0, 0), poseAt(1, 0), poseAt(1, 3)}, SPEED, false);
  EXPECT_DOUBLE_EQ(8, path.duration());
  for (double t = 0; t <= 8; t += 0.25) {
    const double s = SPEED * t;
    const Vec3 expected(std::min(s, 1.0), std::max(s - 1, 0.0), 0);
    EXPECT_LE((path.at(t).position - expected).norm(), EPS) << t;
  }
}

TEST(ToolPath, OrientationTurnsEvenlyAlongALeg) {
  const ToolPath path({poseAt(0, 0, 0.2), poseAt(1, 0, 1.0)}, SPEED, false);
  for (double t = 0; t <= 2; t += 0.25) EXPECT_NEAR(0.2 + 0.4 * t, yawOf(path.at(t)), EPS) << t;
}

TEST(ToolPath, StaysAtItsEnd) {
  const ToolPath path({poseAt(0, 0), poseAt(1, 0, 0.3)}, SPEED, false);
  EXPECT_EQ(Vec3(1, 0, 0), path.at(1e6).position);
  EXPECT_NEAR(0.3, yawOf(path.at(1e6)), EPS);
}

TEST(ToolPath, ALoopClosesWithALegOfItsOwn) {
  const ToolPath path({poseAt(0, 0), poseAt(1, 0), poseAt(1, 1)}, 1, true);
  EXPECT_TRUE(std::isinf(path.duration()));
  const double lap = 2 + std::sqrt(2);
  EXPECT_LE((path.at(2 + std::sqrt(0.5)).position - Vec3(0.5, 0.5, 0)).norm(), EPS);
  for (const double t : {0.3, 1.7, 2.9}) {
    // Time is known to 100 laps times ε.
    EXPECT_LE((path.at(t).position - path.at(t + 100 * lap).position).norm(), 1e-12) << t;
  }
}

TEST(ToolPath, OneWaypointIsAPlaceToStay) {
  for (const bool loop : {false, true}) {
    const ToolPath path({poseAt(0.4, 0.7)}, SPEED, loop);
    EXPECT_EQ(0, path.duration());
    EXPECT_EQ(Vec3(0.4, 0.7, 0), path.at(0).position);
    EXPECT_EQ(Vec3(0.4, 0.7, 0), path.at(5).position);
  }
}

}  // namespace
}  // namespace incision
