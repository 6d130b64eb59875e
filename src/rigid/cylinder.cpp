#include "incision/rigid/cylinder.h"

#include <algorithm>
#include <cmath>

#include "limits.h"
#include "solid_geometry.h"

namespace incision {

// In the plane through the axis and the point, the cylinder is a rectangle.
SolidDistance Cylinder::distanceTo(const Vec3& point) const {
  using Eigen::Vector2d;
  const Vector2d across = point.head<2>();
  const Vector2d radial = directionOf<2>(across, Vector2d::UnitX());
  const auto [distance, normal] =
      distanceToBox<2>(Vector2d(radius_, length_ / 2), Vector2d(across.stableNorm(), point.z()));
  return {distance, {normal[0] * radial[0], normal[0] * radial[1], normal[1]}};
}

SolidDistance Cylinder::distanceAgainst(const Vec3& point, const Vec3& n) const {
  return distanceAgainstFaces(*this, point, n, {Vec3(n.x(), n.y(), 0), Vec3(0, 0, n.z())});
}

double Cylinder::thickness() const { return std::min(2 * radius_, length_); }

double Cylinder::reachAlong(const Vec3& n) const {
  return radius_ * std::hypot(n.x(), n.y()) + length_ / 2 * std::abs(n.z());
}

double Cylinder::reach() const { return std::hypot(radius_, length_ / 2); }

void Cylinder::check(const std::string& where) const {
  checkLength(radius_, where + ": the cylinder's radius");
  checkLength(length_, where + ": the cylinder's length");
}

Drawing Cylinder::drawing() const { return {Drawing::Primitive::CYLINDER, Vec3(2 * radius_, 2 * radius_, length_)}; }

}  // namespace incision
