#pragma once

#include "incision/base/vec.h"

namespace incision {

/// A force and what it turns about a point, in axes that go with it.
struct Wrench {
  Vec3 force = Vec3::Zero();   ///< [N]
  Vec3 torque = Vec3::Zero();  ///< [N m]

  /// Both about one point.
  Wrench& operator+=(const Wrench& other) {
    force += other.force;
    torque += other.torque;
    return *this;
  }
};

inline Wrench operator*(double s, const Wrench& wrench) { return {s * wrench.force, s * wrench.torque}; }

/// A wrench about the origin as it is about a point [m].
Wrench about(const Vec3& point, const Wrench& wrench);

/// (1 − s) a + s b, both about one point.
Wrench between(const Wrench& a, const Wrench& b, double s);

}  // namespace incision
