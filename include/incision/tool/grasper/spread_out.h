#pragma once

#include <vector>

#include "incision/base/vec.h"

namespace incision {

/// Up to `most` of the points, no two at one place, as far apart as they can be: after the first of them always the one
/// that is farthest from all before it (of equal ones the first), so that they are even at any count. Returns their
/// indices.
std::vector<int> spreadOut(const std::vector<Vec3>& points, std::size_t most);

}  // namespace incision
