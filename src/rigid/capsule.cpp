#include "incision/rigid/capsule.h"

#include <algorithm>
#include <cmath>

#include "limits.h"
#include "solid_geometry.h"

namespace incision {

// A ball whose centre is the point of the axis that is nearest.
SolidDistance Capsule::distanceTo(const Vec3& point) const {
  const Vec3 centre(0, 0, std::clamp(point.z(), -length_ / 2, length_ / 2));
  const Vec3 from_centre = point - centre;
  return {from_centre.stableNorm() - radius_, directionOf<3>(from_centre, Vec3::UnitX())};
}

// The round side, and the ends, which have a place for every normal.
SolidDistance Capsule::distanceAgainst(const Vec3& point, const Vec3& n) const {
  return distanceAgainstFaces(*this, point, n, {Vec3(n.x(), n.y(), 0), n});
}

double Capsule::thickness() const { return 2 * radius_; }

double Capsule::reachAlong(const Vec3& n) const { return radius_ + length_ / 2 * std::abs(n.z()); }

double Capsule::reach() const { return radius_ + length_ / 2; }

void Capsule::check(const std::string& where) const {
  checkLength(radius_, where + ": the capsule's radius");
  checkLength(length_, where + ": the capsule's length");
}

Drawing Capsule::drawing() const {
  return {Drawing::Primitive::CAPSULE, Vec3(2 * radius_, 2 * radius_, length_ + 2 * radius_)};
}

}  // namespace incision
