#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>

#include "incision/surface/surface.h"

namespace incision {

/// The surface as two lists of triangles, the skin and the cut faces, of the same points as long as the topology does
/// not change. One with no triangles is deleted. `x`: positions of the copies [m], finite.
visualization_msgs::MarkerArray toMarkers(const Surface& surface, const std::vector<Vec3>& x, const std::string& frame,
                                          const ros::Time& stamp);

}  // namespace incision
