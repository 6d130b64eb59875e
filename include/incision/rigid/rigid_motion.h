#pragma once

#include "incision/rigid/pose.h"

namespace incision {

/// The even motion of a rigid thing over a step.
struct RigidMotion {
  Pose from, to;  ///< when the step starts and when it ends

  /// Where it is when this share of the step has passed, from 0 to 1.
  Pose at(double share) const {
    if (share == 0) return from;
    return share == 1 ? to : between(from, to, share);
  }
};

}  // namespace incision
