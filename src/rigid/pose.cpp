#include "incision/rigid/pose.h"

#include "incision/base/nearest.h"

namespace incision {

bool operator==(const Pose& a, const Pose& b) {
  return a.position == b.position && a.orientation.coeffs() == b.orientation.coeffs();
}

Pose composed(const Pose& outer, const Pose& inner) {
  return {placed(inner.position, outer), (outer.orientation * inner.orientation).normalized()};
}

Pose inverse(const Pose& pose) {
  const Eigen::Quaterniond back = pose.orientation.conjugate();
  return {-(back * pose.position), back};
}

Pose between(const Pose& a, const Pose& b, double s) {
  return {(1 - s) * a.position + s * b.position, a.orientation.slerp(s, b.orientation)};
}

Edge placed(const Edge& edge, const Pose& pose) { return {placed(edge[0], pose), placed(edge[1], pose)}; }

Vec3 nearestOn(const Edge& edge, const Vec3& point) { return nearestOnSegment(edge[0], edge[1], point); }

Wrench seenFrom(const Pose& pose, const Wrench& wrench) {
  const Eigen::Quaterniond inverse = pose.orientation.conjugate();
  return {inverse * wrench.force, inverse * (wrench.torque - pose.position.cross(wrench.force))};
}

}  // namespace incision
