#pragma once

#include <string>

#include "incision/pace/command.h"

namespace incision {

constexpr Nanoseconds MILLISECOND = 1'000'000, SECOND = 1000 * MILLISECOND;

/// When tests begin, by the steady clock.
const SteadyTime START{std::chrono::seconds(100)};

constexpr double TIME_STEP = 0.01;

/// Of coordinates below 10.
constexpr double POSE_ROUNDING = 1e-14;

inline PlaneCut labelled(const std::string& label) {
  PlaneCut plane;
  plane.label = label;
  return plane;
}

inline Pose poseAt(double x, double y = 0) { return {Vec3(x, y, 0), Eigen::Quaterniond::Identity()}; }

}  // namespace incision
