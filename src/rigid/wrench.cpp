#include "incision/rigid/wrench.h"

#include <Eigen/Geometry>

namespace incision {

Wrench about(const Vec3& point, const Wrench& wrench) {
  return {wrench.force, wrench.torque - point.cross(wrench.force)};
}

Wrench between(const Wrench& a, const Wrench& b, double s) {
  return {(1 - s) * a.force + s * b.force, (1 - s) * a.torque + s * b.torque};
}

}  // namespace incision
