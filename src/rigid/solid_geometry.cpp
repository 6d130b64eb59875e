#include "solid_geometry.h"

#include <limits>

namespace incision {

SolidDistance distanceAgainstFaces(const Solid& solid, const Vec3& point, const Vec3& n,
                                   std::initializer_list<Vec3> shares) {
  SolidDistance nearest{-std::numeric_limits<double>::infinity(), -n};
  for (const Vec3& share : shares) {
    if (!(share.norm() > LEAST_OPPOSITION)) continue;
    const Vec3 normal = -share.normalized();
    const double distance = normal.dot(point) - solid.reachAlong(normal);
    if (distance > nearest.distance) nearest = {distance, normal};
  }
  return nearest;
}

}  // namespace incision
