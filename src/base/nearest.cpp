#include "incision/base/nearest.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace incision {

Vec3 nearestOnSegment(const Vec3& a, const Vec3& b, const Vec3& point) {
  const Vec3 along = b - a;
  const double length = along.squaredNorm();
  return a + (length > 0 ? std::clamp((point - a).dot(along) / length, 0.0, 1.0) : 0.0) * along;
}

/// The foot in the triangle's plane where that lies inside, else the nearest point of its three edges.
Vec3 nearestOnTriangle(const std::array<Vec3, 3>& triangle, const Vec3& point) {
  const Vec3 normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  bool inside = normal.squaredNorm() > 0;
  Vec3 best = triangle[0];
  for (int i = 0; i < 3; ++i) {
    const Vec3 &a = triangle[i], &b = triangle[(i + 1) % 3];
    inside = inside && (b - a).cross(point - a).dot(normal) >= 0;
    const Vec3 near = nearestOnSegment(a, b, point);
    if ((near - point).squaredNorm() < (best - point).squaredNorm()) best = near;
  }
  return inside ? Vec3(point - (point - triangle[0]).dot(normal) / normal.squaredNorm() * normal) : best;
}

}  // namespace incision
