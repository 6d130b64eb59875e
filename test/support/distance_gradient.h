#pragma once

#include <optional>

#include "incision/rigid/solid.h"

namespace incision::test {

/// The gradient of a solid's distance at a point, by differences over `h` [m] to either side; none where the normal has
/// a kink in between.
inline std::optional<Vec3> distanceGradient(const Solid& solid, const Vec3& p, double h) {
  Vec3 gradient;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 step = h * Vec3::Unit(axis);
    const SolidDistance more = solid.distanceTo(p + step), less = solid.distanceTo(p - step);
    if ((more.normal - less.normal).norm() >= 1e-3) return std::nullopt;
    gradient[axis] = (more.distance - less.distance) / (2 * h);
  }
  return gradient;
}

}  // namespace incision::test
