#include "incision/rigid/rigid_motion.h"

#include <gtest/gtest.h>

#include <cmath>

namespace incision {
namespace {

constexpr double ROUNDING = 1e-14;  // of coordinates below 10

const Vec3 AXIS = Vec3(1, 2, -2) / 3;
constexpr double TURN = 2.5;

const RigidMotion MOTION = {{Vec3(1, -2, 3), Eigen::Quaterniond(Eigen::AngleAxisd(0.7, Vec3::UnitY()))},
                            {Vec3(-4, 5, 6), Eigen::Quaterniond(Eigen::AngleAxisd(TURN, AXIS)) *
                                                 Eigen::Quaterniond(Eigen::AngleAxisd(0.7, Vec3::UnitY()))}};

double distanceOf(const Pose& a, const Pose& b) {
  return (a.position - b.position).norm() + (a.orientation.matrix() - b.orientation.matrix()).norm();
}

TEST(RigidMotion, StartsAndEndsAtItsPoses) {
  EXPECT_LT(distanceOf(MOTION.at(0), MOTION.from), ROUNDING);
  EXPECT_LT(distanceOf(MOTION.at(1), MOTION.to), ROUNDING);
}

TEST(RigidMotion, IsEven) {
  for (const double share : {0.125, 0.5, 0.9}) {
    const Eigen::Quaterniond turned(Eigen::AngleAxisd(share * TURN, AXIS));
    const Vec3 moved = share * (MOTION.to.position - MOTION.from.position);
    EXPECT_LT(distanceOf(MOTION.at(share), {MOTION.from.position + moved, turned * MOTION.from.orientation}), ROUNDING);
  }
}

TEST(RigidMotion, OfTwoHalvesIsThatOfTheWhole) {
  const Pose middle = MOTION.at(0.5);
  for (const double share : {0.25, 0.5, 0.75}) {
    EXPECT_LT(distanceOf(RigidMotion{MOTION.from, middle}.at(share), MOTION.at(share / 2)), ROUNDING);
    EXPECT_LT(distanceOf(RigidMotion{middle, MOTION.to}.at(share), MOTION.at((1 + share) / 2)), ROUNDING);
  }
}

}  // namespace
}  // namespace incision
