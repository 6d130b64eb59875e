#pragma once

#include <geometry_msgs/Point.h>

#include <vector>

#include "incision/base/vec.h"

namespace incision {

/// Corners of triangles, three by three, of a capsule along z that is centred on the origin. `size` is that of the box
/// round it [m], of which the longest edge is along z.
std::vector<geometry_msgs::Point> capsulePoints(const Vec3& size);

}  // namespace incision
