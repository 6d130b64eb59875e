#pragma once

#include <Eigen/Geometry>

#include "incision/rigid/pose.h"

namespace incision::test {

/// A frame that stands beside the body and turns about a slanted axis as it goes [s].
inline Pose turningFrame(double time) {
  const Eigen::AngleAxisd turn(1.5 * time, Vec3(1, 2, 0.5).normalized());
  return {Vec3(0.4 + 0.1 * time, -0.3, 0.2 * time), turn * Eigen::Quaterniond(0.6, 0, 0.8, 0)};
}

/// Where what goes with the frame is when this stands at `now`, if it was at `x` when that stood at `first`.
inline Vec3 carried(const Pose& first, const Pose& now, const Vec3& x) {
  return now.position + now.orientation * (first.orientation.conjugate() * (x - first.position));
}

}  // namespace incision::test
