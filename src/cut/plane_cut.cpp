#include "incision/cut/plane_cut.h"

#include <cmath>

#include "incision/base/limits.h"

namespace incision {
namespace {

/// Shortest component of the tangent across the unit normal, of a unit tangent, that still gives a direction.
constexpr double MIN_ACROSS = 1e-6;

bool usable(const Vec3& v) { return v.allFinite() && v.cwiseAbs().maxCoeff() <= MAX_COORDINATE; }

bool isSize(double s) { return std::isfinite(s) && s >= 0 && s <= MAX_COORDINATE; }

}  // namespace

Vec3 PlaneCut::tangentInPlane() const {
  const Vec3 n = normal.stableNormalized(), t = tangent.stableNormalized();
  return t - t.dot(n) * n;
}

std::string whyInvalid(const PlaneCut& plane) {
  if (!usable(plane.point)) return "point: not finite or beyond 1e9 m";
  if (!usable(plane.normal)) return "normal: not finite or beyond 1e9";
  if (!usable(plane.tangent)) return "tangent: not finite or beyond 1e9";
  if (!isSize(plane.length)) return "length: not a finite number from 0 to 1e9 m";
  if (!isSize(plane.width)) return "width: not a finite number from 0 to 1e9 m";
  if (plane.normal.stableNorm() == 0) return "normal: zero";
  if (plane.bounded() && plane.tangentInPlane().norm() < MIN_ACROSS)
    return "tangent: zero or parallel to the normal, so length and width have no direction";
  return "";
}

}  // namespace incision
