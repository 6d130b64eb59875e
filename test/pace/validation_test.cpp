#include "incision/pace/validation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "incision/base/limits.h"
#include "incision/scene/scene.h"

namespace incision {
namespace {

Pose poseAt(double x, double w = 1) { return {Vec3(x, 0, 0), Eigen::Quaterniond(w, 0, 0, 0)}; }

PlaneCut cut() {
  PlaneCut plane;
  plane.normal = Vec3::UnitX();
  return plane;
}

TEST(Validation, WhatIsFiniteAndInRangeIsTaken) {
  EXPECT_FALSE(whyRefused(poseAt(-MAX_COORDINATE)));
  EXPECT_FALSE(whyRefused(poseAt(0, 1 + 0.9 * QUATERNION_TOLERANCE)));
  EXPECT_FALSE(whyRefused(cut()));
  EXPECT_FALSE(whyRefusedFrame(std::string(MAX_NAME, 'f')));
}

TEST(Validation, ValuesThatAreNotFiniteAreToldFromThoseOutOfRange) {
  for (const double bad : {HUGE_VAL, std::nan("")}) {
    EXPECT_EQ(Refusal::NOT_FINITE, whyRefused(poseAt(bad)).value().kind);
    EXPECT_EQ(Refusal::NOT_FINITE, whyRefused(poseAt(0, bad)).value().kind);
    PlaneCut plane = cut();
    plane.length = bad;
    EXPECT_EQ(Refusal::NOT_FINITE, whyRefused(plane).value().kind);
  }
  EXPECT_EQ(Refusal::OUT_OF_RANGE, whyRefused(poseAt(1.1 * MAX_COORDINATE)).value().kind);
  for (const double length : {0.0, 1 - 1.1 * QUATERNION_TOLERANCE, 1e308})
    EXPECT_EQ(Refusal::OUT_OF_RANGE, whyRefused(poseAt(0, length)).value().kind);
}

TEST(Validation, NoNormalAndNamesThatAreTooLongAreOutOfRange) {
  PlaneCut plane = cut();
  plane.normal.setZero();
  EXPECT_EQ(Refusal::OUT_OF_RANGE, whyRefused(plane).value().kind);
  plane = cut();
  plane.label.assign(MAX_LABEL + 1, 'l');
  EXPECT_EQ(Refusal::OUT_OF_RANGE, whyRefused(plane).value().kind);
  EXPECT_TRUE(whyRefusedFrame(std::string(MAX_NAME + 1, 'f')));
}

}  // namespace
}  // namespace incision
