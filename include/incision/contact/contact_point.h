#pragma once

#include "incision/base/vec.h"

namespace incision {

/// A point of the body's surface that was pressed in a step.
struct ContactPoint {
  Vec3 point = Vec3::Zero();   ///< at the step's end [m]
  Vec3 normal = Vec3::Zero();  ///< unit, from what presses to the body
  Vec3 force = Vec3::Zero();   ///< on the body [N]
  double depth = 0;            ///< how far it is inside at the step's end [m]
  int partner = -1;            ///< shape of the obstacles or of the tool; negative: the body itself
  int tool = -1;               ///< whose shape it is; −1: none's
};

}  // namespace incision
