#include "incision/rigid/sphere.h"

#include "limits.h"
#include "solid_geometry.h"

namespace incision {

SolidDistance Sphere::distanceTo(const Vec3& point) const {
  return {point.stableNorm() - radius_, directionOf<3>(point, Vec3::UnitZ())};
}

SolidDistance Sphere::distanceAgainst(const Vec3& point, const Vec3& n) const {
  return distanceAgainstFaces(*this, point, n, {n});
}

double Sphere::thickness() const { return 2 * radius_; }

double Sphere::reachAlong(const Vec3&) const { return radius_; }

double Sphere::reach() const { return radius_; }

void Sphere::check(const std::string& where) const { checkLength(radius_, where + ": the sphere's radius"); }

Drawing Sphere::drawing() const { return {Drawing::Primitive::SPHERE, Vec3::Constant(2 * radius_)}; }

}  // namespace incision
