#include "incision/rigid/half_space.h"

#include <limits>

#include "solid_geometry.h"

namespace incision {

SolidDistance HalfSpace::distanceTo(const Vec3& point) const { return {point.z(), Vec3::UnitZ()}; }

SolidDistance HalfSpace::distanceAgainst(const Vec3& point, const Vec3& n) const {
  return distanceAgainstFaces(*this, point, n, {Vec3(0, 0, n.z())});
}

double HalfSpace::thickness() const { return std::numeric_limits<double>::infinity(); }

double HalfSpace::reachAlong(const Vec3& n) const { return n.z() == 1 ? 0 : std::numeric_limits<double>::infinity(); }

double HalfSpace::reach() const { return std::numeric_limits<double>::infinity(); }

Drawing HalfSpace::drawing() const { return {Drawing::Primitive::HALF_SPACE, Vec3::Zero()}; }

}  // namespace incision
