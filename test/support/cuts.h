#pragma once

#include "incision/cut/crack.h"

namespace incision {

inline PlaneCut plane(const Vec3& point, const Vec3& normal) {
  PlaneCut cut;
  cut.point = point;
  cut.normal = normal;
  return cut;
}

/// A rectangle of `length` along `tangent` and `width` across; 0: unbounded.
inline PlaneCut rectangle(const Vec3& point, const Vec3& normal, const Vec3& tangent, double length, double width) {
  PlaneCut cut = plane(point, normal);
  cut.tangent = tangent;
  cut.length = length;
  cut.width = width;
  return cut;
}

}  // namespace incision
