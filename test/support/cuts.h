#pragma once

#include "incision/cut/crack.h"
#include "incision/mesh/grid_settings.h"

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

/// 1 m wide, of 4 × 4 × 4 cells.
const GridSettings CUBE = {{4, 4, 4}, Vec3::Ones(), Vec3::Zero()};

}  // namespace incision
