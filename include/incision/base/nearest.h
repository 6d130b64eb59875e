#pragma once

#include <array>

#include "incision/base/vec.h"

namespace incision {

/// The point of the segment from a to b that is nearest to `point`; where they are one, that.
Vec3 nearestOnSegment(const Vec3& a, const Vec3& b, const Vec3& point);

/// The point of a triangle that is nearest to `point`.
Vec3 nearestOnTriangle(const std::array<Vec3, 3>& triangle, const Vec3& point);

}  // namespace incision
