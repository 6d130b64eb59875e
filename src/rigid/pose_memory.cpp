// What poses of a memory must be.
#include <cmath>

#include "incision/base/limits.h"
#include "incision/rigid/rigid_motion.h"

namespace incision {

void check(const Pose& pose, const MemoryLimits& /*limits*/) {
  require(pose.position.cwiseAbs().maxCoeff() <= MAX_COORDINATE, "a pose is too far away");
  require(std::abs(pose.orientation.norm() - 1) <= QUATERNION_TOLERANCE, "a pose's quaternion has not the length 1");
}

void check(const RigidMotion& motion, const MemoryLimits& limits) {
  check(motion.from, limits);
  check(motion.to, limits);
}

}  // namespace incision
