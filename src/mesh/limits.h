#pragma once

#include <algorithm>
#include <cmath>

#include "incision/mesh/tet_mesh.h"

namespace incision {

/// Shortest length [m] that the longest edge of an element may have. Nothing below a picometre is a continuum, and
/// volumes and their products stay far from underflow.
inline constexpr double MIN_LENGTH = 1e-12;

/// An element is degenerate when six times its volume is below this fraction of its longest edge cubed. Rounding alone
/// makes a flat element's volume about 1e-16 of it; a needle a hundred thousand times as long as thick has 1e-10.
/// At 1e-12 the sign of the volume can be trusted and the element's shape matrix can still be inverted.
inline constexpr double DEGENERATE_FRACTION = 1e-12;

/// Whether the volume, of either sign, is too small for the edges, or the edges for anything.
inline bool isDegenerate(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const double longest_squared = std::max({(b - a).squaredNorm(), (c - a).squaredNorm(), (d - a).squaredNorm(),
                                           (c - b).squaredNorm(), (d - b).squaredNorm(), (d - c).squaredNorm()});
  if (longest_squared < MIN_LENGTH * MIN_LENGTH) return true;
  return std::abs(sixVolumes(a, b, c, d)) <= DEGENERATE_FRACTION * longest_squared * std::sqrt(longest_squared);
}

}  // namespace incision
