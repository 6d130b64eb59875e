#pragma once

#include "incision/base/memory_limits.h"
#include "incision/rigid/pose.h"

namespace incision {

/// How a rigid thing moves over a step: its origin on a straight line, turning about one axis, both at an even rate.
struct RigidMotion {
  Pose from;  ///< when the step starts
  Pose to;    ///< when it ends

  /// The pose when a share of the step, from 0 to 1, is over.
  Pose at(double share) const { return between(from, to, share); }
};

template <class Archive>
void serialize(Archive& archive, RigidMotion& motion) {
  auto& [from, to] = motion;
  archive(from, to);
}

void check(const RigidMotion& motion, const MemoryLimits& limits);

}  // namespace incision
