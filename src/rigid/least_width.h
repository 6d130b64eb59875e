#pragma once

#include <functional>
#include <vector>

#include "incision/base/vec.h"

namespace incision {

/// Smallest distance of two parallel planes that hold a solid between them. `reach_along` gives the largest n·q of its
/// points q for a unit vector n, `likely` normals of the planes to begin with, beside those that lie all round.
double leastWidth(const std::function<double(const Vec3&)>& reach_along, const std::vector<Vec3>& likely);

}  // namespace incision
