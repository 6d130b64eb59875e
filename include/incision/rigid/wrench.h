#pragma once

#include "incision/base/vec.h"

namespace incision {

/// A force and what it turns about a point, in axes that go with it.
struct Wrench {
  Vec3 force = Vec3::Zero();   ///< [N]
  Vec3 torque = Vec3::Zero();  ///< [N m]
};

/// (1 − s) a + s b, both about one point.
Wrench between(const Wrench& a, const Wrench& b, double s);

}  // namespace incision
