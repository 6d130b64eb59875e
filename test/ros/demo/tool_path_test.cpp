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

Waypoint waypointAt(double x, double y, double yaw = 0) { return {{poseAt(x, y, yaw)}}; }

double yawOf(const Pose& pose) { return 2 * std::atan2(pose.orientation.z(), pose.orientation.w()); }

TEST(ToolPath, SpeedIsEvenAlongLegsOfUnevenLength) {
  const ToolPath path({waypointAt(0, 0), waypointAt(1, 0), waypointAt(1, 3)}, SPEED, false);
  EXPECT_DOUBLE_EQ(8, path.duration());
  for (double t = 0; t <= 8; t += 0.25) {
    const double s = SPEED * t;
    const Vec3 expected(std::min(s, 1.0), std::max(s - 1, 0.0), 0);
    EXPECT_LE((path.at(t).pose.position - expected).norm(), EPS) << t;
  }
}

TEST(ToolPath, OrientationTurnsEvenlyAlongALeg) {
  const ToolPath path({waypointAt(0, 0, 0.2), waypointAt(1, 0, 1.0)}, SPEED, false);
  for (double t = 0; t <= 2; t += 0.25) EXPECT_NEAR(0.2 + 0.4 * t, yawOf(path.at(t).pose), EPS) << t;
}

TEST(ToolPath, StaysAtItsEnd) {
  const ToolPath path({waypointAt(0, 0), waypointAt(1, 0, 0.3)}, SPEED, false);
  EXPECT_EQ(Vec3(1, 0, 0), path.at(1e6).pose.position);
  EXPECT_NEAR(0.3, yawOf(path.at(1e6).pose), EPS);
}

TEST(ToolPath, ALoopClosesWithALegOfItsOwn) {
  const ToolPath path({waypointAt(0, 0), waypointAt(1, 0), waypointAt(1, 1)}, 1, true);
  EXPECT_TRUE(std::isinf(path.duration()));
  const double lap = 2 + std::sqrt(2);
  EXPECT_LE((path.at(2 + std::sqrt(0.5)).pose.position - Vec3(0.5, 0.5, 0)).norm(), EPS);
  for (const double t : {0.3, 1.7, 2.9}) {
    // Time is known to 100 laps times ε.
    EXPECT_LE((path.at(t).pose.position - path.at(t + 100 * lap).pose.position).norm(), 1e-12) << t;
  }
}

TEST(ToolPath, OneWaypointIsAPlaceToStay) {
  for (const bool loop : {false, true}) {
    const ToolPath path({waypointAt(0.4, 0.7)}, SPEED, loop);
    EXPECT_EQ(0, path.duration());
    EXPECT_EQ(Vec3(0.4, 0.7, 0), path.at(0).pose.position);
    EXPECT_EQ(Vec3(0.4, 0.7, 0), path.at(5).pose.position);
  }
}

TEST(ToolPath, ALegLastsAsLongAsItsTimeAndTheSpeedAskFor) {
  const ToolPath path({{{poseAt(0, 0)}, 3}, {{poseAt(0, 0)}, 1}, {{poseAt(1, 0)}, 4}, {{poseAt(2, 0)}}}, SPEED, false);
  EXPECT_DOUBLE_EQ(3 + 2 + 4, path.duration());  // waits, as the speed has it, as the time has it
  const auto xAt = [&](double time) { return path.at(time).pose.position.x(); };
  EXPECT_EQ(0, xAt(2.9));
  EXPECT_NEAR(0.5, xAt(4), EPS);
  EXPECT_NEAR(1.25, xAt(6), EPS);
}

TEST(ToolPath, TheJawTurnsEvenlyOnEachLeg) {
  const ToolPath path({{{poseAt(0, 0), 0.6}, 2}, {{poseAt(0, 0), 0.2}}, {{poseAt(1, 0), 0.4}}}, SPEED, true);
  for (double t = 0; t <= 2; t += 0.25) EXPECT_NEAR(0.6 - 0.2 * t, path.at(t).jaw, EPS) << t;
  for (double t = 0; t <= 2; t += 0.25) EXPECT_NEAR(0.2 + 0.1 * t, path.at(2 + t).jaw, EPS) << t;
  for (double t = 0; t <= 1.75; t += 0.25) EXPECT_NEAR(0.4 + 0.1 * t, path.at(4 + t).jaw, EPS) << t;
}

}  // namespace
}  // namespace incision
