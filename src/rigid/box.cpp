#include "incision/rigid/box.h"

#include "limits.h"
#include "solid_geometry.h"

namespace incision {

SolidDistance Box::distanceTo(const Vec3& point) const {
  const auto [distance, normal] = distanceToBox<3>(size_ / 2, point);
  return {distance, normal};
}

SolidDistance Box::distanceAgainst(const Vec3& point, const Vec3& n) const {
  return distanceAgainstFaces(*this, point, n, {Vec3(n.x(), 0, 0), Vec3(0, n.y(), 0), Vec3(0, 0, n.z())});
}

double Box::thickness() const { return size_.minCoeff(); }

double Box::reachAlong(const Vec3& n) const { return n.cwiseAbs().dot(size_) / 2; }

double Box::reach() const { return size_.norm() / 2; }

std::optional<Edge> Box::edge() const {
  int axis = 0;
  size_.maxCoeff(&axis);
  const Vec3 begin = -size_ / 2;
  Vec3 end = begin;
  end[axis] = -begin[axis];
  return Edge{begin, end};
}

void Box::check(const std::string& where) const {
  for (const double size : size_) checkLength(size, where + ": the box's size");
}

Drawing Box::drawing() const { return {Drawing::Primitive::BOX, size_}; }

}  // namespace incision
