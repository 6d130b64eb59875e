#pragma once

#include <Eigen/Geometry>

#include "incision/mesh/tet_mesh.h"

namespace incision {

/// Where a rigid thing stands: turned, then moved, it comes from its own frame into another.
struct Pose {
  Vec3 position = Vec3::Zero();                                     ///< [m]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< of length 1
};

}  // namespace incision
