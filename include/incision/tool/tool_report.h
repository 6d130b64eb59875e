#pragma once

#include "incision/base/vec.h"

namespace incision {

/// What a tool and the tissue did to each other in a step.
struct ToolReport {
  bool touching = false;       ///< they acted on each other, or an edge is in the tissue
  Vec3 force = Vec3::Zero();   ///< of the tissue on the tool, in the frame of the tool's link [N]
  Vec3 torque = Vec3::Zero();  ///< likewise, about the link's origin [N m]
  double depth = 0;            ///< how far an edge has come below the skin, at rest [m]; 0 outside
  double stroke_area = 0;      ///< that the stroke under way, or the last one, has cut, at rest [m²]
  double jaw = 0;              ///< angle of the joint [rad]
  double jaw_torque = 0;       ///< of the tissue on the joint; positive where it would open it [N m]
  double gripped = 0;          ///< the most force with which the jaws can hold what lies between them now [N]
};

}  // namespace incision
