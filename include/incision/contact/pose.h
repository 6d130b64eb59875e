#pragma once

#include <Eigen/Geometry>

#include "incision/mesh/tet_mesh.h"

namespace incision {

/// Where a rigid thing stands: turned, then moved, it comes from its own frame into another.
struct Pose {
  Vec3 position = Vec3::Zero();                                     ///< [m]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< of length 1
};

/// The pose in the outer frame of what stands at `inner` in a frame that stands at `outer`.
Pose composed(const Pose& outer, const Pose& inner);

/// The pose a share `s`, from 0 to 1, of the even way from `a` to `b`.
Pose between(const Pose& a, const Pose& b, double s);

}  // namespace incision
